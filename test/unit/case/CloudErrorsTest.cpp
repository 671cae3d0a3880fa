#include "case/Cloud.hpp"
#include "temporaryCase.hpp"
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <sys/stat.h>

namespace sph
{

namespace
{

// The header takes 6 lines: the count stands in line 7.
std::string header(const std::string& className, const std::string& format = "ascii")
{
    return "FoamFile\n{\nformat " + format + ";\nclass " + className + ";\nobject any;\n}\n";
}

const std::string threePositions = header("Cloud<passiveParticle>") + "3\n(\n(0 0 0) 0\n(1 0 0) 0\n(2 0 0) 0\n)\n";

std::string raw(const std::vector<double>& values)
{
    std::string text(values.size() * sizeof(double), '\0');
    std::memcpy(text.data(), values.data(), text.size());
    return text;
}

/// Messages of reading a cloud of three particles with this file as its field U.
std::string ofField(const std::string& text)
{
    const TemporaryCase c;
    c.write("0/lagrangian/sph/positions", threePositions);
    c.write("0/lagrangian/sph/U", text);
    Diagnostics diagnostics;
    readCloud(c.folder(), "0", "sph", diagnostics);
    return messages(diagnostics);
}

std::string ofPositions(const std::string& text)
{
    const TemporaryCase c;
    c.write("0/lagrangian/sph/positions", text);
    Diagnostics diagnostics;
    readCloud(c.folder(), "0", "sph", diagnostics);
    return messages(diagnostics);
}

/// Binary data has no telling what is found in it.
std::string start(const std::string& text, std::size_t length) { return text.substr(0, length); }

const std::string U = "0/lagrangian/sph/U", P = "0/lagrangian/sph/positions";

}

// Each test: a file with one mistake, and the exact words, with file and line, that the user reads.

TEST(CloudErrors, nameAMissingCloud)
{
    const TemporaryCase c;
    Diagnostics diagnostics;
    readCloud(c.folder(), "0", "sph", diagnostics);
    EXPECT_EQ(messages(diagnostics), P + ": cannot be read: No such file or directory");
}

TEST(CloudErrors, nameWhatIsWrongWithTheHeader)
{
    EXPECT_EQ(ofField(""), U + ":1: no FoamFile header");
    EXPECT_EQ(ofField("3(1 2 3)"), U + ":1: no FoamFile header");
    EXPECT_EQ(ofField("FoamFile\n{\nclass scalarField;\n}\n3{1}\n"), U + ":4: the FoamFile header has no \"format\"");
    EXPECT_EQ(ofField("FoamFile\n{\nformat ascii;\n}\n3{1}\n"), U + ":4: the FoamFile header has no \"class\"");
    EXPECT_EQ(ofField("FoamFile\n{\nformat ascii;\n"), U + ":4: the FoamFile header does not end");
    EXPECT_EQ(ofField("FoamFile\n{\nformat ascii\nclass scalarField;\n}\n"),
              U + ":3: FoamFile header: expected \"keyword value;\", found \"format ascii\"");
    EXPECT_EQ(ofField("FoamFile\n{\nformat asci;\n"),
              U + ":3: format \"asci\" is unknown. Did you mean \"ascii\"? Known formats: ascii, binary.");
    EXPECT_EQ(ofField("FoamFile\n{\nformat binary;\nclass scalarField;\nformat ascii;\n}\n3{1}\n"),
              U + ":5: FoamFile header: \"format\" is given twice");
    EXPECT_EQ(ofField("FoamFile\n{\nlocation \"0;\nobject \"p\";\n}\n3{1}\n"), U + ":3: the string does not end on its line");
    EXPECT_EQ(ofField("FoamFile\n{\narch \"MSB;label=32;scalar=64\";\n"),
              U + ":3: arch \"MSB;label=32;scalar=64\": big-endian data is not supported");
    EXPECT_EQ(ofField("FoamFile\n{\narch \"LSB;label=16;scalar=64\";\n"),
              U + ":3: arch \"LSB;label=16;scalar=64\": label must be 32 or 64");
}

TEST(CloudErrors, nameAWrongClass)
{
    EXPECT_EQ(ofField(header("vectorFeld") + "3{(0 0 0)}\n"),
              U + ":4: class \"vectorFeld\" is not a field of a cloud. Did you mean \"vectorField\"? "
                  "Known classes: labelField, scalarField, vectorField, symmTensorField, tensorField.");
    EXPECT_EQ(ofPositions(header("vectorField") + "3{(0 0 0)}\n"), P + ":4: class \"vectorField\" is not that of positions, Cloud<...>");
}

TEST(CloudErrors, nameUnequalLengths)
{
    EXPECT_EQ(ofField(header("scalarField") + "2\n(\n1\n2\n)\n"), U + ":7: field U has 2 values, positions has 3");
    EXPECT_EQ(ofField(header("scalarField") + "999999999999{1}\n"), U + ":7: field U has 999999999999 values, positions has 3");
    EXPECT_EQ(ofField(header("scalarField") + "(1 2)\n"), U + ":8: field U has 2 values, positions has 3");
    EXPECT_EQ(ofField(header("scalarField") + "3\n(\n1\n2\n)\n"), U + ":11: the list ends after 2 of 3 values");
    EXPECT_EQ(ofField(header("scalarField") + "3\n(\n1\n2\n3\n4\n)\n"), U + ":12: expected ) after 3 values, found \"4\"");
}

TEST(CloudErrors, nameATruncatedFile)
{
    EXPECT_EQ(ofField(header("scalarField")), U + ":7: expected the number of values, found the end of the file");
    EXPECT_EQ(ofField(header("scalarField") + "3\n"), U + ":8: expected ( and the values, found the end of the file");
    EXPECT_EQ(ofField(header("scalarField") + "3\n(\n1\n2\n"), U + ":11: the file is truncated: it ends after 2 of 3 values");
    EXPECT_EQ(ofField(header("vectorField") + "3\n(\n(0 0 0)\n(0 0"), U + ":10: the file is truncated in the value of particle 1");
    EXPECT_EQ(ofField(header("vectorField") + "3\n(\n(0 0 0)\n(0 0 0"), U + ":10: the file is truncated in the value of particle 1");
    EXPECT_EQ(ofPositions(header("Cloud<p>") + "9000000000000000000\n(\n(0 0 0) 0\n"),
              P + ":10: the file is truncated: it ends after 1 of 9000000000000000000 values");
    EXPECT_EQ(ofField(header("scalarField", "binary") + "3\n(" + raw({1, 2})),
              U + ": the file is truncated: 3 values need 24 bytes, 16 are there");
    EXPECT_EQ(ofField(header("scalarField", "binary") + "3\n(" + raw({1, 2, 3})),
              U + ": expected ) right after 3 values, found the end of the file");
    EXPECT_EQ(ofPositions(header("Cloud<p>", "binary") + "9000000000000000000\n(\n"),
              P + ": the file is truncated: 9000000000000000000 values need 270000000000000000000 bytes, 1 are there");
}

TEST(CloudErrors, nameWhatFollowsTheList)
{
    EXPECT_EQ(ofField(header("scalarField") + "3{1}\n\n4{2}\n"), U + ":9: unexpected \"4{2}\" after the list");
    EXPECT_EQ(ofField(header("scalarField", "binary") + "3\n(" + raw({1, 2, 3}) + ")x"), U + ": unexpected \"x\" after the list");
    EXPECT_EQ(start(ofField(header("scalarField", "binary") + "3\n(" + raw({1, 2, 3, 4}) + ")"), U.size() + 33),
              U + ": expected ) right after 3 values");
}

// A longer list of zeros is NUL bytes behind the third value, and so is the end of a file that a crash has cut off: they are no blanks.
TEST(CloudErrors, nameBytesBehindABinaryList)
{
    const auto text = header("scalarField", "binary") + "3\n(" + raw({1, 2, 3});
    EXPECT_EQ(ofField(text + raw({0, 0}) + ")\n"), U + ": expected ) right after 3 values, found \"" + std::string(16, '?') + ")\"");
    EXPECT_EQ(ofField(text + " )\n"), U + ": expected ) right after 3 values, found \")\"");
    EXPECT_EQ(ofField(text + ")" + std::string(3, '\0')), U + ": unexpected \"" + std::string(3, '?') + "\" after the list");
    EXPECT_EQ(ofField(text + ") // done \n"), "");
    EXPECT_EQ(ofField(header("scalarField") + std::string(1, '\0') + "3{1}\n"), U + ":7: expected the number of values, found \"?3{1}\"");
}

// Of a field that the reader knows the class is told, with what it should be, before a value is looked at.
TEST(CloudErrors, nameAClassThatIsAnotherFields)
{
    const auto said = [](const std::string& className, FieldClass wanted)
    {
        const TemporaryCase c;
        c.write("0/lagrangian/sph/positions", threePositions);
        c.write("0/lagrangian/sph/U", header(className) + "3{(0 0 0 0 0 0)}\n");
        Diagnostics diagnostics;
        readCloud(c.folder(), "0", "sph", diagnostics, {{"U", wanted}});
        return messages(diagnostics);
    };
    EXPECT_EQ(said("symmTensorField", FieldClass::symmTensor), "");
    EXPECT_EQ(said("symmTensorField", FieldClass::vector), U + ":4: class \"symmTensorField\" is not that of the field U, vectorField");
    EXPECT_EQ(said("scalarField", FieldClass::vector), U + ":4: class \"scalarField\" is not that of the field U, vectorField");
    EXPECT_EQ(said("vectorField", FieldClass::label), U + ":4: class \"vectorField\" is not that of the field U, labelField");
}

// A phase is the number of one: whole, and not more than there are.
TEST(CloudErrors, nameAPhaseThatIsNone)
{
    const auto said = [](double phase)
    {
        Cloud cloud;
        cloud.folder = "0/lagrangian/sph";
        cloud.x = cloud.y = cloud.z = {1, 2};
        cloud.fields["phase"] = {FieldClass::label, {{1, phase}}};
        try
        {
            EXPECT_EQ(phasesOf(cloud, 2), (std::vector<int>{1, int(phase)}));
        }
        catch (const CaseError& e)
        {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_EQ(said(0), "");
    for (const char* phase : {"2", "-1", "0.7", "1e+300"})
        EXPECT_EQ(said(std::stod(phase)), std::string("0/lagrangian/sph/phase: particle 1 at (2 2 2) has phase ") + phase +
                                              ", but constant/phaseProperties lists 2 phases, 0 to 1");
}

TEST(CloudErrors, nameTheParticleThatIsNotFinite)
{
    EXPECT_EQ(ofField(header("scalarField") + "3\n(\n1\nnan\n3\n)\n"), U + ":10: the value of particle 1 is not finite: nan");
    EXPECT_EQ(ofField(header("vectorField") + "3\n(\n(0 0 0)\n(0 0 0)\n(0 -inf 0)\n)\n"),
              U + ":11: the value of particle 2 is not finite: -inf");
    EXPECT_EQ(ofField(header("scalarField") + "3\n(\n1\n1e999\n3\n)\n"), U + ":10: the value of particle 1 is not finite: inf");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(ofField(header("scalarField", "binary") + "3\n(" + raw({1, 2, nan}) + ")\n"),
              U + ": the value of particle 2 is not finite: nan");
    EXPECT_EQ(ofPositions(header("Cloud<p>") + "1\n(\n(0 nan 0) 0\n)\n"), P + ":9: the value of particle 0 is not finite: nan");
}

TEST(CloudErrors, nameWhatIsNoValue)
{
    EXPECT_EQ(ofField(header("scalarField") + "3\n(\n1\ntwo\n3\n)\n"), U + ":10: expected a number for particle 1, found \"two\"");
    EXPECT_EQ(ofField(header("labelField") + "3\n(\n1\n2.5\n3\n)\n"), U + ":10: expected an integer for particle 1, found \"2.5\"");
    EXPECT_EQ(ofField(header("vectorField") + "3\n(\n1\n2\n3\n)\n"), U + ":9: expected \"(\" of the 3 numbers of particle 0, found \"1\"");
    EXPECT_EQ(ofField(header("vectorField") + "3\n(\n(0 0 0 0)\n"), U + ":9: expected \")\" of the 3 numbers of particle 0, found \"0)\"");
    EXPECT_EQ(ofField(header("scalarField", "binary") + "3{1}\n"), U + ":7: a compact list N{value} cannot be in a binary file");
    EXPECT_EQ(ofPositions(header("Cloud<p>") + "2{(0 0 0) 0}\n"), P + ":7: positions cannot be a compact list");
    EXPECT_EQ(ofPositions(header("Cloud<p>") + "1\n(\n(0 0 0)\n)\n"),
              P + ":10: expected the cell label after the position of particle 0, found \")\"");
    EXPECT_EQ(ofField("/* not closed"), U + ":1: the comment /* does not end");
}

// Two numbers with nothing between them, as where a byte is damaged or lost, are not read as two, nor as a part of one.
TEST(CloudErrors, nameNumbersThatRunIntoOneAnother)
{
    for (const std::string run : {"1-2", "1.5.5", "1+2", "1x", "1,2"})
    {
        EXPECT_EQ(ofField(header("scalarField") + "3\n(\n1\n" + run + "\n)\n"),
                  U + ":10: expected a number for particle 1, found \"" + run + "\"");
        EXPECT_EQ(ofField(header("labelField") + "3\n(\n1\n" + run + "\n)\n"),
                  U + ":10: expected an integer for particle 1, found \"" + run + "\"");
        EXPECT_EQ(ofField(header("scalarField") + "3{" + run + "}\n"), U + ":7: expected a number for particle 0, found \"" + run + "}\"");
    }
    EXPECT_EQ(ofPositions(header("Cloud<p>") + "1\n(\n(0 0-1) 0\n)\n"), P + ":9: expected a number for particle 0, found \"0-1)\"");
}

// A field that was written and is no longer there is not one that was never given; particles that are fewer or more are others.
TEST(CloudErrors, nameFieldsThatAreLost)
{
    const TemporaryCase c;
    const std::vector<double> x{0, 1, 2}, p{5, 6, 7};
    const FieldView positions{"positions", FieldClass::vector, {x.data(), nullptr, nullptr}};
    writeCloud(c.folder() / "1", "sph", 3, positions, {{"p", FieldClass::scalar, {p.data()}}, {"q", FieldClass::scalar, {p.data()}}}, {});
    const auto said = [&]
    {
        Diagnostics diagnostics;
        readCloud(c.folder(), "1", "sph", diagnostics);
        return messages(diagnostics);
    };
    const std::string properties = "1/uniform/lagrangian/sph/cloudProperties";
    EXPECT_EQ(said(), "");
    std::filesystem::remove(c.folder() / "1/lagrangian/sph/q");
    EXPECT_EQ(said(), "1/lagrangian/sph/q: is missing, and was written with the others: see `fields` in " + properties +
                          ", and leave it out there if it is not meant to be read");
    auto text = c.read(properties);
    c.write(properties, text.replace(text.find("(p q)"), 5, "(p)"));
    EXPECT_EQ(said(), "");
    c.write(properties, text.replace(text.find("3;"), 2, "4;"));
    EXPECT_EQ(said(), "1/lagrangian/sph/positions: has 3 particles, and " + properties + " says 4");
    c.write(properties, "geometry positions;\n"); // as another program may write it
    EXPECT_EQ(said(), "");
    c.write(properties, "geometry positions\n{");
    EXPECT_NE(said().find(properties + ":"), std::string::npos) << said();
    std::filesystem::remove(c.folder() / properties);
    EXPECT_EQ(said(), "");
}

// A pipe without a writer, a device without an end.
TEST(CloudErrors, nameFilesThatAreNone)
{
    const TemporaryCase c;
    c.write("0/lagrangian/sph/positions", threePositions);
    ASSERT_EQ(::mkfifo((c.folder() / U).c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", c.folder() / "0/lagrangian/sph/V");
    Diagnostics diagnostics;
    readCloud(c.folder(), "0", "sph", diagnostics);
    const std::string none = ": cannot be read: it is a device or a pipe: only regular files are read\n";
    EXPECT_EQ(messages(diagnostics), U + none + "0/lagrangian/sph/V" + none + "2 errors");
}

// The raw layout without inner parentheses, which other programs read as no particles without a word.
TEST(CloudErrors, nameBinaryPositionsWithoutParentheses)
{
    const auto said = ofPositions(header("Cloud<p>", "binary") + "1\n(\n" + raw({0.1, 0.2, 0.3}) + std::string(10, '\0') + ")\n");
    EXPECT_EQ(start(said, P.size() + 46), P + ": expected ( before the position of particle 0");
}

TEST(CloudErrors, reportEveryFieldAtOnce)
{
    const TemporaryCase c;
    c.write("0/lagrangian/sph/positions", threePositions);
    c.write("0/lagrangian/sph/rho", header("scalarField") + "2{1}\n");
    c.write("0/lagrangian/sph/p", header("scalarField") + "4{1}\n");
    c.write("0/lagrangian/sph/T.gz", "");
    Diagnostics diagnostics;
    readCloud(c.folder(), "0", "sph", diagnostics);
    EXPECT_EQ(messages(diagnostics), "0/lagrangian/sph/T.gz: compressed files are not read: gunzip it\n"
                                     "0/lagrangian/sph/p:7: field p has 4 values, positions has 3\n"
                                     "0/lagrangian/sph/rho:7: field rho has 2 values, positions has 3\n"
                                     "3 errors");
}

}
