// SPDX-License-Identifier: MIT
// A6: shear that is tiny beside the pressure, tiny strains, stresses from far below to far above
// the stiffness.
#include "formulas/plasticity.hpp"
#include "plasticity_cases.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("plasticity: pressure does not touch the shear", "[A6.1][plasticity]")
{
    for (int power = 0; power <= 60; power += 3) {
        CAPTURE(power);
        Matrix3d sigma = -3 * Matrix3d::Identity();
        sigma(0, 1) = sigma(1, 0) = std::ldexp(1, -power);
        sigma(1, 2) = sigma(2, 1) = -std::ldexp(3, -power);
        const Matrix3d found = deviator(sigma);
        REQUIRE_THAT(found(0, 1), IsClose(sigma(0, 1), Rounding(4)));
        REQUIRE_THAT(found(2, 1), IsClose(sigma(2, 1), Rounding(4)));
        REQUIRE_THAT(found(0, 2), IsClose(0.0, Rounding(4, std::ldexp(1, -power))));
    }
}

TEST_CASE("plasticity: shear does not touch the pressure", "[A6.1][plasticity]")
{
    for (int power = 0; power <= 100; power += 5) {
        CAPTURE(power);
        Matrix3d sigma = Vector3d(1, 2, 6).asDiagonal();
        sigma(0, 1) = sigma(1, 0) = std::ldexp(1, power);
        sigma(1, 2) = sigma(2, 1) = std::ldexp(-3, power);
        sigma(0, 2) = sigma(2, 0) = std::ldexp(5, power);
        const Vector3d found = deviator(sigma).diagonal();
        REQUIRE_THAT(found, IsClose(Vector3d(-2, -1, 3), Rounding(8, 6)));
    }
}

TEST_CASE("plasticity: a shear counts however small it is beside the pressure",
          "[A6.4][plasticity]")
{
    for (const double p : {1e-9, 1e-3, 1.0, 1e9})
        for (int power = 0; power <= 13; ++power) {
            const double tau = p * std::pow(10.0, -power);
            CAPTURE(p, tau);
            const Matrix3d sigma = shear(tau) - p * Matrix3d::Identity();
            REQUIRE_THAT(von_mises(sigma), IsClose(std::sqrt(3) * tau, Rounding(32, tau + 2 * p)));
        }
}

namespace {

// Pulls along an axis in a solid under pressure. The pull is 1 down to 2^-44 of the pressure, which
// is -1.
// @param mises  computes the von Mises stress of a stress
template <class Mises> void check_pull_under_pressure(const Mises& mises)
{
    for (int axis = 0; axis < 3; ++axis)
        for (int power = 0; power <= 44; ++power) {
            const double pull = std::ldexp(1.5, -power);
            CAPTURE(axis, pull);
            Matrix3d stress = -Matrix3d::Identity();
            stress(axis, axis) += pull;
            REQUIRE_THAT(mises(stress), IsClose(pull, Rounding(32, 3)));
        }
}

} // namespace

TEST_CASE("plasticity: a pull counts however small it is beside the pressure", "[A6.4][plasticity]")
{
    check_pull_under_pressure(von_mises);
}

TEST_CASE("plasticity: a stretch counts however small it is beside the change of volume",
          "[A6.6][plasticity]")
{
    check_pull_under_pressure(
        [](const Matrix3d& strain) { return von_mises_from_strain(strain, 0.5); });
}

TEST_CASE("plasticity: a shear strain counts however small it is beside the change of volume",
          "[A6.6][plasticity]")
{
    for (int power = 0; power <= 13; ++power)
        for (const double digits : {1.0, 3.0}) {
            const double gamma = digits * std::pow(10.0, -power);
            CAPTURE(gamma);
            const Matrix3d strain = shear(gamma) - Matrix3d::Identity();
            REQUIRE_THAT(von_mises_from_strain(strain, 2),
                         IsClose(4 * std::sqrt(3) * gamma, Rounding(32, 4 * (gamma + 2))));
        }
}

namespace {

// The von Mises stress in more digits and with a larger range of exponents.
double exact_mises(const Matrix3d& A)
{
    const auto a = [&A](int i, int j) -> long double { return A(i, j); };
    const auto squared = [](long double x) { return x * x; };
    const long double differences = squared(a(0, 0) - a(1, 1)) + squared(a(1, 1) - a(2, 2)) +
                                    squared(a(2, 2) - a(0, 0)),
                      shears = squared(a(0, 1)) + squared(a(1, 2)) + squared(a(2, 0));
    return static_cast<double>(std::sqrt(differences / 2 + 3 * shears));
}

// Tensors of two entries, or pairs of entries, at all places. One is smaller than the other by any
// factor from 2 to 1e200; both lie between 1e-100 and 1e100.
template <class Check> void with_unlike_entries(const Check& check)
{
    std::vector<double> ratios;
    for (int power = 1; power <= 40; ++power)
        ratios.push_back(1.5 * std::ldexp(1, -power));
    for (const double ratio : {-1e-20, 1e-60, -1e-100, 1e-140, 1e-200})
        ratios.push_back(ratio);
    for (int large = 0; large < 9; ++large)
        for (int small = 0; small < 9; ++small)
            for (const double ratio : ratios)
                for (const double size : {1e-50, 1.0, 1e100}) {
                    const int i = large / 3, j = large % 3, k = small / 3, l = small % 3;
                    if (i > j || k > l || large == small || size * std::abs(ratio) < 0.9e-100)
                        continue;
                    Matrix3d A = Matrix3d::Zero();
                    A(i, j) = A(j, i) = size;
                    A(k, l) = A(l, k) = ratio * size;
                    CAPTURE(i, j, k, l, size, ratio);
                    check(A);
                }
}

} // namespace

TEST_CASE("plasticity: principal stresses of very different sizes", "[A6.2][plasticity]")
{
    with_unlike_entries([](const Matrix3d& A) {
        if (!A.isDiagonal(0)) return;
        REQUIRE_THAT(von_mises_principal(A(0, 0), A(1, 1), A(2, 2)),
                     IsClose(exact_mises(A), Rounding(32)));
    });
}

TEST_CASE("plasticity: near every special state of stress", "[A6.2][plasticity]")
{
    // pure shear, tension, pressure on two sides; one stress is off by any factor
    for (const Vector3d& special : {Vector3d(1, 0, -1), Vector3d(1, 0, 0), Vector3d(1, 1, 0),
                                    Vector3d(2, -1, -1), Vector3d(3, 2, 1), Vector3d(-2, 0, 2)})
        for (int shift = 0; shift < 3; ++shift)
            for (int which = 0; which < 3; ++which)
                for (int power = 1; power <= 40; ++power)
                    for (const double sign : {1.0, -1.0}) {
                        CAPTURE(special, shift, which, power);
                        Vector3d s(special[shift], special[(shift + 1) % 3],
                                   special[(shift + 2) % 3]);
                        s[which] += sign * std::ldexp(1.5, -power);
                        REQUIRE_THAT(von_mises_principal(s[0], s[1], s[2]),
                                     IsClose(exact_mises(s.asDiagonal()), Rounding(32)));
                    }
}

TEST_CASE("plasticity: stresses of very different sizes", "[A6.3][plasticity]")
{
    with_unlike_entries([](const Matrix3d& A) {
        REQUIRE_THAT(von_mises_frobenius(A), IsClose(exact_mises(A), Rounding(16)));
    });
}

TEST_CASE("plasticity: entries of very different sizes", "[A6.4][plasticity]")
{
    with_unlike_entries([](const Matrix3d& A) {
        REQUIRE_THAT(von_mises(A), IsClose(exact_mises(A), Rounding(16)));
    });
}

TEST_CASE("plasticity: strains of very different sizes", "[A6.6][plasticity]")
{
    with_unlike_entries([](const Matrix3d& A) {
        REQUIRE_THAT(von_mises_from_strain(A, 3), IsClose(6 * exact_mises(A), Rounding(16)));
    });
}

TEST_CASE("plasticity: a strain counts however small it is", "[A6.6][plasticity]")
{
    for (Random random : seeds(10)) {
        const Matrix3d strain = random_symmetric(random);
        const double whole =
            std::sqrt(1.5) * (strain - strain.trace() / 3 * Matrix3d::Identity()).norm();
        for (int power = 0; power <= 140; power += 5) {
            const double scale = std::pow(10.0, -power);
            CAPTURE(scale);
            // a solid so stiff that the square of G is no double
            for (const double G : {3.0, 3 * std::pow(10.0, 1.25 * power)})
                REQUIRE_THAT(
                    von_mises_from_strain(scale * strain, G),
                    IsClose(2 * G * scale * whole, Rounding(128, 2 * G * scale * strain.norm())));
        }
    }
}

TEST_CASE("plasticity: soft and hard solids flow alike and keep their trace", "[A6.8][plasticity]")
{
    for (Random random : seeds(10)) {
        const Matrix3d strain = random_symmetric(random), stress = random_symmetric(random);
        const Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
        const double mises = std::sqrt(1.5) * s.norm();
        for (int power = -12; power <= 12; ++power)
            // no strength, next to none, and some
            for (const double share : {0.0, 1e-14, 1e-12, 1e-10, 1e-8, 1e-5, 0.5}) {
                const double G = std::pow(10.0, power);
                CAPTURE(G, share);
                const Matrix3d expected = strain + (1 - share) / (2 * G) * s;
                REQUIRE_THAT(plastic_flow(strain, stress, share * mises, G),
                             IsClose(expected, Rounding(64, strain.norm() + stress.norm() / G)));
            }
    }
}
