#include "meshes/readers/Polygons.hpp"
#include "meshes/readers/RegionNames.hpp"
#include "meshes/readers/readers.hpp"
#include "meshes/readers/textParts.hpp"
#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// Statements of normals, textures, materials and looks, and of curves: none of them bounds anything.
constexpr std::array<std::string_view, 31> ignored{"vt",  "vn",    "vp",       "usemtl",   "mtllib", "usemap",     "maplib",    "s",
                                                   "mg",  "bevel", "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj", "cstype",
                                                   "deg", "bmat",  "step",     "parm",     "trim",   "hole",       "scrv",      "sp",
                                                   "end", "con",   "ctech",    "stech",    "curv",   "curv2",      "csh"};
/// Elements that bound a body, or may, and are no polygons.
constexpr std::array<std::string_view, 2> unread{"surf", "call"};

bool isOneOf(const auto& words, std::string_view word) { return std::find(words.begin(), words.end(), word) != words.end(); }

class Obj
{
    TextLines lines_;
    std::string joined_; ///< a statement of several lines
    RegionNames regions_;
    std::string region_; ///< name of the group or object that faces are in
    std::vector<Vector<3>> points_;
    Polygons faces_;
    std::vector<int> corners_;
    std::size_t thinFaces_ = 0, curves_ = 0, dots_ = 0;
    Notes& notes_;

    /// The line without its comment: a # may be part of a name, but not of a number.
    static std::string_view withoutComment(std::string_view line)
    {
        const auto first = trimmed(line).substr(0, 1);
        const bool numbers = first == "v" || first == "f";
        for (auto at = line.find('#'); at != line.npos; at = line.find('#', at + 1))
            if (numbers || at == 0 || line[at - 1] == ' ' || line[at - 1] == '\t') return line.substr(0, at);
        return line;
    }

    /// A backslash at the end of a line goes on with the next one.
    bool next(std::string_view& statement)
    {
        std::string_view line;
        if (!lines_.next(line)) return false;
        statement = trimmed(withoutComment(line));
        if (!statement.ends_with('\\')) return true;
        joined_.clear();
        while (statement.ends_with('\\'))
        {
            joined_ += statement.substr(0, statement.size() - 1);
            joined_ += ' ';
            if (!lines_.next(line)) lines_.fail("the file ends with a backslash, which goes on with a next line: it is truncated");
            statement = trimmed(withoutComment(line));
        }
        joined_ += statement;
        statement = joined_;
        return true;
    }

    /// The point of a corner "7", "7/2", "7//3", "7/2/3" or "-1", from 0. Behind the slashes stand texture and normal.
    int corner(std::string_view word) const
    {
        const auto slash = std::min(word.find('/'), word.size());
        const auto number = toWhole(word.substr(0, slash));
        if (!number || word.find_first_not_of("0123456789+-/", slash) != word.npos)
            lines_.fail(fmt::format("expected the number of a vertex, as 7, 7/2/3 or -1, found {}", quoted(word)));
        const auto vertices = std::int64_t(points_.size()), index = *number < 0 ? vertices + *number : *number - 1;
        if (*number == 0 || index < 0)
            lines_.fail(fmt::format("the face has the vertex {}, and {} stand before it: the first is 1, the last -1", *number, vertices));
        if (index > std::numeric_limits<int>::max()) lines_.fail(fmt::format("the face has the vertex {}: too many", *number));
        return int(index);
    }

    void readFace(std::string_view line)
    {
        corners_.clear();
        for (auto word = nextWord(line); !word.empty(); word = nextWord(line)) corners_.push_back(corner(word));
        if (corners_.size() < 3) ++thinFaces_;
        else faces_.add(corners_, regions_.index(region_), lines_.number());
    }

    void read(std::string_view line)
    {
        const auto word = nextWord(line);
        if (word == "v")
        {
            points_.push_back(takePoint(lines_, line));
            expectNumbers(lines_, line);
        }
        else if (word == "f" || word == "fo") readFace(line);
        else if (word == "g" || word == "o") region_ = trimmed(line);
        else if (word == "l") ++curves_;
        else if (word == "p") ++dots_;
        else if (isOneOf(unread, word)) lines_.fail(fmt::format("{} is not read: export the surface as polygons", quoted(word)));
        else if (!word.empty() && !isOneOf(ignored, word))
            lines_.fail(fmt::format("{} is no statement of an OBJ file{}", quoted(word), points_.empty() ? ": this is no OBJ file" : ""));
    }

    void checkCorners() const
    {
        for (std::size_t f = 0; f < faces_.size(); ++f)
            for (const int p : faces_[f])
                if (p >= int(points_.size()))
                    throw UnusableMesh(
                        fmt::format("line {}: the face has the vertex {}, and there are {}", faces_.place(f), p + 1, points_.size()));
    }

public:
    Obj(std::string_view text, Notes& notes) : lines_(text), regions_(notes), notes_(notes) {}

    NumberedMesh read()
    {
        for (std::string_view line; next(line);) read(line);
        if (points_.empty()) throw UnusableMesh("it has no vertices: this is no OBJ file");
        checkCorners();
        if (thinFaces_ > 0) notes_.push_back(counted(thinFaces_, "face") + " of fewer than three corners left out");
        if (curves_ > 0) notes_.push_back(counted(curves_, "line") + " (l) left out");
        if (dots_ > 0) notes_.push_back(counted(dots_, "point element") + " (p) left out");
        return faces_.triangulated(std::move(points_), regions_.words(), "line", notes_);
    }
};

}

NumberedMesh readObj(std::string_view text, Notes& notes) { return Obj(text, notes).read(); }

}
