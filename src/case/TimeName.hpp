/// Names of time folders.
#pragma once
#include <optional>
#include <string>

namespace sph
{

enum class TimeFormat
{
    general,
    fixed,
    scientific
};

std::string timeName(double value, TimeFormat, int precision);

/// The number that a folder is called by; none for "0.orig", "0.5.partial", "nan" and every other name that is not a finite number.
std::optional<double> timeValue(const std::string& name);

/// Whether a folder of that name can hold this time: rounded to some number of digits, in some format, it is called so.
bool couldBeNamed(double value, const std::string& name);

}
