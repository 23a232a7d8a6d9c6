// SPDX-License-Identifier: MIT
// A6: plastic strains with a trace, stresses at the yield surface, small deviators.
#include "formulas/plasticity.hpp"
#include "plasticity_cases.hpp"
#include "support/seeds.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("plasticity: two principal stresses that are nearly equal", "[A6.4][plasticity]")
{
    for (int power = 1; power <= 44; ++power)
        for (int axis = 0; axis < 3; ++axis) {
            const double s = std::ldexp(1, -power);
            CAPTURE(s, axis);
            Vector3d stresses(0, 0, 0);
            stresses[axis] = 1;
            stresses[(axis + 1) % 3] = s;
            REQUIRE_THAT(von_mises(stresses.asDiagonal()),
                         IsClose(std::sqrt(1 - s + s * s), Rounding(16)));
        }
}

TEST_CASE("plasticity: a plastic strain keeps its trace", "[A6.8][plasticity]")
{
    for (Random random : seeds(50)) {
        const Matrix3d strain = random_symmetric(random), stress = random_symmetric(random);
        const double G = random.uniform(0.5, 5);
        const Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
        const double mises = std::sqrt(1.5) * s.norm();
        for (const double share : {0.2, 0.9, 1.5}) { // at 1.5 the solid does not yield
            CAPTURE(share);
            const double f = std::max(0.0, mises - share * mises);
            const Matrix3d expected = strain + f / (3 * G) * std::sqrt(1.5) * s / s.norm();
            REQUIRE_THAT(plastic_flow(strain, stress, share * mises, G),
                         IsClose(expected, Rounding(64, strain.norm() + stress.norm() / G)));
        }
    }
}

TEST_CASE("plasticity: a large pressure changes nothing of the flow", "[A6.8][plasticity]")
{
    for (Random random : seeds(20)) {
        const Matrix3d small = random_symmetric(random);
        for (const double pressure : {-1e6, -1e5, -1e3, 1e3, 1e5, 1e6}) {
            CAPTURE(pressure);
            const Matrix3d stress = small + pressure * Matrix3d::Identity();
            const Matrix3d s = small - small.trace() / 3 * Matrix3d::Identity();
            const double mises = std::sqrt(1.5) * s.norm();
            const Matrix3d expected = mises / 2 / 3 * std::sqrt(1.5) * s / s.norm();
            // the entries of the stress are rounded at the size of the pressure
            REQUIRE_THAT(plastic_flow(Matrix3d::Zero(), stress, mises / 2, 1),
                         IsClose(expected, Rounding(64, stress.norm())));
        }
    }
}

TEST_CASE("plasticity: a stress that has just yielded flows by as little", "[A6.8][plasticity]")
{
    for (Random random : seeds(20)) {
        const Matrix3d stress = random_symmetric(random);
        const Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
        const double mises = std::sqrt(1.5) * s.norm();
        for (const double d : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-12, 2e-13}) {
            CAPTURE(d);
            const Matrix3d expected = d * mises / 3 * std::sqrt(1.5) * s / s.norm();
            REQUIRE_THAT(plastic_flow(Matrix3d::Zero(), stress, (1 - d) * mises, 1),
                         IsClose(expected, Rounding(64, stress.norm())));
        }
    }
}

TEST_CASE("plasticity: a small change of shape beside a large change of volume counts",
          "[A6.6][plasticity]")
{
    // √(3/2) ‖dev ε‖ is √3 √(a² + b²). The sums p + a and p - a are exact, and dev ε is off by no
    // more than the rounding of ε.
    for (const double p : {-0.125, -0x1p-10, 0x1p-60, 0x1p-30, 0x1p-10, 0.125, 1.0, 64.0, 0x1p40})
        for (int power = 1; power <= 40; ++power)
            for (const double share : {0.0, 0.5, 1.0}) {
                CAPTURE(p, power, share);
                const double a = std::ldexp(std::abs(p) * share, -power),
                             b = std::ldexp(std::abs(p), -power);
                Matrix3d strain = p * Matrix3d::Identity();
                strain(0, 0) += a;
                strain(2, 2) -= a;
                strain(0, 1) = strain(1, 0) = b;
                const double G = 5, expected = 2 * G * std::sqrt(3) * std::hypot(a, b);
                REQUIRE_THAT(von_mises_from_strain(strain, G),
                             IsClose(expected, Rounding(16, 2 * G * strain.norm())));
            }
}

// Tensors whose trace is a power of two times their norm, or 0, and their deviators.
template <class Check> void for_small_traces(const Check& check)
{
    for (Random random : seeds(3)) {
        const Matrix3d s = deviator_of(random_symmetric(random));
        for (int power = 1; power <= 52; ++power) {
            CAPTURE(power);
            const double t = power == 52 ? 0 : std::ldexp(s.norm(), -power);
            check(Matrix3d(s + t * Matrix3d::Identity()), s);
        }
    }
}

TEST_CASE("plasticity: a trace that is nearly 0 still counts", "[A6.1][plasticity]")
{
    for_small_traces([](const Matrix3d& stress, const Matrix3d& s) {
        REQUIRE_THAT(deviator(stress), IsClose(s, Rounding(16, stress.norm())));
    });
}

TEST_CASE("plasticity: a pressure that is nearly 0 is no shear", "[A6.4][plasticity]")
{
    for_small_traces([](const Matrix3d& stress, const Matrix3d& s) {
        REQUIRE_THAT(von_mises(stress), IsClose(mises_of(s), Rounding(16, stress.norm())));
    });
}

TEST_CASE("plasticity: a change of volume that is nearly 0 is no shear", "[A6.6][plasticity]")
{
    for_small_traces([](const Matrix3d& strain, const Matrix3d& s) {
        REQUIRE_THAT(von_mises_from_strain(strain, 5),
                     IsClose(10 * mises_of(s), Rounding(16, 10 * strain.norm())));
    });
}

TEST_CASE("plasticity: a pressure that is nearly 0 does not flow", "[A6.8][plasticity]")
{
    for_small_traces([](const Matrix3d& stress, const Matrix3d& s) {
        const Matrix3d expected = mises_of(s) / 12 * std::sqrt(1.5) * s / s.norm();
        REQUIRE_THAT(plastic_flow(Matrix3d::Zero(), stress, mises_of(s) / 2, 2),
                     IsClose(expected, Rounding(64, stress.norm())));
    });
}
