/// Geometry from text, with the errors that the text deserves.
#pragma once
#include "geometry/Geometry.hpp"
#include "messages.hpp"
#include <string>

namespace sph::test
{

struct Reading
{
    Geometry geometry;
    std::string errors;
};

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline Reading read(const std::string& text, double reach = 0.1)
{
    auto diagnostics = std::make_shared<Diagnostics>();
    const auto dict = Dictionary::parse(text, "constant/geometry", diagnostics);
    Reading result{readGeometry(dict, reach), ""};
    dict.reportUnused();
    result.errors = messages(*diagnostics);
    return result;
}

inline const std::string cube = "dimension 3; domain { min (0 0 0); max (1 1 1); periodic (x y z); }\n";
inline const std::string square = "dimension 2; domain { min (0 0 0); max (1 1 0); }\n";

inline std::string bcc(const std::string& period)
{
    return cube + "walls { grains { type sphereBed; lattice bcc; radius 0.3; period " + period + "; } }";
}

}
