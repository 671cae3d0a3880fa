#include "dictionary/Expression.hpp"
#include "base/words.hpp"
#include "dictionary/limits.hpp"
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <string_view>
#include <vector>

namespace sph
{

namespace
{

using Arguments = std::vector<double>;

struct Function
{
    std::size_t arguments;
    std::function<double(const Arguments&)> value;
};

Function of(double (*f)(double))
{
    return {1, [f](const Arguments& a) { return f(a[0]); }};
}
Function of(double (*f)(double, double))
{
    return {2, [f](const Arguments& a) { return f(a[0], a[1]); }};
}

const std::map<std::string, Function>& functions()
{
    using std::numbers::pi;
    static const std::map<std::string, Function> all{
        {"pi", {0, [](const Arguments&) { return pi; }}},
        {"e", {0, [](const Arguments&) { return std::numbers::e; }}},
        {"sqrt", of(std::sqrt)},
        {"cbrt", of(std::cbrt)},
        {"sin", of(std::sin)},
        {"cos", of(std::cos)},
        {"tan", of(std::tan)},
        {"asin", of(std::asin)},
        {"acos", of(std::acos)},
        {"atan", of(std::atan)},
        {"atan2", of(std::atan2)},
        {"sinh", of(std::sinh)},
        {"cosh", of(std::cosh)},
        {"tanh", of(std::tanh)},
        {"exp", of(std::exp)},
        {"erf", of(std::erf)},
        {"erfc", of(std::erfc)},
        {"log", of(std::log)},
        {"log10", of(std::log10)},
        {"pow", of(std::pow)},
        {"min", of(std::fmin)},
        {"max", of(std::fmax)},
        {"abs", of(std::fabs)},
        {"floor", of(std::floor)},
        {"ceil", of(std::ceil)},
        {"round", of(std::round)},
        {"sqr", of([](double a) { return a * a; })},
        {"degToRad", of([](double a) { return a * pi / 180; })},
        {"radToDeg", of([](double a) { return a * 180 / pi; })},
    };
    return all;
}

std::vector<std::string> functionNames()
{
    std::vector<std::string> names{"mag", "vector"};
    for (const auto& [name, function] : functions()) names.push_back(name);
    return names;
}

/// Recursive descent, one member function for each level of precedence.
class Evaluation
{
    const std::string& text_;
    const std::function<ExpressionValue(const std::string&)>& lookUp_;
    std::size_t at_ = 0;
    int depth_ = 0;

    /// A bracket, sign, power or condition that is open.
    struct Level
    {
        int& depth;
        explicit Level(int& d) : depth(d)
        {
            if (++depth > 2 * limit::nesting)
                fail(fmt::format("brackets, signs and conditions nest deeper than {} levels", limit::nesting));
        }
        ~Level() { --depth; }
    };

public:
    Evaluation(const std::string& text, const std::function<ExpressionValue(const std::string&)>& lookUp) : text_(text), lookUp_(lookUp) {}

    ExpressionValue run()
    {
        const auto value = conditional();
        if (!atEnd()) fail(fmt::format("unexpected \"{}\"", beginning(text_.substr(at_))));
        if (!std::isfinite(value.scalar) || (value.vector && !std::isfinite(dot(*value.vector, *value.vector))))
            fail(fmt::format("the result is {}", value.vector               ? "not a finite vector"
                                                 : std::isnan(value.scalar) ? "not a number"
                                                                            : "infinite"));
        return value;
    }

private:
    [[noreturn]] static void fail(const std::string& what) { throw ExpressionError(what); }

    bool atEnd()
    {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
        return at_ == text_.size();
    }
    bool sees(std::string_view s) { return !atEnd() && text_.compare(at_, s.size(), s) == 0; }
    bool accept(std::string_view s)
    {
        if (!sees(s)) return false;
        at_ += s.size();
        return true;
    }
    void expect(std::string_view s)
    {
        if (!accept(s))
            fail(fmt::format("expected \"{}\" {}", s, atEnd() ? "at the end" : "before \"" + beginning(text_.substr(at_)) + "\""));
    }

    static double scalar(const ExpressionValue& a)
    {
        if (a.vector) fail("a vector stands where a number is needed");
        return a.scalar;
    }

    ExpressionValue conditional()
    {
        const Level level(depth_);
        const auto condition = disjunction();
        if (!accept("?")) return condition;
        const auto a = conditional();
        expect(":");
        const auto b = conditional();
        return scalar(condition) != 0 ? a : b;
    }
    ExpressionValue disjunction()
    {
        auto a = conjunction();
        while (accept("||"))
        {
            const auto b = conjunction();
            a = {double(scalar(a) != 0 || scalar(b) != 0)};
        }
        return a;
    }
    ExpressionValue conjunction()
    {
        auto a = comparison();
        while (accept("&&"))
        {
            const auto b = comparison();
            a = {double(scalar(a) != 0 && scalar(b) != 0)};
        }
        return a;
    }
    ExpressionValue comparison()
    {
        const auto a = sum();
        const auto with = [&](auto relation) { return ExpressionValue{double(relation(scalar(a), scalar(sum())))}; };
        if (accept("==")) return with(std::equal_to<>());
        if (accept("!=")) return with(std::not_equal_to<>());
        if (accept("<=")) return with(std::less_equal<>());
        if (accept(">=")) return with(std::greater_equal<>());
        if (accept("<")) return with(std::less<>());
        if (accept(">")) return with(std::greater<>());
        return a;
    }
    ExpressionValue sum()
    {
        auto a = product();
        for (;;)
        {
            const double sign = accept("+") ? 1 : accept("-") ? -1 : 0;
            if (sign == 0) return a;
            const auto b = product();
            if (a.vector.has_value() != b.vector.has_value()) fail("a number is added to a vector");
            if (a.vector) *a.vector += sign * *b.vector;
            a.scalar += sign * b.scalar;
        }
    }
    ExpressionValue product()
    {
        auto a = signedFactor();
        for (;;)
        {
            if (accept("*"))
            {
                const auto b = signedFactor();
                if (a.vector && b.vector) fail("two vectors are multiplied");
                if (b.vector) a = {0, a.scalar * *b.vector};
                else if (a.vector) *a.vector *= b.scalar;
                else a.scalar *= b.scalar;
            }
            else if (accept("/") || sees("%"))
            {
                const bool remainder = accept("%");
                const double b = scalar(signedFactor());
                if (b == 0) fail("division by zero");
                if (remainder) a.scalar = std::fmod(scalar(a), b);
                else if (a.vector) *a.vector *= 1 / b;
                else a.scalar /= b;
            }
            else return a;
        }
    }
    ExpressionValue signedFactor()
    {
        const Level level(depth_);
        if (accept("+")) return signedFactor();
        if (!sees("!=") && accept("!")) return {double(scalar(signedFactor()) == 0)};
        if (!accept("-")) return power();
        auto a = signedFactor();
        a.scalar = -a.scalar;
        if (a.vector) *a.vector *= -1;
        return a;
    }
    ExpressionValue power()
    {
        const auto a = primary();
        return accept("^") ? ExpressionValue{std::pow(scalar(a), scalar(signedFactor()))} : a;
    }
    ExpressionValue primary()
    {
        if (atEnd()) fail("a value is missing at the end");
        if (accept("("))
        {
            const auto inside = conditional();
            expect(")");
            return inside;
        }
        const char c = text_[at_];
        if (c == '$') return macro();
        if (std::isalpha(static_cast<unsigned char>(c))) return call();
        double value = 0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (error != std::errc()) fail(fmt::format("expected a value before \"{}\"", beginning(text_.substr(at_))));
        at_ = std::size_t(end - text_.data());
        return {value};
    }
    ExpressionValue macro()
    {
        const bool braced = text_.compare(++at_, 1, "{") == 0;
        if (braced) ++at_;
        const auto begin = at_;
        while (at_ < text_.size() && (braced ? text_[at_] != '}'
                                             : std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_' ||
                                                   text_[at_] == '.' || text_[at_] == ':'))
            ++at_;
        const auto name = text_.substr(begin, at_ - begin);
        if (braced) expect("}");
        return lookUp_(name);
    }
    ExpressionValue call()
    {
        std::string name;
        while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_]))) name += text_[at_++];
        const auto function = functions().find(name);
        if (function == functions().end() && name != "mag" && name != "vector")
            fail(fmt::format("\"{}\" is unknown (a macro is written ${}). {}", name, name, suggestion(name, "functions", functionNames())));
        expect("(");
        std::vector<ExpressionValue> arguments;
        while (!atEnd() && !sees(")"))
        {
            if (!arguments.empty()) expect(",");
            arguments.push_back(conditional());
        }
        expect(")");
        const std::size_t expected = name == "mag" ? 1 : name == "vector" ? 3 : function->second.arguments;
        if (arguments.size() != expected) fail(fmt::format("{}() takes {} arguments, found {}", name, expected, arguments.size()));
        if (name == "mag") return {arguments[0].vector ? mag(*arguments[0].vector) : std::fabs(arguments[0].scalar)};
        Arguments values;
        for (const auto& a : arguments) values.push_back(scalar(a));
        if (name == "vector") return {0, Vector<3>{values[0], values[1], values[2]}};
        return {function->second.value(values)};
    }
};

}

ExpressionValue evaluate(const std::string& text, const std::function<ExpressionValue(const std::string&)>& lookUp)
{
    return Evaluation(text, lookUp).run();
}

}
