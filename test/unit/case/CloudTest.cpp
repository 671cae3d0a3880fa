#include "case/Cloud.hpp"
#include "temporaryCase.hpp"
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace sph
{

namespace
{

using limits = std::numeric_limits<double>;

const std::vector<double> x{0.1, 1.0 / 3, -1e300}, y{0, -0.0, limits::denorm_min()}, z{1e-5, limits::max(), 1234567890123.25};
const std::vector<double> phase{0, 1, -7}, rho{1000, 1000.0000000000001, 0.1 + 0.2}, same{2.5, 2.5, 2.5};

FieldView positionsView() { return {"positions", FieldClass::vector, {x.data(), y.data(), z.data()}}; }

std::vector<FieldView> fieldViews()
{
    return {{"phase", FieldClass::label, {phase.data()}},
            {"rho", FieldClass::scalar, {rho.data()}},
            {"same", FieldClass::scalar, {same.data()}},
            {"U", FieldClass::vector, {x.data(), y.data(), nullptr}},
            {"sigma", FieldClass::symmTensor, {x.data(), y.data(), z.data(), rho.data(), phase.data(), same.data()}},
            fieldView("planeStrain", valueType<PlaneStrainStress>, {x.data(), y.data(), z.data(), rho.data()}),
            fieldView("gradU", valueType<Tensor<2>>, {x.data(), y.data(), z.data(), rho.data()}),
            {"gradW",
             FieldClass::tensor,
             {x.data(), y.data(), z.data(), rho.data(), phase.data(), same.data(), z.data(), y.data(), x.data()}}};
}

void expectSameBits(const std::vector<double>& a, const std::vector<double>& b)
{
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(std::bit_cast<std::uint64_t>(a[i]), std::bit_cast<std::uint64_t>(b[i])) << i;
}

void expectRoundTrip(WriteFormat format)
{
    const TemporaryCase c;
    writeCloud(c.folder() / "0.5", "sph", 3, positionsView(), fieldViews(), {format, 0});
    Diagnostics diagnostics;
    const auto cloud = readCloud(c.folder(), "0.5", "sph", diagnostics);
    EXPECT_EQ(messages(diagnostics), "");
    expectSameBits(cloud.x, x);
    expectSameBits(cloud.y, y);
    expectSameBits(cloud.z, z);
    ASSERT_EQ(cloud.fields.size(), 8u);
    EXPECT_EQ(cloud.fields.at("phase").type, FieldClass::label);
    EXPECT_EQ(cloud.fields.at("sigma").type, FieldClass::symmTensor);
    expectSameBits(cloud.fields.at("phase").component[0], phase);
    expectSameBits(cloud.fields.at("rho").component[0], rho);
    expectSameBits(cloud.fields.at("same").component[0], same);
    expectSameBits(cloud.fields.at("U").component[2], {0, 0, 0});
    expectSameBits(cloud.fields.at("sigma").component[3], rho);
    const std::vector<double> none(3, 0.0);
    EXPECT_EQ(cloud.fields.at("planeStrain").type, FieldClass::symmTensor);
    for (int k = 0; const auto* values : {&x, &y, &none, &z, &none, &rho})
        expectSameBits(cloud.fields.at("planeStrain").component[k++], *values);
    EXPECT_EQ(cloud.fields.at("gradU").type, FieldClass::tensor);
    for (int k = 0; const auto* values : {&x, &y, &none, &z, &rho, &none, &none, &none, &none})
        expectSameBits(cloud.fields.at("gradU").component[k++], *values);
    for (int k = 0; const auto* values : {&x, &y, &z, &rho, &phase, &same, &z, &y, &x})
        expectSameBits(cloud.fields.at("gradW").component[k++], *values);
}

std::string bytes(const auto&... values)
{
    std::string all;
    const auto add = [&all](const auto& value)
    {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        all.append(raw, sizeof value);
    };
    (add(values), ...);
    return all;
}

std::string header(const std::string& format, const std::string& className, const std::string& object)
{
    return "FoamFile\n{\n    version     2.0;\n    format      " + format + ";\n" +
           (format == "binary" ? "    arch        \"LSB;label=32;scalar=64\";\n" : "") + "    class       " + className +
           ";\n    location    \"1/lagrangian/sph\";\n    object      " + object + ";\n}\n\n";
}

}

// Whatever a double can be comes back to the last bit from ascii without a precision, and from binary: exact, hence no tolerance.
TEST(Cloud, comesBackToTheLastBitFromAscii) { expectRoundTrip(WriteFormat::ascii); }
TEST(Cloud, comesBackToTheLastBitFromBinary) { expectRoundTrip(WriteFormat::binary); }

// The bytes of both formats, written here by hand after files that OpenFOAM wrote itself.
TEST(Cloud, hasOpenFoamsBytesInAscii)
{
    const TemporaryCase c;
    const std::vector<double> px{0.1, 0.3}, py{0.5, 0.5}, type{0, 1}, p{1e-5, 1e5};
    writeCloud(c.folder() / "1", "sph", 2, {"positions", FieldClass::vector, {px.data(), py.data(), nullptr}},
               {{"type", FieldClass::label, {type.data()}},
                {"p", FieldClass::scalar, {p.data()}},
                {"half", FieldClass::scalar, {py.data()}},
                {"U", FieldClass::vector, {py.data(), py.data(), py.data()}}},
               {WriteFormat::ascii, 0});
    EXPECT_EQ(c.read("1/lagrangian/sph/positions"),
              header("ascii", "Cloud<passiveParticle>", "positions") + "2\n(\n(0.1 0.5 0) 0\n(0.3 0.5 0) 0\n)\n");
    EXPECT_EQ(c.read("1/lagrangian/sph/type"), header("ascii", "labelField", "type") + "2\n(\n0\n1\n)\n");
    EXPECT_EQ(c.read("1/lagrangian/sph/p"), header("ascii", "scalarField", "p") + "2\n(\n1e-05\n1e+05\n)\n");
    EXPECT_EQ(c.read("1/lagrangian/sph/half"), header("ascii", "scalarField", "half") + "2{0.5}\n");
    EXPECT_EQ(c.read("1/lagrangian/sph/U"), header("ascii", "vectorField", "U") + "2{(0.5 0.5 0.5)}\n");
    EXPECT_EQ(c.read("1/uniform/lagrangian/sph/cloudProperties"),
              "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       dictionary;\n"
              "    location    \"1/uniform/lagrangian/sph\";\n    object      cloudProperties;\n}\n\n"
              "geometry        positions;\n\nprocessor0\n{\n    particleCount   2;\n}\n\nfields          (type p half U);\n");
}

TEST(Cloud, hasOpenFoamsBytesInBinary)
{
    const TemporaryCase c;
    const std::vector<double> px{0.1, 0.3}, py{0.5, 0.5}, type{0, 1};
    writeCloud(c.folder() / "1.partial", "sph", 2, {"positions", FieldClass::vector, {px.data(), py.data(), nullptr}},
               {{"type", FieldClass::label, {type.data()}}, {"p", FieldClass::scalar, {py.data()}}}, {WriteFormat::binary, 0});
    const std::int32_t zero = 0, one = 1;
    EXPECT_EQ(c.read("1.partial/lagrangian/sph/positions"), header("binary", "Cloud<passiveParticle>", "positions") + "2\n(\n(" +
                                                                bytes(0.1, 0.5, 0.0, zero) + ")\n(" + bytes(0.3, 0.5, 0.0, zero) +
                                                                ")\n)\n");
    EXPECT_EQ(c.read("1.partial/lagrangian/sph/type"), header("binary", "labelField", "type") + "2\n(" + bytes(zero, one) + ")\n");
    EXPECT_EQ(c.read("1.partial/lagrangian/sph/p"), header("binary", "scalarField", "p") + "2\n(" + bytes(0.5, 0.5) + ")\n");
}

// writePrecision is that of OpenFOAM: significant digits.
TEST(Cloud, roundsToTheGivenPrecision)
{
    const TemporaryCase c;
    const std::vector<double> third{1.0 / 3, 2e6 / 3};
    writeCloud(c.folder() / "1", "sph", 2, {"positions", FieldClass::vector, {third.data(), nullptr, nullptr}},
               {{"p", FieldClass::scalar, {third.data()}}}, {WriteFormat::ascii, 6});
    EXPECT_EQ(c.read("1/lagrangian/sph/p"), header("ascii", "scalarField", "p") + "2\n(\n0.333333\n666667\n)\n");
}

TEST(Cloud, ofNoParticlesIsWrittenAndRead)
{
    for (const auto format : {WriteFormat::ascii, WriteFormat::binary})
    {
        const TemporaryCase c;
        EXPECT_FALSE(hasCloud(c.folder(), "0", "sph"));
        writeCloud(c.folder() / "0", "sph", 0, {"positions", FieldClass::vector, {nullptr, nullptr, nullptr}},
                   {{"rho", FieldClass::scalar, {nullptr}}}, {format, 0});
        EXPECT_TRUE(hasCloud(c.folder(), "0", "sph"));
        Diagnostics diagnostics;
        const auto cloud = readCloud(c.folder(), "0", "sph", diagnostics);
        EXPECT_EQ(messages(diagnostics), "");
        EXPECT_EQ(cloud.size(), 0u);
        EXPECT_EQ(cloud.fields.size(), 1u);
    }
}

// Builds of OpenFOAM with 64-bit labels and with single precision write these.
TEST(Cloud, isReadWithOtherWidthsOfLabelsAndScalars)
{
    const TemporaryCase c;
    const auto widths = [](std::string text, const std::string& arch)
    { return text.replace(text.find("LSB;label=32;scalar=64"), 22, arch); };
    const std::int64_t zero = 0, big = 1LL << 40;
    c.write("1/lagrangian/sph/positions", widths(header("binary", "Cloud<basicParticle>", "positions"), "LSB;label=64;scalar=32") +
                                              "2\n(\n(" + bytes(0.5f, 1.5f, 2.5f, zero) + ")\n(" + bytes(3.f, 4.f, 5.f, zero) + ")\n)\n");
    c.write("1/lagrangian/sph/id",
            widths(header("binary", "labelField", "id"), "LSB;label=64;scalar=64") + "2\n(" + bytes(zero, big) + ")");
    c.write("1/lagrangian/sph/T",
            widths(header("binary", "scalarField", "T"), "LSB;label=32;scalar=32") + "2\n(" + bytes(0.25f, -8.f) + ")");
    Diagnostics diagnostics;
    const auto cloud = readCloud(c.folder(), "1", "sph", diagnostics);
    EXPECT_EQ(messages(diagnostics), "");
    expectSameBits(cloud.y, {1.5, 4});
    expectSameBits(cloud.fields.at("id").component[0], {0, 1099511627776.0});
    expectSameBits(cloud.fields.at("T").component[0], {0.25, -8});
}

// Layouts that other programs and people write: comments, one line, no count, an empty binary list without parentheses, a plus sign.
TEST(Cloud, isReadInTheLayoutsOfOthers)
{
    const TemporaryCase c;
    const auto place = header("ascii", "Cloud<passiveParticle>", "positions");
    c.write("1/lagrangian/sph/positions", "/*---*\\\n C++ \\*---*/\n" + place + "// **** //\n2((0 +1 .5) -1 (1. 2 3e0) 7)\n// **** //\n");
    c.write("1/lagrangian/sph/p", header("ascii", "scalarField", "p") + "(1 2)");
    c.write("1/lagrangian/sph/phase", header("ascii", "labelField", "phase") + "2{3}\n\n\n// end");
    c.write("1/lagrangian/sph/coordinates", "made by OpenFOAM's tools beside the positions");
    c.write("2/lagrangian/sph/positions", header("binary", "Cloud<passiveParticle>", "positions") + "0\n");
    Diagnostics diagnostics;
    const auto cloud = readCloud(c.folder(), "1", "sph", diagnostics);
    EXPECT_EQ(readCloud(c.folder(), "2", "sph", diagnostics).size(), 0u);
    EXPECT_EQ(messages(diagnostics), "");
    expectSameBits(cloud.x, {0, 1});
    expectSameBits(cloud.y, {1, 2});
    expectSameBits(cloud.z, {0.5, 3});
    expectSameBits(cloud.fields.at("p").component[0], {1, 2});
    expectSameBits(cloud.fields.at("phase").component[0], {3, 3});
}

/// The slices of a cloud that so many ranks read, behind one another, are the whole.
void expectSlicesOf(const TemporaryCase& c, const std::string& time)
{
    Diagnostics diagnostics;
    const auto whole = readCloud(c.folder(), time, "sph", diagnostics);
    for (const std::size_t parts : {1, 2, 3, 7})
    {
        Cloud joined;
        const auto add = [](std::vector<double>& all, const std::vector<double>& part) { all.insert(all.end(), part.begin(), part.end()); };
        for (std::size_t part = 0; part < parts; ++part)
        {
            const auto slice = readCloud(c.folder(), time, "sph", diagnostics, {}, {part, parts});
            EXPECT_EQ(slice.before, joined.size());
            EXPECT_LE(slice.size(), whole.size() / parts + 1);
            add(joined.x, slice.x);
            add(joined.y, slice.y);
            add(joined.z, slice.z);
            for (const auto& [name, field] : slice.fields)
            {
                auto& to = joined.fields[name].component;
                to.resize(field.component.size());
                for (std::size_t k = 0; k < to.size(); ++k)
                {
                    EXPECT_EQ(field.component[k].size(), slice.size()) << name;
                    add(to[k], field.component[k]);
                }
            }
        }
        EXPECT_EQ(messages(diagnostics), "") << parts;
        expectSameBits(joined.x, whole.x);
        expectSameBits(joined.y, whole.y);
        expectSameBits(joined.z, whole.z);
        ASSERT_EQ(joined.fields.size(), whole.fields.size());
        for (const auto& [name, field] : whole.fields)
            for (std::size_t k = 0; k < field.component.size(); ++k) expectSameBits(joined.fields[name].component[k], field.component[k]);
    }
}

// In both formats, with compact lists, lists that do not say how long they are, and binary positions with white space of any length between them.
TEST(Cloud, isTheSumOfItsSlices)
{
    const TemporaryCase c;
    for (const auto format : {WriteFormat::ascii, WriteFormat::binary})
    {
        writeCloud(c.folder() / "1", "sph", 3, positionsView(), fieldViews(), {format, 0});
        expectSlicesOf(c, "1");
    }
    c.write("2/lagrangian/sph/positions", header("ascii", "Cloud<passiveParticle>", "positions") + "((0 1 2) 0 (3 4 5) 0 (6 7 8) 0)");
    c.write("2/lagrangian/sph/p", header("ascii", "scalarField", "p") + "(1 2 3)");
    expectSlicesOf(c, "2");
    const std::int32_t cell = 0;
    for (const std::string between : {"", "\n", " \n\n"})
    {
        const auto of = [&](double x) { return "(" + bytes(x, 2 * x, 3 * x, cell) + ")"; };
        c.write("3/lagrangian/sph/positions", header("binary", "Cloud<passiveParticle>", "positions") + "4\n(\n" + of(1) + "\n" + of(2) +
                                                  between + of(3) + between + of(4) + "\n)\n");
        expectSlicesOf(c, "3");
    }
}

// A slice of a binary file names what is wrong with its own particles, by their numbers in the file, and with the length of the whole.
TEST(Cloud, isCheckedSliceBySlice)
{
    const TemporaryCase c;
    const std::vector<double> bad{1, 2, std::nan("")};
    writeCloud(c.folder() / "1", "sph", 3, positionsView(), {{"p", FieldClass::scalar, {bad.data()}}}, {});
    const auto said = [&](const Slice& slice)
    {
        Diagnostics diagnostics;
        readCloud(c.folder(), "1", "sph", diagnostics, {}, slice);
        return messages(diagnostics);
    };
    const std::string p = "1/lagrangian/sph/p";
    EXPECT_EQ(said({0, 3}), "");
    EXPECT_EQ(said({2, 3}), p + ": the value of particle 2 is not finite: nan");
    const auto text = c.read(p);
    c.write(p, text.substr(0, text.size() - 8));
    for (const std::size_t part : {0, 1, 2})
        EXPECT_EQ(said({part, 3}), p + ": the file is truncated: 3 values need 24 bytes, 18 are there");
    c.write(p, text + "1");
    EXPECT_EQ(said({0, 3}), p + ": unexpected \"1\" after the list");
}

// A disk that takes nothing: the file and the reason are named, whichever format.
TEST(Cloud, onAFullDiskIsAnError)
{
    const TemporaryCase c;
    std::filesystem::create_directories(c.folder() / "1/lagrangian/sph");
    std::filesystem::create_symlink("/dev/full", c.folder() / "1/lagrangian/sph/rho");
    for (const auto format : {WriteFormat::ascii, WriteFormat::binary})
        EXPECT_EQ(messageOf(
                      [&] {
                          writeCloud(c.folder() / "1", "sph", 3, positionsView(), fieldViews(), {format, 0});
                      }),
                  (c.folder() / "1/lagrangian/sph/rho").string() + ": cannot be written: No space left on device");
}

TEST(Cloud, refusesALabelThatIsNone)
{
    const TemporaryCase c;
    const std::vector<double> big{0, 0, 3e9};
    EXPECT_EQ(messageOf(
                  [&] {
                      writeCloud(c.folder() / "1", "sph", 3, positionsView(), {{"id", FieldClass::label, {big.data()}}}, {});
                  }),
              "field id: 3000000000 of particle 2 is not a label");
}

// The corners in the order that the faces name them; z of a flat scene gets half of the longest extent to each side.
TEST(BoundingMesh, isOneHexahedronAroundAll)
{
    const TemporaryCase c;
    writeBoundingMesh(c.folder(), {-1, 0, 0}, {1, 0.5, 0});
    const auto points = c.read("constant/polyMesh/points");
    EXPECT_EQ(points.substr(points.find("8\n")),
              "8\n(\n(-1 0 -1)\n(1 0 -1)\n(-1 0.5 -1)\n(1 0.5 -1)\n(-1 0 1)\n(1 0 1)\n(-1 0.5 1)\n(1 0.5 1)\n)\n");
    for (const auto* file : {"faces", "owner", "neighbour", "boundary"}) EXPECT_TRUE(c.has(std::string("constant/polyMesh/") + file));
    EXPECT_TRUE(c.has(c.folder().filename().string() + ".foam"));
}

// A million particles in a fraction of a second, the scale at which operators per number would take several: the bound is ten times
// what one core of a busy machine needs.
TEST(Cloud, ofAMillionParticlesIsFast)
{
    const TemporaryCase c;
    const std::size_t n = 1000000;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<double> values(n);
    for (auto& value : values) value = uniform(random);
    const FieldView view{"positions", FieldClass::vector, {values.data(), values.data(), values.data()}};
    for (const auto format : {WriteFormat::ascii, WriteFormat::binary})
    {
        const auto start = std::chrono::steady_clock::now();
        writeCloud(c.folder() / "1", "sph", n, view, {}, {format, 0});
        const auto written = std::chrono::steady_clock::now();
        Diagnostics diagnostics;
        const auto cloud = readCloud(c.folder(), "1", "sph", diagnostics);
        const auto read = std::chrono::steady_clock::now();
        ASSERT_EQ(messages(diagnostics), "");
        EXPECT_TRUE(cloud.z == values);
        const auto seconds = [](auto a, auto b) { return std::chrono::duration<double>(b - a).count(); };
        const std::string name = format == WriteFormat::ascii ? "ascii" : "binary";
        RecordProperty(name + "Write_s", std::to_string(seconds(start, written)));
        RecordProperty(name + "Read_s", std::to_string(seconds(written, read)));
        EXPECT_LT(seconds(start, read), 10.0);
    }
}

}
