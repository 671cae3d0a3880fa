#include "meshes/readers/Polygons.hpp"
#include "meshes/readers/readers.hpp"
#include "meshes/readers/singlePrecision.hpp"
#include "meshes/readers/textParts.hpp"
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <utility>

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
    std::size_t rows = 0;
    std::vector<Property> properties;

    const Property* find(std::string_view property) const
    {
        const auto there = std::ranges::find(properties, property, &Property::name);
        return there == properties.end() ? nullptr : &*there;
    }
    /// The list of the corners of a face or strip.
    const Property* corners() const
    {
        const auto* list = find("vertex_indices");
        if (!list) list = find("vertex_index");
        return list && list->count ? list : nullptr;
    }
};

struct Header
{
    enum
    {
        ascii,
        little,
        big
    };
    std::optional<int> format;
    std::vector<Element> elements;

    const Element* find(std::string_view name) const
    {
        const auto there = std::ranges::find(elements, name, &Element::name);
        return there == elements.end() ? nullptr : &*there;
    }
};

/// False where the line is none of a header.
bool take(std::string_view line, Header& header)
{
    std::vector<std::string_view> words;
    while (words.size() < 7)
    {
        const auto word = nextWord(line);
        if (word.empty()) break;
        words.push_back(word);
    }
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return true;
    if (words[0] == "format" && words.size() == 3)
    {
        if (header.format) return false;
        const bool little = words[1] == "binary_little_endian", big = words[1] == "binary_big_endian";
        header.format = little ? Header::little : big ? Header::big : Header::ascii;
        return words[2] == "1.0" && (little || big || words[1] == "ascii");
    }
    if (words[0] == "element" && words.size() == 3)
    {
        const auto rows = toWhole(words[2]);
        if (!rows || *rows < 0 || *rows > std::numeric_limits<int>::max() || header.find(words[1])) return false;
        header.elements.push_back({words[1], std::size_t(*rows), {}});
        return true;
    }
    const bool list = words.size() == 5 && words[1] == "list";
    if (words[0] != "property" || !(list || words.size() == 3) || header.elements.empty()) return false;
    auto& element = header.elements.back();
    const auto& types = numberTypes();
    const auto type = types.find(words[list ? 3 : 1]), count = types.find(words[2]);
    const bool known = type != types.end() && (!list || (count != types.end() && count->second.kind != NumberType::isFloat));
    if (!known || element.find(words.back())) return false;
    element.properties.push_back({words.back(), type->second, list ? std::optional(count->second) : std::nullopt});
    return true;
}

/// The numbers behind the header, one by one.
class Numbers
{
    TextLines lines_;       ///< ascii
    std::string_view line_; ///< ascii
    std::string_view rest_; ///< binary
    std::size_t size_;
    int format_;

public:
    /// `linesBefore` and `size` of the file, for places.
    Numbers(std::string_view rest, std::size_t linesBefore, std::size_t size, int format)
        : lines_(format == Header::ascii ? rest : "", linesBefore), rest_(rest), size_(size), format_(format)
    {}

    const char* placeName() const { return format_ == Header::ascii ? "line" : "byte"; }
    std::size_t place() const { return format_ == Header::ascii ? lines_.number() : size_ - rest_.size(); }

    /// An ascii row is a line of its own; false at the end of the text.
    bool beginRow()
    {
        if (format_ != Header::ascii) return true;
        do {
            if (!lines_.next(line_)) return false;
        } while (trimmed(line_).empty());
        return true;
    }
    bool rowEnds() const { return format_ != Header::ascii || trimmed(line_).empty(); }
    /// Bytes behind the last row; of ascii, of its next full line.
    std::size_t left() { return format_ != Header::ascii ? rest_.size() : beginRow() ? line_.size() : 0; }

    /// May be infinite or none where it is no whole number.
    std::optional<double> next(const NumberType& type)
    {
        if (format_ == Header::ascii) return type.kind == NumberType::isFloat ? toFiniteOrNan(nextWord(line_)) : toFinite(nextWord(line_));
        if (rest_.size() < type.bytes) return {};
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < type.bytes; ++k)
            bits |= std::uint64_t(static_cast<unsigned char>(rest_[format_ == Header::little ? k : type.bytes - 1 - k])) << (8 * k);
        rest_.remove_prefix(type.bytes);
        if (type.kind == NumberType::isFloat)
            return type.bytes == 4 ? std::bit_cast<float>(std::uint32_t(bits)) : std::bit_cast<double>(bits);
        const auto unused = 64 - 8 * type.bytes;
        return type.kind == NumberType::isUnsigned ? double(bits) : double(std::int64_t(bits << unused) >> unused);
    }
};

bool isWhole(double value, double low, double high) { return value >= low && value < high && value == std::floor(value); }

class Ply
{
    Header header_;
    std::vector<Vector<3>> points_;
    Polygons faces_;
    std::vector<int> corners_;
    Notes& notes_;

    /// Reads the header, and returns the bytes behind it. Lines end as the first one does, since the first byte of data may look like the end of a line.
    std::string_view readHeader(std::string_view bytes, std::size_t& lines)
    {
        if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
        if (!bytes.starts_with("ply") || bytes.find_first_of("\r\n") == bytes.npos)
            throw UnusableMesh("line 1: it does not begin with ply: this is no PLY file");
        const char end = bytes.substr(bytes.find_first_of("\r\n")).starts_with("\r") && !bytes.substr(bytes.find('\r')).starts_with("\r\n")
                             ? '\r'
                             : '\n';
        while (true)
        {
            const auto length = bytes.find(end);
            const auto line = trimmed(bytes.substr(0, length));
            ++lines;
            if (length == bytes.npos) throw UnusableMesh(fmt::format("line {}: it ends within its header: it is truncated", lines));
            bytes.remove_prefix(length + 1);
            if (line == "end_header")
            {
                if (!header_.format) throw UnusableMesh(fmt::format("line {}: its header ends without a format", lines));
                return bytes;
            }
            if (lines == 1 ? line != "ply" : !take(line, header_))
                throw UnusableMesh(fmt::format("line {}: its header has the line {}", lines, quoted(line)));
        }
    }

    void checkHeader() const
    {
        const auto *vertices = header_.find("vertex"), *faces = header_.find("face"), *strips = header_.find("tristrips");
        if ((!faces || faces->rows == 0) && (!strips || strips->rows == 0))
            throw UnusableMesh("it has no facets: its header tells of no element face");
        if (!vertices || !std::ranges::all_of(std::array{"x", "y", "z"},
                                              [&](const char* name)
                                              {
                                                  const auto* p = vertices->find(name);
                                                  return p && !p->count;
                                              }))
            throw UnusableMesh("its vertices have no x, y and z");
        for (const auto* element : {faces, strips})
            if (element && element->rows > 0 && !element->corners())
                throw UnusableMesh(fmt::format("its element {} has no list vertex_indices", element->name));
        for (const auto& element : header_.elements)
            if (element.rows > 0 && element.properties.empty())
                throw UnusableMesh(
                    fmt::format("its header tells of {} rows of element {} without a property", element.rows, quoted(element.name)));
    }

    /// Triangles of a strip, every other one turned; -1 ends one strip.
    void addStrips(std::size_t place)
    {
        const auto strips = std::exchange(corners_, {});
        std::size_t begin = 0;
        for (std::size_t k = 0; k < strips.size(); ++k)
        {
            if (strips[k] < 0) begin = k + 1;
            else if (k >= begin + 2)
            {
                const bool odd = (k - begin) % 2 == 1;
                faces_.add(std::array{strips[k - 2], strips[k - (odd ? 0 : 1)], strips[k - (odd ? 1 : 0)]}, 0, place);
            }
        }
    }

    void readRows(const Element& element, Numbers& numbers)
    {
        const bool isVertex = element.name == "vertex", isStrip = element.name == "tristrips", isFace = element.name == "face";
        const auto* cornerList = isFace || isStrip ? element.corners() : nullptr;
        const auto vertices = double(header_.find("vertex")->rows);
        std::array<const Property*, 3> xyz{};
        if (isVertex) xyz = {element.find("x"), element.find("y"), element.find("z")};
        for (std::size_t row = 0; row < element.rows; ++row)
        {
            if (!numbers.beginRow()) fail(numbers.placeName(), numbers.place(), element, row, "is not there: it is truncated");
            const auto place = numbers.place();
            const auto refuse = [&](const std::string& what) { fail(numbers.placeName(), place, element, row, what); };
            const auto number = [&](const NumberType& type)
            {
                const auto value = numbers.next(type);
                if (!value) refuse("is not whole: it is truncated or damaged");
                return *value;
            };
            std::array<double, 3> x{};
            for (const auto& property : element.properties)
            {
                const double first = number(property.count.value_or(property.type));
                for (std::size_t k = 0; k < 3; ++k)
                    if (xyz[k] == &property)
                    {
                        if (!std::isfinite(first)) refuse(fmt::format("has a coordinate {} that is no finite number", property.name));
                        x[k] = isSingle(property) ? asWritten(float(first)) : first;
                    }
                if (!property.count) continue;
                const bool isCorners = &property == cornerList;
                if (!isWhole(first, isCorners && isFace ? 3 : 0, std::numeric_limits<int>::max()))
                    refuse(fmt::format("has {} {}", first, isCorners ? "corners" : "numbers in a list"));
                for (double k = 0; k < first; ++k)
                {
                    const double value = number(property.type);
                    if (!isCorners) continue;
                    if (!isWhole(value, isStrip ? -1 : 0, vertices))
                        refuse(fmt::format("has the vertex {}, and there are {}", value, vertices));
                    corners_.push_back(int(value));
                }
            }
            if (!numbers.rowEnds()) refuse("has more numbers than properties");
            if (isVertex) points_.push_back({x[0], x[1], x[2]});
            else if (isStrip) addStrips(place);
            else if (isFace) faces_.add(corners_, 0, place);
            corners_.clear();
        }
        if (!isVertex && !isFace && !isStrip && element.rows > 0)
            notes_.push_back(fmt::format("element {} ({}) left out", quoted(element.name), counted(element.rows, "row")));
    }

    [[noreturn]] static void fail(const char* placeName, std::size_t place, const Element& element, std::size_t row,
                                  const std::string& what)
    {
        throw UnusableMesh(fmt::format("{} {}: {} {} of {} {}", placeName, place, element.name, row, element.rows, what));
    }

    /// Text has the digits that it has, whatever its header says of them.
    bool isSingle(const Property& p) const
    {
        return header_.format != Header::ascii && p.type.kind == NumberType::isFloat && p.type.bytes == 4;
    }

    double rounding(const std::vector<Vector<3>>& points) const
    {
        const auto* vertices = header_.find("vertex");
        if (!std::ranges::any_of(std::array{"x", "y", "z"}, [&](const char* name) { return isSingle(*vertices->find(name)); })) return 0;
        double largest = 0;
        for (const auto& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        return roundingOf(largest);
    }

public:
    explicit Ply(Notes& notes) : notes_(notes) {}

    NumberedMesh read(std::string_view bytes)
    {
        std::size_t lines = 0;
        const auto rest = readHeader(bytes, lines);
        checkHeader();
        Numbers numbers(rest, lines, bytes.size(), *header_.format);
        for (const auto& element : header_.elements) readRows(element, numbers);
        if (const auto left = numbers.left(); left > 0)
        {
            if (header_.format == Header::ascii)
                throw UnusableMesh(fmt::format("line {}: more rows than its header tells of", numbers.place()));
            notes_.push_back(counted(left, "byte") + " behind the last row that the header tells of left out");
        }
        if (faces_.size() == 0) throw UnusableMesh("it has no facets: its strips have fewer than three corners");
        auto mesh = faces_.triangulated(std::move(points_), {"patch0"}, numbers.placeName(), notes_);
        mesh.rounding = rounding(mesh.points);
        return mesh;
    }
};

}

NumberedMesh readPly(std::string_view bytes, Notes& notes) { return Ply(notes).read(bytes); }

}
