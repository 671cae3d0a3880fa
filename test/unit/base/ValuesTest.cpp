/// Tensors and plane-strain stresses against values by hand and against one another, and what the trait says of each type.
#include "base/values.hpp"
#include <gtest/gtest.h>
#include <vector>

namespace sph
{
namespace
{

constexpr double pi = 3.14159265358979323846;

template<class T> std::vector<double> numbers(const T& q)
{
    std::vector<double> all(std::size_t(components<T>), 0.0);
    store(q, [&](int c, double a) { all[std::size_t(c)] = a; });
    return all;
}

/// Equal but for round-off of numbers of size 1 to 10.
template<class T> void expectNear(const T& a, const T& b, double tolerance = 1e-14)
{
    const auto p = numbers(a), q = numbers(b);
    for (std::size_t c = 0; c < p.size(); ++c) EXPECT_NEAR(p[c], q[c], tolerance) << "component " << c;
}

Tensor<2> turn(double angle) { return {std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)}; }
Tensor<3> turnAboutZ(double angle) { return {std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1}; }

/// What one loop may sum.
template<int dim> struct Sums
{
    Tensor<dim> gradient;
    double volume = 0;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.gradient, q.volume); }
};

/// Written by `store` as 1, 2, 3 ... and read back by `fetch`, number by number.
template<class T> void roundTrip()
{
    T q, again;
    fetch(q, [](int c) { return c + 1.0; });
    const auto all = numbers(q);
    for (std::size_t c = 0; c < all.size(); ++c) EXPECT_EQ(all[c], double(c + 1));
    fetch(again, [&](int c) { return all[std::size_t(c)]; });
    EXPECT_EQ(numbers(again), all);
    EXPECT_EQ(std::size_t(components<T>) * sizeof(double), sizeof(T));
}

// Every value has as many numbers as doubles, in the order in which its parts are declared.
TEST(Values, AreFetchedAndStoredPartByPart)
{
    roundTrip<double>();
    roundTrip<Label>();
    roundTrip<Vector<2>>();
    roundTrip<Vector<3>>();
    roundTrip<SymmTensor<2>>();
    roundTrip<SymmTensor<3>>();
    roundTrip<Tensor<2>>();
    roundTrip<Tensor<3>>();
    roundTrip<PlaneStrainStress>();
    roundTrip<Sums<2>>();
    roundTrip<Sums<3>>();
}

// OpenFOAM's order on disk: a component that a 2-D scene lacks leaves its place empty, and the stress in plane strain has its zz.
TEST(Values, HaveAClassAndPlacesOnDisk)
{
    const auto places = [](const ValueType& t) { return std::vector<int>(t.place.begin(), t.place.begin() + t.components); };
    EXPECT_EQ(valueType<double>.fieldClass, FieldClass::scalar);
    EXPECT_EQ(valueType<Label>.fieldClass, FieldClass::label);
    EXPECT_EQ(valueType<Vector<2>>.fieldClass, FieldClass::vector);
    EXPECT_EQ(places(valueType<Vector<2>>), (std::vector{0, 1}));
    EXPECT_EQ(valueType<SymmTensor<2>>.fieldClass, FieldClass::symmTensor);
    EXPECT_EQ(places(valueType<SymmTensor<2>>), (std::vector{0, 1, 3}));
    EXPECT_EQ(valueType<PlaneStrainStress>.fieldClass, FieldClass::symmTensor);
    EXPECT_EQ(places(valueType<PlaneStrainStress>), (std::vector{0, 1, 3, 5}));
    EXPECT_EQ(valueType<Tensor<2>>.fieldClass, FieldClass::tensor);
    EXPECT_EQ(places(valueType<Tensor<2>>), (std::vector{0, 1, 3, 4}));
    EXPECT_EQ(places(valueType<Tensor<3>>), (std::vector{0, 1, 2, 3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(valueType<StressTensor<3>>, valueType<SymmTensor<3>>);
}

// Values by hand: L = (1 2; 3 4) has the strain rate (1 2.5; 2.5 4) and the spin (0 -0.5; 0.5 0), det L = -2, L:L = 30.
TEST(Tensor, HasTheAlgebraOfAVelocityGradient)
{
    constexpr Tensor<2> L{1, 2, 3, 4};
    expectNear(symm(L), {1, 2.5, 4});
    EXPECT_EQ(skew(L), (Tensor<2>{0, -0.5, 0.5, 0}));
    EXPECT_EQ(full(symm(L)) + skew(L), L);
    EXPECT_EQ(transpose(L), (Tensor<2>{1, 3, 2, 4}));
    EXPECT_EQ(L * (Vector<2>{5, 6}), (Vector<2>{17, 39}));
    EXPECT_EQ(L * L, (Tensor<2>{7, 10, 15, 22}));
    EXPECT_EQ(outer(Vector<2>{1, 2}, Vector<2>{3, 4}), (Tensor<2>{3, 4, 6, 8}));
    EXPECT_EQ(trace(L), 5);
    EXPECT_EQ(doubleDot(L, L), 30);
    EXPECT_EQ(determinant(L), -2);
    EXPECT_EQ(inverse(L), (Tensor<2>{-2, 1, 1.5, -0.5}));
}

// Values by hand, expanded along the first row of (2 1 0; 0 3 1; 3 0 3): det = 2*9 - 1*(0 - 3) = 21.
TEST(Tensor, HasTheSameAlgebraInSpace)
{
    constexpr Tensor<3> L{2, 1, 0, 0, 3, 1, 3, 0, 3}, unit{1, 0, 0, 0, 1, 0, 0, 0, 1};
    EXPECT_EQ(determinant(L), 21);
    expectNear(L * inverse(L), unit);
    expectNear(inverse(L) * L, unit);
    EXPECT_EQ(L * (Vector<3>{1, 2, 3}), (Vector<3>{4, 9, 12}));
    EXPECT_EQ(transpose(transpose(L)), L);
    EXPECT_EQ(transpose(L) * transpose(L), transpose(L * L));
    EXPECT_EQ(full(symm(L)) + skew(L), L);
    EXPECT_EQ(trace(outer(Vector<3>{1, 2, 3}, Vector<3>{4, 5, 6})), 32);
    EXPECT_EQ(doubleDot(L, unit), trace(L));
    EXPECT_EQ(doubleDot(full(symm(L)), skew(L)), 0);
}

// The image of a b is that of a times that of b, and the image of an image is the tensor itself. R S R for the symmetric part is the same.
TEST(Tensor, IsMirroredLikeTheVectorsThatItIsMadeOf)
{
    const Vector<3> a{1, 2, 3}, b{-2, 0.5, 1}, n{2.0 / 3, -1.0 / 3, 2.0 / 3};
    expectNear(mirrored(outer(a, b), n), outer(mirrored(a, n), mirrored(b, n)));
    expectNear(mirrored(mirrored(outer(a, b), n), n), outer(a, b));
    expectNear(symm(mirrored(outer(a, b), n)), mirrored(symm(outer(a, b)), n));
    const Vector<2> c{1, 2}, d{3, -1}, m{0.6, 0.8};
    expectNear(mirrored(outer(c, d), m), outer(mirrored(c, m), mirrored(d, m)));
    EXPECT_EQ(mirrored(4.0, m), 4.0);
}

// By hand: xx = 1, yy = 2, zz = 6 has the mean 3 and the deviator (-2, -1, 3). Acting in the plane, zz does no work and makes no force.
TEST(PlaneStrainStress, HasAComponentOutOfThePlane)
{
    constexpr PlaneStrainStress S{1, 0.5, 2, 6};
    EXPECT_EQ(trace(S), 9);
    expectNear(deviator(S), {-2, 0.5, -1, 3});
    EXPECT_EQ(trace(deviator(S)), 0);
    EXPECT_EQ(S * (Vector<2>{2, 4}), (Vector<2>{4, 9}));
    EXPECT_EQ(doubleDot(S, SymmTensor<2>{1, 2, 3}), 1 + 2 * 0.5 * 2 + 6);
    EXPECT_EQ(doubleDot(S, S), 1 + 2 * 0.25 + 4 + 36);
    expectNear(inPlane(S), {1, 0.5, 2});
    expectNear(S + 2 * S - S, {2, 1, 4, 12});
}

// Whatever it does is what the stress in space does, of which it is four components. Mirrored twice it is itself.
TEST(PlaneStrainStress, IsTheStressInSpace)
{
    const PlaneStrainStress S{1, -0.5, 2, 6};
    const SymmTensor<3> full = in3D(S);
    const Vector<2> n{0.6, -0.8};
    expectNear(in3D(deviator(S)), deviator(full));
    expectNear(in3D(mirrored(S, n)), mirrored(full, in3D(n)));
    expectNear(mirrored(mirrored(S, n), n), S);
    expectNear(in3D(rotated(S, turn(0.3))), rotated(full, turnAboutZ(0.3)));
    expectNear(in3D(turning(S, {0, -2, 2, 0})), turning(full, {0, -2, 0, 2, 0, 0, 0, 0, 0}));
    EXPECT_EQ(doubleDot(S, S), doubleDot(full, full));
}

// By hand: uniaxial tension along x, turned by a quarter, is tension along y.
TEST(StressTensor, IsRotated)
{
    expectNear(rotated(PlaneStrainStress{1, 0, 0, 3}, turn(pi / 2)), {0, 0, 1, 3});
    expectNear(rotated(SymmTensor<3>{1, 0, 0, 0, 0, 3}, turnAboutZ(pi / 2)), {0, 0, 0, 1, 0, 3});
}

// A body in rigid rotation at 1 rad/s has W = skew(dv_i/dx_j) = (0 -1; 1 0): after the angle d its stress is the rotated one, up to d^2 S,
// and the Jaumann rate of that motion, (S(d) - S(-d))/2d + S.W - W.S, vanishes up to d^2.
TEST(StressTensor, TurnsWithARigidRotation)
{
    const double d = 1e-4;
    const PlaneStrainStress S{1, -0.5, 2, 6};
    expectNear(1 / (2 * d) * (rotated(S, turn(d)) - rotated(S, turn(-d))), turning(S, {0, -1, 1, 0}), 1e-7);
    const SymmTensor<3> T{1, 2, 3, 4, 5, 6};
    expectNear(1 / (2 * d) * (rotated(T, turnAboutZ(d)) - rotated(T, turnAboutZ(-d))), turning(T, {0, -1, 0, 1, 0, 0, 0, 0, 0}), 1e-7);
    EXPECT_EQ(trace(turning(T, {0, -1, 2, 1, 0, -3, -2, 3, 0})), 0);
}

// By hand: (0 1; 1 0) in the plane has 1 and -1, and zz comes between, before or behind. Turned they stay; in space they are the same.
TEST(StressTensor, HasThreePrincipalValues)
{
    EXPECT_EQ(principalValues(PlaneStrainStress{0, 1, 0, 0.5}), (std::array{1.0, 0.5, -1.0}));
    EXPECT_EQ(principalValues(PlaneStrainStress{0, 1, 0, 5}), (std::array{5.0, 1.0, -1.0}));
    EXPECT_EQ(principalValues(PlaneStrainStress{0, 1, 0, -5}), (std::array{1.0, -1.0, -5.0}));
    const PlaneStrainStress S{3, -0.5, 2, -1};
    const auto expected = principalValues(S);
    for (const auto& found : {principalValues(rotated(S, turn(0.7))), principalValues(in3D(S))})
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 1e-14);
    EXPECT_EQ(principalValues(SymmTensor<3>{2, 0, 0, 2, 0, 2}), (std::array{2.0, 2.0, 2.0}));
}

// A whole number is one in every expression that a double is.
TEST(Label, IsComputedWith)
{
    const Label oil = 1, water = 0;
    EXPECT_EQ(oil - water, 1.0);
    EXPECT_EQ(1 - oil, 0.0);
    EXPECT_TRUE(oil == 1.0 && water != oil);
}

}
}
