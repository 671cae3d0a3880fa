#include "case/TimeName.hpp"
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sph
{

std::string timeName(double value, TimeFormat format, int precision)
{
    // A folder called "-0" would be another one than "0".
    if (value == 0) value = 0;
    switch (format)
    {
    case TimeFormat::general:
        return fmt::format("{:.{}g}", value, precision);
    case TimeFormat::fixed:
        return fmt::format("{:.{}f}", value, precision);
    case TimeFormat::scientific:
        return fmt::format("{:.{}e}", value, precision);
    }
    return "";
}

std::optional<double> timeValue(const std::string& name)
{
    double value = 0;
    const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), value);
    if (error != std::errc{} || stop != name.data() + name.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

bool couldBeNamed(double value, const std::string& name)
{
    if (timeValue(name) == value) return true;
    for (const auto format : {TimeFormat::general, TimeFormat::fixed, TimeFormat::scientific})
        for (int precision = 1; precision <= std::numeric_limits<double>::max_digits10; ++precision)
            if (timeName(value, format, precision) == name) return true;
    return false;
}

}
