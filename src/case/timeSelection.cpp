#include "case/timeSelection.hpp"
#include "base/CaseError.hpp"
#include "base/words.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace
{

double number(const std::string& text, const std::string& item)
{
    std::size_t used = 0;
    double value = 0;
    try
    {
        value = std::stod(text, &used);
    }
    catch (const std::exception&)
    {}
    if (used != text.size() || text.empty())
        throw CaseError(fmt::format("-time: \"{}\" is neither a time nor a range such as 0.1:0.5", item));
    return value;
}

}

std::vector<std::string> selectTimes(const std::vector<std::string>& times, const std::string& selection)
{
    if (selection.find_first_not_of(", ") == std::string::npos) return times;
    std::vector<bool> chosen(times.size());
    for (std::size_t begin = 0; begin < selection.size();)
    {
        begin = selection.find_first_not_of(", ", begin);
        if (begin == std::string::npos) break;
        const auto end = std::min(selection.find_first_of(", ", begin), selection.size());
        const auto item = selection.substr(begin, end - begin);
        begin = end;

        constexpr double infinity = std::numeric_limits<double>::infinity();
        const auto colon = item.find(':');
        const auto from = item.substr(0, colon), to = colon == std::string::npos ? from : item.substr(colon + 1);
        const double low = from.empty() ? -infinity : number(from, item), high = to.empty() ? infinity : number(to, item);
        bool any = false;
        for (std::size_t t = 0; t < times.size(); ++t)
        {
            // Names are exact: at 10^9 s a quarter of a second still tells two times apart.
            const double value = std::stod(times[t]), roundOff = 1e-12 * std::fabs(value);
            if (value < low - roundOff || value > high + roundOff) continue;
            chosen[t] = any = true;
        }
        if (!any) throw CaseError(fmt::format("-time: no time folder matches \"{}\". There are: {}", item, list(times)));
    }
    std::vector<std::string> result;
    for (std::size_t t = 0; t < times.size(); ++t)
        if (chosen[t]) result.push_back(times[t]);
    return result;
}

}
