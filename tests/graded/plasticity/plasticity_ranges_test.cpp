// SPDX-License-Identifier: MIT
// A6: shear that is tiny beside the pressure, tiny strains, stresses from far below to far above
// the stiffness.
#include "formulas/plasticity.hpp"
#include "plasticity_cases.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

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

TEST_CASE("plasticity: a strain counts however small it is", "[A6.6][plasticity]")
{
    for (Random random : seeds(10)) {
        const Matrix3d strain = random_symmetric(random);
        const double whole =
            std::sqrt(1.5) * (strain - strain.trace() / 3 * Matrix3d::Identity()).norm();
        for (int power = 0; power <= 140; power += 5) {
            const double scale = std::pow(10.0, -power);
            CAPTURE(scale);
            REQUIRE_THAT(von_mises_from_strain(scale * strain, 3),
                         IsClose(6 * scale * whole, Rounding(128, 6 * scale * strain.norm())));
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
