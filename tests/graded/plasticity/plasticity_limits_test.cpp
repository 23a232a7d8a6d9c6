// SPDX-License-Identifier: MIT
// A6: plastic strains with a trace, stresses at the yield surface, small deviators.
#include "formulas/plasticity.hpp"
#include "plasticity_cases.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("plasticity: a plastic strain keeps its trace", "[A6.8][plasticity]")
{
    for (Random random : seeds(50)) {
        const Matrix3d strain = random_symmetric(random), stress = random_symmetric(random);
        const double G = random.uniform(0.5, 5);
        const Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
        const double mises = std::sqrt(1.5) * s.norm();
        for (const double share : {0.2, 0.9, 1.5}) { // at 1.5 it does not yield
            CAPTURE(share);
            const double f = std::max(0.0, mises - share * mises);
            const Matrix3d expected = strain + f / (3 * G) * std::sqrt(1.5) * s / s.norm();
            REQUIRE_THAT(plastic_flow(strain, stress, share * mises, G),
                         IsClose(expected, Rounding(64, strain.norm() + stress.norm() / G)));
        }
    }
}

TEST_CASE("plasticity: a stress that has just yielded flows by as little", "[A6.8][plasticity]")
{
    for (Random random : seeds(20)) {
        const Matrix3d stress = random_symmetric(random);
        const Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
        const double mises = std::sqrt(1.5) * s.norm();
        for (const double d : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11}) {
            CAPTURE(d);
            const Matrix3d expected = d * mises / 3 * std::sqrt(1.5) * s / s.norm();
            REQUIRE_THAT(plastic_flow(Matrix3d::Zero(), stress, (1 - d) * mises, 1),
                         IsClose(expected, Rounding(64, stress.norm())));
        }
    }
}
