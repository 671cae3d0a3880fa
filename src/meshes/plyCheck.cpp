#include "plyCheck.hpp"
#include "textParts.hpp"
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <vector>

namespace sph
{

namespace
{

struct NumberType
{
    std::size_t bytes;
    enum Kind
    {
        isSigned,
        isUnsigned,
        isFloat
    } kind;
};

const std::map<std::string_view, NumberType>& numberTypes()
{
    using enum NumberType::Kind;
    static const std::map<std::string_view, NumberType> types{
        {"char", {1, isSigned}},  {"uchar", {1, isUnsigned}},  {"short", {2, isSigned}},  {"ushort", {2, isUnsigned}},
        {"int", {4, isSigned}},   {"uint", {4, isUnsigned}},   {"float", {4, isFloat}},   {"double", {8, isFloat}},
        {"int8", {1, isSigned}},  {"uint8", {1, isUnsigned}},  {"int16", {2, isSigned}},  {"uint16", {2, isUnsigned}},
        {"int32", {4, isSigned}}, {"uint32", {4, isUnsigned}}, {"float32", {4, isFloat}}, {"float64", {8, isFloat}}};
    return types;
}

struct Property
{
    std::string_view name;
    NumberType type;
    std::optional<NumberType> count; ///< of a list
};

struct Element
{
    std::string_view name;
    std::size_t rows;
    std::vector<Property> properties;
};

struct Header
{
    enum
    {
        ascii,
        little,
        big
    } format = ascii;
    std::vector<Element> elements;
};

/// One line; false where it is none that a header has.
bool take(std::string_view line, Header& header)
{
    std::vector<std::string_view> words;
    for (auto word = nextWord(line); !word.empty(); word = nextWord(line)) words.push_back(word);
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return true;
    const auto& types = numberTypes();
    if (words[0] == "format" && words.size() == 3)
    {
        const bool little = words[1] == "binary_little_endian", big = words[1] == "binary_big_endian";
        header.format = little ? Header::little : big ? Header::big : Header::ascii;
        return little || big || words[1] == "ascii";
    }
    if (words[0] == "element" && words.size() == 3)
    {
        header.elements.push_back({words[1], number(words[2]), {}});
        return fmt::format("{}", number(words[2])) == words[2];
    }
    const bool list = words.size() == 5 && words[1] == "list";
    if (words[0] != "property" || !(list || words.size() == 3) || header.elements.empty()) return false;
    const auto type = types.find(words[list ? 3 : 1]), count = types.find(words[2]);
    if (type == types.end() || (list && count == types.end())) return false;
    header.elements.back().properties.push_back({words.back(), type->second, list ? std::optional(count->second) : std::nullopt});
    return true;
}

/// The numbers behind the header, one by one.
class Numbers
{
    std::string_view rest_, line_;
    int format_;

public:
    Numbers(std::string_view rest, int format) : rest_(rest), format_(format) {}

    /// An ascii row is a line of its own; false at the end of the text.
    bool beginRow()
    {
        if (format_ != Header::ascii) return true;
        do {
            if (rest_.empty()) return false;
            line_ = nextLine(rest_);
        } while (line_.find_first_not_of(" \t\r") == line_.npos);
        return true;
    }
    bool rowEnds() { return format_ != Header::ascii || nextWord(line_).empty(); }

    std::optional<double> next(const NumberType& type)
    {
        if (format_ == Header::ascii)
        {
            const auto word = nextWord(line_);
            double value = 0;
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
            return error == std::errc() && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
        }
        if (rest_.size() < type.bytes) return {};
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < type.bytes; ++k)
            bits |= std::uint64_t(static_cast<unsigned char>(rest_[format_ == Header::little ? k : type.bytes - 1 - k])) << (8 * k);
        rest_.remove_prefix(type.bytes);
        if (type.kind == NumberType::isFloat)
            return type.bytes == 4 ? double(std::bit_cast<float>(std::uint32_t(bits))) : std::bit_cast<double>(bits);
        const auto unused = 64 - 8 * type.bytes;
        return type.kind == NumberType::isUnsigned ? double(bits) : double(std::int64_t(bits << unused) >> unused);
    }
};

bool isWholeBelow(double value, std::size_t limit) { return value >= 0 && value == std::floor(value) && value < double(limit); }

}

std::string brokenPly(std::string_view text)
{
    if (nextLine(text).substr(0, 3) != "ply") return "it does not begin with ply: this is no PLY file";
    Header header;
    while (true)
    {
        if (text.empty()) return "it ends within its header";
        auto line = nextLine(text);
        if (auto rest = line; nextWord(rest) == "end_header") break;
        if (!take(line, header)) return fmt::format("its header has the line \"{}\"", line);
    }
    std::size_t points = 0, faces = 0;
    bool x = false, y = false, z = false, corners = false;
    for (const auto& element : header.elements)
    {
        if (element.name == "vertex") points = element.rows;
        if (element.name == "face") faces = element.rows;
        for (const auto& p : element.properties)
            if (element.name == "vertex")
            {
                x = x || p.name == "x";
                y = y || p.name == "y";
                z = z || p.name == "z";
            }
            else if (element.name == "face") corners = corners || (p.count && (p.name == "vertex_indices" || p.name == "vertex_index"));
    }
    if (faces == 0) return "it has no facets";
    if (!x || !y || !z || !corners) return "its vertices have no x, y and z, or its faces no vertex_indices";

    Numbers numbers(text, header.format);
    for (const auto& element : header.elements)
        for (std::size_t row = 0; row < element.rows; ++row)
        {
            const auto which = [&] { return fmt::format("{} {} of {}", element.name, row, element.rows); };
            if (!numbers.beginRow()) return fmt::format("{} is not there: it is truncated", which());
            for (const auto& property : element.properties)
            {
                const auto first = numbers.next(property.count.value_or(property.type));
                if (!first) return fmt::format("{} is not whole: it is truncated or damaged", which());
                if (!property.count) continue;
                const bool ofFace = element.name == "face" && property.name.substr(0, 6) == "vertex";
                if (!isWholeBelow(*first, text.size()) || (ofFace && *first < 3)) return fmt::format("{} has {} corners", which(), *first);
                for (double k = 0; k < *first; ++k)
                {
                    const auto value = numbers.next(property.type);
                    if (!value) return fmt::format("{} is not whole: it is truncated or damaged", which());
                    if (ofFace && !isWholeBelow(*value, points))
                        return fmt::format("{} has the vertex {}, and there are {}", which(), *value, points);
                }
            }
            if (!numbers.rowEnds()) return fmt::format("{} has more numbers than properties", which());
        }
    return "";
}

}
