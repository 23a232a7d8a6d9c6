// SPDX-License-Identifier: MIT
// A6: small shear beside a large pressure, and principal stresses that are nearly equal.
#include "formulas/plasticity.hpp"
#include "plasticity_cases.hpp"
#include "support/seeds.hpp"

namespace plasticity_strata_test {

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("plasticity: pressure does not change the stress of three principal ones",
          "[A6.2][plasticity]")
{
    for (int power = 1; power <= 50; ++power) { // every number is exact
        CAPTURE(power);
        const double p = std::ldexp(1, power), alone = von_mises_principal(3, -1, 0);
        REQUIRE_THAT(von_mises_principal(p + 3, p - 1, p), IsClose(alone, Rounding(16)));
        REQUIRE_THAT(von_mises_principal(3 - p, -1 - p, -p), IsClose(alone, Rounding(16)));
    }
}

TEST_CASE("plasticity: principal stresses with many digits beside a pressure", "[A6.2][plasticity]")
{
    for (Random random : seeds(5))
        for (int power = 0; power <= 40; ++power) {
            CAPTURE(power);
            const double p = std::ldexp(random.uniform(1, 2), power);
            const Vector3d sigma = Vector3d::Constant(p) + random.vector();
            REQUIRE_THAT(von_mises_principal(sigma[0], sigma[1], sigma[2]),
                         IsClose(mises_of(sigma.asDiagonal()), Rounding(16)));
        }
}

TEST_CASE("plasticity: nearly equal principal stresses", "[A6.2][plasticity]")
{
    // σ = (1, 1 + d, 0): 1/√2 √(d² + (1 + d)² + 1)
    for (int power = 1; power <= 50; ++power) {
        CAPTURE(power);
        const double d = std::ldexp(1, -power);
        const double expected = std::sqrt((d * d + (1 + d) * (1 + d) + 1) / 2);
        REQUIRE_THAT(von_mises_principal(1, 1 + d, 0), IsClose(expected, Rounding(16)));
        REQUIRE_THAT(von_mises_principal(0, 1, 1 + d), IsClose(expected, Rounding(16)));
        REQUIRE_THAT(von_mises_principal(1 + d, 0, 1), IsClose(expected, Rounding(16)));
    }
}

TEST_CASE("plasticity: a little shear under pressure counts as far as digits last",
          "[A6.3][plasticity]")
{
    // The terms that cancel are p² large, so √3 τ has an error of about eps p²/τ.
    for (int power = 0; power <= 23; ++power) {
        CAPTURE(power);
        const double p = std::ldexp(1, power);
        const Matrix3d sigma = p * Matrix3d::Identity() + shear(1);
        REQUIRE_THAT(von_mises_frobenius(sigma),
                     IsClose(std::sqrt(3.0), Rounding(64, std::sqrt(3.0) + p * p)));
    }
}

TEST_CASE("plasticity: λ is negative where a solid gets thicker as it is stretched",
          "[A6.5][plasticity]")
{
    const Matrix3d strain = diagonal(1, 2, 4) + shear(0.5);
    REQUIRE_THAT(isotropic_stress(strain, -0.5, 1),
                 IsClose(Matrix3d(diagonal(-1.5, 0.5, 4.5) + shear(1)), Rounding(16)));
}

} // namespace plasticity_strata_test
