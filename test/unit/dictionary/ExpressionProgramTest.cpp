/// Expressions that are read once and computed for rows of numbers.
#include "dictionary/ExpressionProgram.hpp"
#include <cmath>
#include <gtest/gtest.h>

using namespace sph;

namespace
{

using Kind = ExpressionProgram::Kind;

/// x and U are of each particle, a of all; "later" is not known yet.
Kind kindOf(const std::string& name)
{
    if (name == "later") return Kind::unknown;
    if (name == "U" || name == "g") return Kind::vector;
    return name == "x" || name == "a" ? Kind::number : throw ExpressionError("$" + name + " is unknown");
}

std::string mistakeOf(const std::string& text)
{
    try
    {
        ExpressionProgram program(text, kindOf);
    }
    catch (const ExpressionError& e)
    {
        return e.what();
    }
    return "";
}

/// 300 particles: more than two blocks of rows, the last one not full.
struct Rows
{
    std::vector<double> x, u, v;
    Rows()
    {
        for (int i = 0; i < 300; ++i)
        {
            x.push_back(i - 100);
            u.push_back(0.5 * i);
            v.push_back(3);
        }
    }
    std::vector<ExpressionProgram::Values> valuesOf(const ExpressionProgram& program) const
    {
        std::vector<ExpressionProgram::Values> values;
        for (const auto& name : program.names())
            values.push_back(name == "x"   ? ExpressionProgram::Values{{x.data()}, {}}
                             : name == "U" ? ExpressionProgram::Values{{u.data(), v.data(), nullptr}, {}}
                             : name == "g" ? ExpressionProgram::Values{{}, {0, -10, 0}}
                                           : ExpressionProgram::Values{{}, {7, 0, 0}});
        return values;
    }
    std::vector<double> of(const std::string& text, std::size_t begin = 0) const
    {
        const ExpressionProgram program(text, kindOf);
        EXPECT_EQ(program.kind(), Kind::number);
        std::vector<double> result(x.size() - begin);
        program(begin, x.size(), valuesOf(program), {result.data()});
        return result;
    }
};

}

// Against the same arithmetic by hand at each particle, to the bit where there is one operation a line, else to round-off.
TEST(ExpressionProgram, isComputedForEachParticle)
{
    const Rows rows;
    const auto linear = rows.of("$a*$x"), both = rows.of("$x > 0 && $x < 10 ? sqrt($x) + $a^2 : -1"), product = rows.of("dot($U, $g)"),
               speed = rows.of("mag(2*$U - $g/10)"), late = rows.of("$x", 250);
    for (std::size_t i = 0; i < rows.x.size(); ++i)
    {
        const double x = rows.x[i], u = rows.u[i];
        EXPECT_EQ(linear[i], 7 * x);
        EXPECT_DOUBLE_EQ(both[i], x > 0 && x < 10 ? std::sqrt(x) + 49 : -1);
        EXPECT_EQ(product[i], -30);
        EXPECT_DOUBLE_EQ(speed[i], std::hypot(2 * u, 7));
    }
    ASSERT_EQ(late.size(), 50u);
    EXPECT_EQ(late[0], rows.x[250]);
}

// A pole in the side that is not chosen, and one that is: the numbers of IEEE, and no end of a run.
TEST(ExpressionProgram, goesOnWhereAValueHasNoMeaning)
{
    const Rows rows;
    const auto guarded = rows.of("$x == 0 ? 5 : 1/$x"), plain = rows.of("1/$x");
    EXPECT_EQ(guarded[100], 5);
    EXPECT_EQ(guarded[102], 0.5);
    EXPECT_TRUE(std::isinf(plain[100]));
}

TEST(ExpressionProgram, givesVectors)
{
    const Rows rows;
    const ExpressionProgram program("$x*$U + vector(0, 0, $a)", kindOf);
    ASSERT_EQ(program.kind(), Kind::vector);
    EXPECT_EQ(program.names(), (std::vector<std::string>{"x", "U", "a"}));
    std::vector<double> a(300), b(300), c(300);
    program(0, 300, rows.valuesOf(program), {a.data(), b.data(), c.data()});
    for (std::size_t i = 0; i < 300; ++i)
    {
        EXPECT_EQ(a[i], rows.x[i] * rows.u[i]);
        EXPECT_EQ(b[i], rows.x[i] * 3);
        EXPECT_EQ(c[i], 7);
    }
}

// Names whose kind is not known yet go with anything; mistakes that can be seen without it are.
TEST(ExpressionProgram, textsAreLookedThroughBeforeTheirNamesAreKnown)
{
    for (const char* text : {"$later*$U", "mag($later) + 1", "dot($later, $g)", "$later + $U", "$x > 0 ? $later : 3", "-$later/2"})
        EXPECT_EQ(mistakeOf(text), "") << text;
    EXPECT_EQ(mistakeOf("$later + "), "a value is missing at the end");
    EXPECT_EQ(mistakeOf("$U*$g"), "two vectors are multiplied: dot(a, b) is their product");
    EXPECT_EQ(mistakeOf("$U + 1"), "a number is added to a vector");
    EXPECT_EQ(mistakeOf("$x ? $U : 1"), "a condition chooses between a number and a vector");
    EXPECT_EQ(mistakeOf("dot($x, $U)"), "dot() takes two vectors");
    EXPECT_EQ(mistakeOf("$y"), "$y is unknown");
}
