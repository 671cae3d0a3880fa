#include "base/CaseError.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <tuple>

namespace sph
{

std::string toString(const Location& where) { return where.line > 0 ? fmt::format("{}:{}", where.file, where.line) : where.file; }

CaseError::CaseError(const Location& where, const std::string& what)
    : runtime_error(where.file.empty() ? what : toString(where) + ": " + what)
{}

void Diagnostics::error(Location where, std::string what)
{
    // A message may quote what a damaged file has without end.
    constexpr std::size_t longest = 4000;
    if (what.size() > longest) what = what.substr(0, longest) + "...";
    for (const auto& e : errors_)
        if (e.where.file == where.file && e.where.line == where.line && e.what == what) return;
    errors_.push_back({std::move(where), std::move(what)});
}

void Diagnostics::warning(Location where, std::string what) { warnings_.push_back({std::move(where), std::move(what)}); }

std::vector<std::string> Diagnostics::warnings() const
{
    std::vector<std::string> lines;
    for (const auto& w : warnings_) lines.push_back(CaseError(w.where, w.what).what());
    return lines;
}

void Diagnostics::throwIfAny() const
{
    if (ok()) return;
    auto sorted = errors_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Entry& a, const Entry& b)
                     { return std::tie(a.where.file, a.where.line) < std::tie(b.where.file, b.where.line); });
    std::string all;
    for (const auto& e : sorted) all += (all.empty() ? "" : "\n") + std::string(CaseError(e.where, e.what).what());
    if (sorted.size() > 1) all += fmt::format("\n{} errors", sorted.size());
    throw CaseError(all);
}

}
