/// Field files and time folders damaged at random: reading ends, throws nothing, and what it accepts is what stands in the file, to the last bit,
/// by a second reading that knows no more of a file than its brackets and numbers.
#include "Mutator.hpp"
#include "case/Cloud.hpp"
#include "case/RunTime.hpp"
#include "smallCases.hpp"
#include <cmath>
#include <cstring>
#include <limits>

namespace sph::test
{
namespace
{

constexpr std::size_t particles = 5;

struct Fields
{
    std::vector<double> a{0.1, -2.5e-7, 3, 1e300, 5e-324}, b{1, 2, 3, 4, 5}, same{7.25, 7.25, 7.25, 7.25, 7.25}, label{0, 1, 0, 2, 1};
};

void writeTime(const std::filesystem::path& folder, WriteFormat format)
{
    const Fields f;
    const auto *a = f.a.data(), *b = f.b.data();
    writeCloud(folder, "sph", particles, {"positions", FieldClass::vector, {a, b, nullptr}},
               {{"U", FieldClass::vector, {b, a, nullptr}},
                {"p", FieldClass::scalar, {a}},
                {"m", FieldClass::scalar, {f.same.data()}},
                {"phase", FieldClass::label, {f.label.data()}},
                {"sigma", FieldClass::symmTensor, {a, b, a, b, a, b}}},
               {format, 0});
}

/// The numbers of the text behind a header, comments apart: N ( .. ) without N, N { .. } repeated. Not a number where a word is none.
std::vector<double> numbersIn(const std::string& list)
{
    auto text = list;
    for (auto at = text.find('/'); at != text.npos && at + 1 < text.size(); at = text.find('/', at + 1))
        if (const bool block = text[at + 1] == '*'; block || text[at + 1] == '/')
        {
            const auto end = block ? text.find("*/", at + 2) : text.find('\n', at);
            text.replace(at, (end == text.npos ? text.size() : end + (block ? 2 : 0)) - at, " ");
        }
    const auto compact = text.find('{');
    const bool counted = text.find_first_not_of(" \t\r\n\v\f") != text.find('(');
    for (auto& c : text)
        if (std::strchr("(){}", c) && c) c = ' ';
    std::vector<double> all;
    for (const char* at = text.c_str();;)
    {
        while (*at && std::isspace(static_cast<unsigned char>(*at))) ++at;
        if (!*at) break;
        char* end = nullptr;
        double value = std::strtod(at, &end);
        if (end == at || !(std::isspace(static_cast<unsigned char>(*end)) || !*end)) value = std::numeric_limits<double>::quiet_NaN();
        while (*end && !std::isspace(static_cast<unsigned char>(*end))) ++end;
        all.push_back(value);
        at = end;
    }
    if (counted && !all.empty())
    {
        const auto n = all.front();
        all.erase(all.begin());
        if (n != double(particles)) return {};
        if (compact != text.npos)
            for (std::size_t k = all.size(), one = all.size(); k < particles * one; ++k) all.push_back(all[k - one]);
    }
    return all;
}

/// Values in the order of a file; of positions with the cell behind each, 0.
std::vector<double> inOrder(const std::vector<const std::vector<double>*>& component, bool cells)
{
    std::vector<double> all;
    for (std::size_t i = 0; i < component[0]->size(); ++i)
    {
        for (const auto* values : component) all.push_back((*values)[i]);
        if (cells) all.push_back(0);
    }
    return all;
}

bool sameBits(const std::vector<double>& a, const std::vector<double>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// Each may be the brace that ends the header, where a damaged one has several.
bool areNumbers(const std::string& file, const std::vector<double>& values, bool isPositions)
{
    int tried = 0;
    for (auto brace = file.find('}'); brace != file.npos && ++tried < 50; brace = file.find('}', brace + 1))
    {
        auto found = numbersIn(file.substr(brace + 1));
        if (isPositions)
            for (std::size_t i = 3; i < found.size(); i += 4) found[i] = 0;
        if (sameBits(values, found)) return true;
    }
    return false;
}

/// Whether the file holds the bytes of these values; positions are looked for each alone, because the cells stand between them.
bool areBytes(const std::string& file, const std::vector<double>& values, bool isPositions, bool isLabel)
{
    std::string bytes;
    for (const double value : values)
    {
        const auto label = std::int32_t(isLabel ? value : 0);
        bytes.append(isLabel ? reinterpret_cast<const char*>(&label) : reinterpret_cast<const char*>(&value),
                     isLabel ? sizeof label : sizeof value);
        if (isPositions && file.find(bytes.substr(bytes.size() - sizeof value)) == file.npos) return false;
    }
    return isPositions || file.find(bytes) != file.npos;
}

void expectRead(const std::string& file, const std::vector<const std::vector<double>*>& component, bool isPositions, bool isLabel)
{
    const auto values = inOrder(component, isPositions);
    EXPECT_TRUE(areNumbers(file, values, isPositions) || areBytes(file, values, isPositions, isLabel)) << file;
}

void expectRead(const TestCase& c, const std::string& time, const Cloud& cloud)
{
    const auto folder = time + "/lagrangian/sph/";
    expectRead(c.read(folder + "positions"), {&cloud.x, &cloud.y, &cloud.z}, true, false);
    for (const auto& [name, field] : cloud.fields)
    {
        const auto file = c.read(folder + name);
        if (file.find("label=64") != file.npos || file.find("scalar=32") != file.npos) continue; // of other widths: nothing to compare with
        std::vector<const std::vector<double>*> component;
        for (const auto& values : field.component) component.push_back(&values);
        SCOPED_TRACE(name);
        expectRead(file, component, false, field.type == FieldClass::label);
    }
}

/// Slices of a cloud are accepted, all of them, where the whole is, and are what it is made of.
void expectSlices(const TestCase& c, const std::string& time, const Cloud& cloud, bool isAccepted)
{
    Diagnostics diagnostics;
    constexpr std::size_t parts = 3;
    for (std::size_t part = 0; part < parts; ++part)
    {
        const auto slice = readCloud(c.folder(), time, "sph", diagnostics, {}, {part, parts});
        if (!isAccepted) continue;
        const auto isPart = [&](const std::vector<double>& own, const std::vector<double>& whole) {
            return sameBits(own,
                            {whole.begin() + long(part * whole.size() / parts), whole.begin() + long((part + 1) * whole.size() / parts)});
        };
        EXPECT_TRUE(isPart(slice.x, cloud.x) && isPart(slice.y, cloud.y) && isPart(slice.z, cloud.z));
        for (const auto& [name, field] : cloud.fields)
            for (std::size_t k = 0; k < field.component.size(); ++k)
                EXPECT_TRUE(isPart(slice.fields.at(name).component[k], field.component[k])) << name;
    }
    EXPECT_EQ(diagnostics.ok(), isAccepted);
}

/// A file that is emptied and written again waits for the disk on some systems; a new one does not.
void replace(const TestCase& c, const std::string& file, const std::string& text)
{
    std::filesystem::remove(c.folder() / file);
    c.write(file, text);
}

}

TEST(Fuzz, FieldFiles)
{
    const TestCase c(Files{});
    std::vector<std::string> texts;
    for (const auto format : {WriteFormat::ascii, WriteFormat::binary})
    {
        writeTime(c.folder() / "0", format);
        for (const auto& [name, text] : c.files("0/lagrangian/sph")) texts.push_back(text);
    }
    const auto good = c.files("0");
    const std::vector<std::string> names{"positions", "U", "p", "m", "phase", "sigma"};
    fuzz(4000,
         [&](Mutator& mutator)
         {
             const auto format = mutator.below(2);
             const auto name = mutator.oneOf(names);
             const auto file = "0/lagrangian/sph/" + name;
             // The files are sorted by name, those in ascii first.
             auto sorted = names;
             std::ranges::sort(sorted);
             const auto& text = texts[format * names.size() + std::size_t(std::ranges::find(sorted, name) - sorted.begin())];
             replace(c, file, mutator.of(text, texts));
             Diagnostics diagnostics;
             const auto cloud = readCloud(c.folder(), "0", "sph", diagnostics);
             if (diagnostics.ok()) expectRead(c, "0", cloud);
             expectSlices(c, "0", cloud, diagnostics.ok());
             replace(c, file, good.at("lagrangian/sph/" + name));
         });
}

// Files are damaged, lost, emptied, exchanged or taken from another time, those of the run's state as well: what RunTime and readCloud then accept
// has all fields that were written, as they stand in the files.
TEST(Fuzz, TimeFolders)
{
    const TestCase c({{"system/controlDict", controls}});
    std::vector<std::string> texts;
    Files good;
    {
        const Case theCase(c.folder());
        std::filesystem::create_directories(c.folder() / "0");
        RunTime time(theCase);
        for (const auto format : {WriteFormat::binary, WriteFormat::ascii})
        {
            time.advance(0.02);
            time.write([&](const std::filesystem::path& folder) { writeTime(folder, format); }, {{"work", 0.1}, {"energyGiven", 1e-300}},
                       {{"probes.sum", {1, 2.5}}});
        }
        theCase.diagnostics().throwIfAny();
        good = c.files("0.04");
        for (const auto& [name, text] : good) texts.push_back(text);
    }
    std::vector<std::string> names;
    for (const auto& [name, text] : good) names.push_back(name);
    fuzz(1000,
         [&](Mutator& mutator)
         {
             const auto name = mutator.oneOf(names);
             const auto file = "0.04/" + name;
             switch (mutator.below(8))
             {
             case 0:
                 std::filesystem::remove(c.folder() / file);
                 break;
             case 1:
                 replace(c, file, "");
                 break;
             case 2:
                 replace(c, file, c.read("0.04/" + mutator.oneOf(names)));
                 break;
             case 3:
                 replace(c, file, c.read("0.02/" + name));
                 break;
             case 4:
                 replace(c, file + "2", good.at(name));
                 break;
             default:
                 replace(c, file, mutator.of(good.at(name), texts));
             }
             const Case theCase(c.folder());
             const RunTime time(theCase);
             const auto cloud = readCloud(c.folder(), time.startName(), "sph", theCase.diagnostics());
             if (theCase.diagnostics().ok())
             {
                 EXPECT_EQ(time.startName(), "0.04");
                 EXPECT_EQ(cloud.size(), particles);
                 const std::string properties = "uniform/lagrangian/sph/cloudProperties";
                 const bool listed = c.read("0.04/" + properties) == good.at(properties);
                 for (const char* field : {"U", "p", "m", "phase", "sigma"}) EXPECT_TRUE(!listed || cloud.fields.contains(field)) << field;
                 expectRead(c, "0.04", cloud);
             }
             std::filesystem::remove(c.folder() / (file + "2"));
             replace(c, file, good.at(name));
         });
}

}
