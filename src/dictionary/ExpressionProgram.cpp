#include "dictionary/ExpressionProgram.hpp"
#include "base/words.hpp"
#include "dictionary/limits.hpp"
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <string_view>

namespace sph
{

namespace
{

struct Function
{
    std::size_t arguments;
    double value = 0; ///< of one without arguments
    double (*one)(double) = nullptr;
    double (*two)(double, double) = nullptr;
};

Function of(double (*f)(double)) { return {1, 0, f}; }
Function of(double (*f)(double, double)) { return {2, 0, nullptr, f}; }

const std::map<std::string, Function>& functions()
{
    using std::numbers::pi;
    static const std::map<std::string, Function> all{
        {"pi", {0, pi}},
        {"e", {0, std::numbers::e}},
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

/// Functions of a field as a whole, not of its value in one place: whoever gives the names their values knows `grad(p)` as a name.
constexpr std::array ofFields{"grad", "smooth"};

std::vector<std::string> functionNames()
{
    std::vector<std::string> names{"dot", "mag", "vector"};
    names.insert(names.end(), ofFields.begin(), ofFields.end());
    for (const auto& [name, function] : functions()) names.push_back(name);
    return names;
}

constexpr std::array components{&Vector<3>::x, &Vector<3>::y, &Vector<3>::z};

[[noreturn]] void fail(const std::string& what) { throw ExpressionError(what); }

}

/// Recursive descent, one member function for each level of precedence.
class ExpressionProgram::Reader
{
    struct Value
    {
        Kind kind;
        std::array<int, 3> row{}; ///< of a number the first
    };

    const std::string& text_;
    const std::function<Kind(const std::string&)>& kindOf_;
    ExpressionProgram& program_;
    std::vector<Value> variables_;
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
    Reader(const std::string& text, const std::function<Kind(const std::string&)>& kindOf, ExpressionProgram& program)
        : text_(text), kindOf_(kindOf), program_(program)
    {}

    void read()
    {
        const auto value = conditional();
        if (!atEnd()) fail(fmt::format("unexpected \"{}\"", beginning(text_.substr(at_))));
        program_.kind_ = value.kind;
        program_.result_ = value.row;
    }

private:
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

    int step(const Step& step)
    {
        program_.steps_.push_back(step);
        return int(program_.steps_.size()) - 1;
    }
    int constant(double value) { return step({.code = Code::constant, .value = value}); }

    /// The row of a number.
    static int number(const Value& a)
    {
        if (a.kind == Kind::vector) fail("a vector stands where a number is needed");
        return a.row[0];
    }
    Value number(Code code, int a, int b) { return {Kind::number, {step({.code = code, .a = a, .b = b})}}; }
    /// A step for each component of what `a` is.
    template<class Make> Value each(const Value& a, const Make& make)
    {
        Value result{a.kind};
        for (std::size_t c = 0; c < (a.kind == Kind::vector ? 3u : 1u); ++c) result.row[c] = step(make(c));
        return result;
    }
    /// The kind of a value that is of both kinds; an unknown one follows the other.
    static Kind common(const Value& a, const Value& b, const char* mistake)
    {
        if (a.kind == Kind::unknown) return b.kind;
        if (b.kind != Kind::unknown && a.kind != b.kind) fail(mistake);
        return a.kind;
    }

    Value conditional()
    {
        const Level level(depth_);
        const auto condition = disjunction();
        if (!accept("?")) return condition;
        const auto a = conditional();
        expect(":");
        const auto b = conditional();
        const int which = number(condition);
        return each({common(a, b, "a condition chooses between a number and a vector")},
                    [&](std::size_t c) { return Step{.code = Code::choose, .a = which, .b = a.row[c], .c = b.row[c]}; });
    }
    Value disjunction()
    {
        auto a = conjunction();
        while (accept("||"))
        {
            const auto b = conjunction();
            a = number(Code::either, number(a), number(b));
        }
        return a;
    }
    Value conjunction()
    {
        auto a = comparison();
        while (accept("&&"))
        {
            const auto b = comparison();
            a = number(Code::both, number(a), number(b));
        }
        return a;
    }
    Value comparison()
    {
        const auto a = sum();
        for (const auto& [sign, code] : {std::pair{"==", Code::equal},
                                         {"!=", Code::notEqual},
                                         {"<=", Code::lessEqual},
                                         {">=", Code::greaterEqual},
                                         {"<", Code::less},
                                         {">", Code::greater}})
            if (accept(sign))
            {
                const int left = number(a);
                return number(code, left, number(sum()));
            }
        return a;
    }
    Value sum()
    {
        auto a = product();
        for (;;)
        {
            const bool adds = accept("+");
            if (!adds && !accept("-")) return a;
            const auto b = product();
            a = each({common(a, b, "a number is added to a vector")}, [&, left = a.row](std::size_t c)
                     { return Step{.code = adds ? Code::add : Code::subtract, .a = left[c], .b = b.row[c]}; });
        }
    }
    Value product()
    {
        auto a = signedFactor();
        for (;;)
        {
            if (accept("*"))
            {
                auto b = signedFactor();
                if (a.kind == Kind::vector && b.kind == Kind::vector) fail("two vectors are multiplied: dot(a, b) is their product");
                if (b.kind == Kind::vector) std::swap(a, b);
                a = scaled(a, b.row[0], b.kind);
            }
            else if (accept("/") || sees("%"))
            {
                const bool remainder = accept("%");
                const int b = number(signedFactor());
                if (remainder) a = number(Code::remainder, number(a), b);
                else if (a.kind == Kind::vector) a = scaled(a, step({.code = Code::divide, .a = constant(1), .b = b}), Kind::number);
                else a = {a.kind, {step({.code = Code::divide, .a = a.row[0], .b = b})}};
            }
            else return a;
        }
    }
    /// `a` times a number, or something unknown.
    Value scaled(const Value& a, int factor, Kind ofFactor)
    {
        auto result = each(a, [&](std::size_t c) { return Step{.code = Code::multiply, .a = a.row[c], .b = factor}; });
        if (a.kind == Kind::number) result.kind = ofFactor;
        return result;
    }
    Value signedFactor()
    {
        const Level level(depth_);
        if (accept("+")) return signedFactor();
        if (!sees("!=") && accept("!")) return number(Code::isZero, number(signedFactor()), 0);
        if (!accept("-")) return power();
        const auto a = signedFactor();
        return each(a, [&](std::size_t c) { return Step{.code = Code::negate, .a = a.row[c]}; });
    }
    Value power()
    {
        const auto a = primary();
        if (!accept("^")) return a;
        const int base = number(a);
        return function(static_cast<double (*)(double, double)>(std::pow), base, number(signedFactor()));
    }
    Value function(double (*two)(double, double), int a, int b)
    {
        return {Kind::number, {step({.code = Code::function2, .a = a, .b = b, .two = two})}};
    }
    Value function(double (*one)(double), int a) { return {Kind::number, {step({.code = Code::function1, .a = a, .one = one})}}; }
    /// The product of two vectors, and of two numbers; unknown ones count as either.
    Value dotProduct(const Value& a, const Value& b)
    {
        if (a.kind == Kind::number || b.kind == Kind::number) fail("dot() takes two vectors");
        int total = step({.code = Code::multiply, .a = a.row[0], .b = b.row[0]});
        for (std::size_t c = 1; c < 3; ++c) total = step({.code = Code::multiplyAdd, .a = a.row[c], .b = b.row[c], .c = total});
        return {Kind::number, {total}};
    }
    Value primary()
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
        return {Kind::number, {constant(value)}};
    }
    Value macro() { return variable(nameOfMacro()); }
    std::string nameOfMacro()
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
        return name;
    }
    Value variable(const std::string& name)
    {
        auto& names = program_.names_;
        const auto found = std::ranges::find(names, name);
        if (found != names.end()) return variables_[std::size_t(found - names.begin())];
        int component = 0;
        const auto value = each({kindOf_(name)},
                                [&, k = int(names.size())](std::size_t) { return Step{.code = Code::variable, .a = k, .b = component++}; });
        names.push_back(name);
        variables_.push_back(value);
        return value;
    }
    Value call()
    {
        std::string name;
        while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_]))) name += text_[at_++];
        const auto known = functionNames();
        if (std::ranges::find(known, name) == known.end())
            fail(fmt::format("\"{}\" is unknown (a macro is written ${}). {}", name, name, suggestion(name, "functions", known)));
        expect("(");
        if (std::ranges::find(ofFields, name) != ofFields.end())
        {
            if (!sees("$")) fail(fmt::format("{}() takes the name of a field: {}($p)", name, name));
            const auto field = nameOfMacro();
            expect(")");
            return variable(fmt::format("{}({})", name, field));
        }
        std::vector<Value> arguments;
        while (!atEnd() && !sees(")"))
        {
            if (!arguments.empty()) expect(",");
            arguments.push_back(conditional());
        }
        expect(")");
        const auto found = functions().find(name);
        const std::size_t expected = name == "mag" ? 1 : name == "dot" ? 2 : name == "vector" ? 3 : found->second.arguments;
        if (arguments.size() != expected) fail(fmt::format("{}() takes {} arguments, found {}", name, expected, arguments.size()));
        if (name == "dot") return dotProduct(arguments[0], arguments[1]);
        if (name == "mag")
            return arguments[0].kind == Kind::vector ? function(std::sqrt, dotProduct(arguments[0], arguments[0]).row[0])
                                                     : function(std::fabs, arguments[0].row[0]);
        if (name == "vector") return {Kind::vector, {number(arguments[0]), number(arguments[1]), number(arguments[2])}};
        const auto& f = found->second;
        if (expected == 0) return {Kind::number, {constant(f.value)}};
        return expected == 1 ? function(f.one, number(arguments[0])) : function(f.two, number(arguments[0]), number(arguments[1]));
    }
};

ExpressionProgram::ExpressionProgram(const std::string& text, const std::function<Kind(const std::string&)>& kindOf)
{
    Reader(text, kindOf, *this).read();
}

template<bool strict>
void ExpressionProgram::run(std::size_t begin, std::size_t end, std::span<const Values> values, const std::array<double*, 3>& out) const
{
    constexpr std::size_t width = 128; // rows of a whole expression stay in the first cache
    const std::size_t widest = std::min(width, end - begin);
    std::vector<double> rows(steps_.size() * widest);
    for (auto from = begin; from < end; from += widest)
    {
        const auto n = std::min(widest, end - from);
        for (std::size_t k = 0; k < steps_.size(); ++k)
        {
            const auto& s = steps_[k];
            double* const r = rows.data() + k * widest;
            const bool isSource = s.code == Code::constant || s.code == Code::variable;
            const auto row = [&](int which) { return rows.data() + (isSource ? 0 : std::size_t(which)) * widest; };
            const double *const a = row(s.a), *const b = row(s.b), *const c = row(s.c);
            const auto each = [&](const auto& f)
            {
                for (std::size_t i = 0; i < n; ++i) r[i] = f(i);
            };
            if constexpr (strict)
                if ((s.code == Code::divide || s.code == Code::remainder) && b[0] == 0) fail("division by zero");
            switch (s.code)
            {
            case Code::constant:
                each([&](std::size_t) { return s.value; });
                break;
            case Code::variable:
            {
                const auto& of = values[std::size_t(s.a)];
                if (const double* const all = of.each[std::size_t(s.b)]) std::copy_n(all + from, n, r);
                else std::fill_n(r, n, of.same.*components[std::size_t(s.b)]);
                break;
            }
            case Code::add:
                each([&](std::size_t i) { return a[i] + b[i]; });
                break;
            case Code::subtract:
                each([&](std::size_t i) { return a[i] - b[i]; });
                break;
            case Code::multiply:
                each([&](std::size_t i) { return a[i] * b[i]; });
                break;
            case Code::multiplyAdd:
                each([&](std::size_t i) { return a[i] * b[i] + c[i]; });
                break;
            case Code::divide:
                each([&](std::size_t i) { return a[i] / b[i]; });
                break;
            case Code::remainder:
                each([&](std::size_t i) { return std::fmod(a[i], b[i]); });
                break;
            case Code::equal:
                each([&](std::size_t i) { return double(a[i] == b[i]); });
                break;
            case Code::notEqual:
                each([&](std::size_t i) { return double(a[i] != b[i]); });
                break;
            case Code::lessEqual:
                each([&](std::size_t i) { return double(a[i] <= b[i]); });
                break;
            case Code::greaterEqual:
                each([&](std::size_t i) { return double(a[i] >= b[i]); });
                break;
            case Code::less:
                each([&](std::size_t i) { return double(a[i] < b[i]); });
                break;
            case Code::greater:
                each([&](std::size_t i) { return double(a[i] > b[i]); });
                break;
            case Code::both:
                each([&](std::size_t i) { return double(a[i] != 0 && b[i] != 0); });
                break;
            case Code::either:
                each([&](std::size_t i) { return double(a[i] != 0 || b[i] != 0); });
                break;
            case Code::isZero:
                each([&](std::size_t i) { return double(a[i] == 0); });
                break;
            case Code::negate:
                each([&](std::size_t i) { return -a[i]; });
                break;
            case Code::choose:
                each([&](std::size_t i) { return a[i] != 0 ? b[i] : c[i]; });
                break;
            case Code::function1:
                each([&](std::size_t i) { return s.one(a[i]); });
                break;
            case Code::function2:
                each([&](std::size_t i) { return s.two(a[i], b[i]); });
                break;
            }
        }
        for (std::size_t c = 0; c < (kind_ == Kind::vector ? 3u : 1u); ++c)
            std::copy_n(rows.data() + std::size_t(result_[c]) * widest, n, out[c] + (from - begin));
    }
}

void ExpressionProgram::operator()(std::size_t begin, std::size_t end, std::span<const Values> values,
                                   const std::array<double*, 3>& out) const
{
    run<false>(begin, end, values, out);
}

ExpressionValue ExpressionProgram::single(std::span<const Values> values) const
{
    Vector<3> v;
    run<true>(0, 1, values, {&v.x, &v.y, &v.z});
    const bool isVector = kind_ == Kind::vector;
    if (!std::isfinite(isVector ? dot(v, v) : v.x))
        fail(fmt::format("the result is {}", isVector ? "not a finite vector" : std::isnan(v.x) ? "not a number" : "infinite"));
    return isVector ? ExpressionValue{0, v} : ExpressionValue{v.x};
}

}
