// SPDX-License-Identifier: MIT
// A6: stresses and strains of every structure, and those with entries of very different sizes.
#include "formulas/plasticity.hpp"
#include "graded/laws/tensor_patterns.hpp"
#include "plasticity_cases.hpp"
#include "support/seeds.hpp"

namespace plasticity_patterns_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// A shear of 1 in the plane of the axes i and i + 1, and differences d on the diagonal.
Matrix3d shear_and_diagonal(int i, double d)
{
    Matrix3d A = diagonal(d, 0, 0);
    const int k = (i + 1) % 3;
    A(i, k) = A(k, i) = 1;
    return A;
}

} // namespace

TEST_CASE("plasticity: the deviator of stresses of every structure", "[A6.1][plasticity]")
{
    for (const Matrix3d& sigma : tensor_patterns())
        REQUIRE_THAT(deviator(sigma), IsClose(deviator_of(sigma), Rounding(8, sigma.norm())));
}

TEST_CASE("plasticity: principal stresses in any order", "[A6.2][plasticity]")
{
    constexpr double values[] = {-3, -1, 0, 1, 4};
    for (const double a : values)
        for (const double b : values)
            for (const double c : values)
                REQUIRE_THAT(von_mises_principal(a, b, c),
                             IsClose(mises_of(diagonal(a, b, c)), Rounding(16, 4)));
}

TEST_CASE("plasticity: the von Mises stress by the norm of stresses of every structure",
          "[A6.3][plasticity]")
{
    for (const Matrix3d& sigma : tensor_patterns())
        REQUIRE_THAT(von_mises_frobenius(sigma),
                     IsClose(mises_of(sigma), Rounding(32, sigma.norm())));
}

TEST_CASE("plasticity: the von Mises stress of stresses of every structure", "[A6.4][plasticity]")
{
    for (const Matrix3d& sigma : tensor_patterns())
        REQUIRE_THAT(von_mises(sigma), IsClose(mises_of(sigma), Rounding(32, sigma.norm())));
}

TEST_CASE("plasticity: the stress of strains of every structure", "[A6.5][plasticity]")
{
    for (const double lambda : {0., 1.5})
        for (const double G : {0., 0.75})
            for (const Matrix3d& strain : tensor_patterns()) {
                const Matrix3d pressure = lambda * strain.trace() * Matrix3d::Identity();
                REQUIRE_THAT(isotropic_stress(strain, lambda, G),
                             IsClose(Matrix3d(pressure + 2 * G * strain),
                                     Rounding(16, (3 * lambda + 2 * G) * strain.norm())));
            }
}

TEST_CASE("plasticity: the von Mises stress of strains of every structure", "[A6.6][plasticity]")
{
    const double G = 0.75;
    for (const Matrix3d& strain : tensor_patterns())
        REQUIRE_THAT(von_mises_from_strain(strain, G),
                     IsClose(2 * G * mises_of(strain), Rounding(64, 2 * G * strain.norm())));
}

TEST_CASE("plasticity: small differences beside a shear count by the norm", "[A6.3][plasticity]")
{
    for (int i = 0; i < 3; ++i)
        for (int power = 8; power <= 100; ++power) {
            const double d = std::exp2(-power / 4.0);
            const Matrix3d sigma = shear_and_diagonal(i, d);
            REQUIRE_THAT(von_mises_frobenius(sigma),
                         IsClose(mises_of(sigma), Rounding(32, sigma.norm())));
        }
}

TEST_CASE("plasticity: a small shear beside a pressure of any size", "[A6.4][plasticity]")
{
    for (int size = -330; size <= 330; size += 22)
        for (int power = 1; power <= 45; power += 4) {
            const double p = std::ldexp(1, size), tau = std::ldexp(p, -power);
            REQUIRE_THAT(von_mises(shear(tau) - p * Matrix3d::Identity()),
                         IsClose(std::sqrt(3) * tau, Rounding(32, p)));
        }
}

TEST_CASE("plasticity: a yield strain at both ends of the range of stresses", "[A6.7][plasticity]")
{
    for (const double stress : {1e-100, 1., 1e100})
        for (const double G : {1e-100, 1., 1e100})
            REQUIRE_THAT(yield_strain(stress, G), IsClose(stress / G / 2, Rounding(8)));
}

TEST_CASE("plasticity: what flowed before does not limit the flow", "[A6.8][plasticity]")
{
    for (Random random : seeds(10)) {
        const Matrix3d stress = random_symmetric(random), s = deviator_of(stress);
        const double mises = mises_of(stress), G = random.uniform(0.5, 5);
        for (int power = -20; power <= 60; power += 2)
            for (const double sign : {1., -1.}) { // with the flow before, and against it
                const Matrix3d before = sign * std::ldexp(1, -power) * s / s.norm();
                const double share = 0.25;
                const Matrix3d expected = before + (1 - share) / (2 * G) * s;
                REQUIRE_THAT(plastic_flow(before, stress, share * mises, G),
                             IsClose(expected, Rounding(64, before.norm() + stress.norm() / G)));
            }
    }
}

// The deviator has an error of about eps times the pressure, so down to here the flow keeps digits.
TEST_CASE("plasticity: a large pressure hides no flow", "[A6.8][plasticity]")
{
    const double G = 0.75, tau = 1, strength = tau; // the von Mises stress is √3 τ
    for (int power = 0; power <= 45; ++power)
        for (const double sign : {1., -1.}) {
            CAPTURE(power, sign);
            const double p = sign * std::ldexp(1, power);
            const Matrix3d stress = shear(tau) + p * Matrix3d::Identity();
            const Matrix3d flow = (1 - strength / (std::sqrt(3) * tau)) / (2 * G) * shear(tau);
            REQUIRE_THAT(plastic_flow(Matrix3d::Zero(), stress, strength, G),
                         IsClose(flow, Rounding(64, (tau + std::abs(p)) / G)));
        }
}

} // namespace plasticity_patterns_test
