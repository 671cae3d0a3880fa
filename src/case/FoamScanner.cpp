#include "case/FoamScanner.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace sph
{

void FoamScanner::skipComment()
{
    const bool block = at_[1] == '*';
    const std::string_view rest(at_ + 2, end_);
    const auto close = rest.find(block ? "*/" : "\n");
    if (block && close == std::string_view::npos) fail("the comment /* does not end");
    at_ = close == std::string_view::npos ? end_ : at_ + 2 + close + (block ? 2 : 1);
}

int FoamScanner::line() const { return inBinary_ ? 0 : 1 + int(std::count(begin_, at_, '\n')); }

std::string FoamScanner::found()
{
    if (peek() == '\0' && atEnd()) return "the end of the file";
    constexpr std::ptrdiff_t most = 20;
    std::string text = "\"";
    for (auto p = at_; p != end_ && p - at_ < most && !isBlank(*p); ++p) text += *p > ' ' && *p < 127 ? *p : '?';
    return text + '"';
}

std::string FoamScanner::word()
{
    const char first = peek();
    if (first == '"')
    {
        const auto close = std::find_if(at_ + 1, end_, [](char c) { return c == '"' || c == '\n'; });
        if (close == end_ || *close == '\n') fail("the string does not end on its line");
        std::string text(at_ + 1, close);
        at_ = close + 1;
        return text;
    }
    const auto start = at_;
    int depth = 0;
    for (; at_ != end_ && !isBlank(*at_) && !std::strchr(";{}", *at_); ++at_)
    {
        if (*at_ == '(') ++depth;
        else if (*at_ == ')' && --depth < 0) break;
    }
    return {start, at_};
}

bool FoamScanner::number(double& value)
{
    skip();
    // std::from_chars knows no leading '+'.
    const bool plus = at_ != end_ && *at_ == '+' && at_ + 1 != end_ && at_[1] != '-';
    const auto [stop, error] = std::from_chars(at_ + plus, end_, value);
    if (error == std::errc::invalid_argument || !endsAt(stop)) return false;
    if (error == std::errc::result_out_of_range) value = std::strtod(std::string(at_, stop).c_str(), nullptr);
    at_ = stop;
    return true;
}

bool FoamScanner::integer(std::int64_t& value)
{
    skip();
    const auto [stop, error] = std::from_chars(at_, end_, value);
    if (error != std::errc{} || !endsAt(stop)) return false;
    at_ = stop;
    return true;
}

}
