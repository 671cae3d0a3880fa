#include "meshes/readers/Polygons.hpp"
#include "meshes/readers/readers.hpp"
#include "meshes/readers/textParts.hpp"
#include <array>
#include <fmt/format.h>

namespace sph
{

namespace
{

class Off
{
    TextLines lines_;
    Notes& notes_;

    /// The next one with anything but a comment; false at the end.
    bool next(std::string_view& line)
    {
        while (lines_.next(line))
        {
            line = trimmed(line.substr(0, line.find('#')));
            if (!line.empty()) return true;
        }
        return false;
    }

    /// Vertices and facets; the header may go on with them in the line of its keyword.
    std::array<std::size_t, 2> readHeader()
    {
        std::string_view line;
        next(line);
        const auto keyword = nextWord(line);
        if (!keyword.ends_with("OFF"))
            lines_.fail(fmt::format("it does not begin with OFF, but with {}: this is no OFF file", quoted(keyword)));
        if (keyword.find_first_of("4n") != keyword.npos)
            lines_.fail(fmt::format("{}: vertices of other than three coordinates are not read", quoted(keyword)));
        if (keyword.substr(0, keyword.size() - 3).find_first_not_of("STCN") != keyword.npos)
            lines_.fail(fmt::format("{} is no OFF that is known", quoted(keyword)));
        line = trimmed(line);
        if (line == "BINARY") lines_.fail("a binary OFF is not read: write it as text");
        if (line.empty() && !next(line)) lines_.fail("it ends within its header: it is truncated");
        std::array<std::size_t, 2> counts{};
        for (auto& count : counts)
        {
            const auto word = nextWord(line);
            const auto number = toWhole(word);
            if (!number || *number < 0 || *number > std::numeric_limits<int>::max())
                lines_.fail(fmt::format("expected the numbers of vertices and facets, found {}", quoted(word)));
            count = std::size_t(*number);
        }
        expectNumbers(lines_, line); // of edges
        return counts;
    }

public:
    Off(std::string_view text, Notes& notes) : lines_(text), notes_(notes) {}

    NumberedMesh read()
    {
        const auto [vertices, facets] = readHeader();
        if (facets == 0) throw UnusableMesh("it has no facets");
        const auto truncated = [&, v = vertices, f = facets](const char* what, std::size_t there) {
            lines_.fail(
                fmt::format("its header tells of {} vertices and {} facets, but it ends after {} {}: it is truncated", v, f, there, what));
        };
        std::vector<Vector<3>> points;
        std::string_view line;
        while (points.size() < vertices)
        {
            if (!next(line)) truncated("vertices", points.size());
            points.push_back(takePoint(lines_, line));
            expectNumbers(lines_, line);
        }
        Polygons faces;
        std::vector<int> corners;
        while (faces.size() < facets)
        {
            if (!next(line)) truncated("facets", faces.size());
            const auto which = [&, f = facets] { return fmt::format("facet {} of {}", faces.size(), f); };
            auto word = nextWord(line);
            const auto count = toWhole(word);
            if (!count || *count < 3)
                lines_.fail(fmt::format("{} has {} corners", which(), count ? fmt::format("{}", *count) : quoted(word)));
            corners.clear();
            for (std::int64_t k = 0; k < *count; ++k)
            {
                word = nextWord(line);
                const auto index = toWhole(word);
                if (!index || *index < 0 || *index >= std::int64_t(vertices))
                    lines_.fail(fmt::format("{} has the vertex {}, and there are {}", which(), quoted(word), vertices));
                corners.push_back(int(*index));
            }
            expectNumbers(lines_, line); // its colour
            faces.add(corners, 0, lines_.number());
        }
        if (next(line))
            lines_.fail(fmt::format("its header tells of {} vertices and {} facets, and more follows: {}", vertices, facets, quoted(line)));
        return faces.triangulated(std::move(points), {"patch0"}, "line", notes_);
    }
};

}

NumberedMesh readOff(std::string_view text, Notes& notes) { return Off(text, notes).read(); }

}
