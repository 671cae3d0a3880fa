/// A number of single precision that stays one beside doubles: what a term multiplies it with, constants and coefficients, is rounded to single precision first. With `float`
/// itself each `0.5 * q` would be a double, and lanes of the loop half as many.
#pragma once
#include <cmath>

namespace sph
{

struct Single
{
    float value = 0;
    constexpr Single() = default;
    constexpr Single(double q) : value(float(q)) {}
    constexpr explicit operator float() const { return value; }
    constexpr explicit operator double() const { return value; }
    constexpr explicit operator int() const { return int(value); }

    constexpr Single& operator+=(Single b) { return *this = *this + b; }
    constexpr Single& operator-=(Single b) { return *this = *this - b; }
    constexpr Single& operator*=(Single b) { return *this = *this * b; }
    constexpr Single& operator/=(Single b) { return *this = *this / b; }
    friend constexpr Single operator-(Single a) { return of(-a.value); }
    friend constexpr Single operator+(Single a, Single b) { return of(a.value + b.value); }
    friend constexpr Single operator-(Single a, Single b) { return of(a.value - b.value); }
    friend constexpr Single operator*(Single a, Single b) { return of(a.value * b.value); }
    friend constexpr Single operator/(Single a, Single b) { return of(a.value / b.value); }
    friend constexpr bool operator==(Single a, Single b) { return a.value == b.value; }
    friend constexpr bool operator<(Single a, Single b) { return a.value < b.value; }
    friend constexpr bool operator>(Single a, Single b) { return a.value > b.value; }
    friend constexpr bool operator<=(Single a, Single b) { return a.value <= b.value; }
    friend constexpr bool operator>=(Single a, Single b) { return a.value >= b.value; }
    friend Single sqrt(Single a) { return of(std::sqrt(a.value)); }
    friend Single fabs(Single a) { return of(std::fabs(a.value)); }
    friend Single fmax(Single a, Single b) { return of(std::fmax(a.value, b.value)); }
    friend Single fmin(Single a, Single b) { return of(std::fmin(a.value, b.value)); }

    static constexpr Single of(float q)
    {
        Single a;
        a.value = q;
        return a;
    }
};

/// A positive number far below all that terms divide by, in the precision of the argument: it keeps 0/0 away.
constexpr double smallest(double) { return 1e-300; }
constexpr Single smallest(Single) { return 1e-37; }

constexpr Single sqr(Single a) { return a * a; }

}
