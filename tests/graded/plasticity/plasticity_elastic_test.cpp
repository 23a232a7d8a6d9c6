// SPDX-License-Identifier: MIT
// A6.5 to A6.7: linear elasticity, and the von Mises stress directly from the strain.
#include "formulas/plasticity.hpp"
#include "plasticity_cases.hpp"
#include "support/seeds.hpp"

#include <limits>

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("plasticity: the stress of a strain by hand", "[A6.5][plasticity]")
{
    Matrix3d strain, expected;
    strain << 1, 2, 0, 2, -1, 0, 0, 0, 4;      // trace 4
    expected << 14, 12, 0, 12, 2, 0, 0, 0, 32; // 2·4 on the diagonal, plus 6 times the strain

    REQUIRE_THAT(isotropic_stress(strain, 2, 3), IsClose(expected, Rounding(8, 32)));
    REQUIRE_THAT(isotropic_stress(Matrix3d::Zero(), 2, 3), IsExactly(Matrix3d(Matrix3d::Zero())));
    REQUIRE_THAT(isotropic_stress(strain, 0, 0), IsExactly(Matrix3d(Matrix3d::Zero())));
}

TEST_CASE("plasticity: a rod that thins as Poisson says is free of stress across",
          "[A6.5][plasticity]")
{
    const double e = 1e-3;
    const Matrix3d stress =
        isotropic_stress(diagonal(e, -steel::nu * e, -steel::nu * e), steel::lambda, steel::G);
    REQUIRE_THAT(stress, IsClose(diagonal(steel::E * e, 0, 0), Rounding(16, steel::E * e)));
}

TEST_CASE("plasticity: stress turns and adds up with strain", "[A6.5][plasticity]")
{
    for (Random random : seeds(100)) {
        const Matrix3d a = random_symmetric(random), b = random_symmetric(random);
        const Matrix3d R = random.rotation();
        const double lambda = random.uniform(0, 2), G = random.uniform(0, 2);
        const auto stress = [&](const Matrix3d& strain) {
            return isotropic_stress(strain, lambda, G);
        };
        const Tolerance rounding = Rounding(32, (3 * lambda + 2 * G) * (a.norm() + b.norm()));
        const Matrix3d of_a = stress(a);

        REQUIRE_THAT(stress(turned(R, a)), IsClose(turned(R, of_a), rounding));
        REQUIRE_THAT(stress(a + b), IsClose(Matrix3d(of_a + stress(b)), rounding));
        INFO("Tr σ = (3 λ + 2 G) Tr ε");
        REQUIRE_THAT(of_a.trace(), IsClose((3 * lambda + 2 * G) * a.trace(), rounding));
        INFO("shear stresses are 2 G times shear strains");
        REQUIRE_THAT(of_a(0, 1), IsClose(2 * G * a(0, 1), rounding));
    }
}

TEST_CASE("plasticity: the von Mises stress of strains by hand", "[A6.6][plasticity]")
{
    const double e = 1e-3;
    // at constant width 2 G e; with Poisson's change of width E e; in simple shear 2 G √3 e
    REQUIRE_THAT(von_mises_from_strain(diagonal(e, 0, 0), steel::G),
                 IsClose(2 * steel::G * e, Rounding(32)));
    REQUIRE_THAT(von_mises_from_strain(diagonal(-steel::nu * e, e, -steel::nu * e), steel::G),
                 IsClose(steel::E * e, Rounding(64)));
    REQUIRE_THAT(von_mises_from_strain(shear(e), steel::G),
                 IsClose(2 * steel::G * std::sqrt(3) * e, Rounding(32)));
}

TEST_CASE("plasticity: volume alone has no von Mises stress", "[A6.6][plasticity]")
{
    for (const double e : {-0.1, 1e-3, 0.7})
        REQUIRE_THAT(von_mises_from_strain(e * Matrix3d::Identity(), 5),
                     IsClose(0.0, Rounding(16, 10 * std::abs(e))));
    REQUIRE_THAT(von_mises_from_strain(Matrix3d::Zero(), 5), IsExactly(0.0));
    REQUIRE_THAT(von_mises_from_strain(diagonal(1, 2, 3), 0), IsExactly(0.0));
}

TEST_CASE("plasticity: the strain knows the von Mises stress without the stress",
          "[A6.6][plasticity]")
{
    for (Random random : seeds(100)) {
        const Matrix3d strain = random_symmetric(random);
        const double lambda = random.uniform(0, 2), G = random.uniform(0, 2);
        const Matrix3d stress = lambda * strain.trace() * Matrix3d::Identity() + 2 * G * strain;

        REQUIRE_THAT(
            von_mises_from_strain(strain, G),
            IsClose(mises_of(stress), Rounding(32, stress.norm() + 2 * G * strain.norm())));
    }
}

TEST_CASE("plasticity: a steel yields at a strain of 0.1625 %", "[A6.7][plasticity]")
{
    REQUIRE_THAT(yield_strain(steel::yield_stress, steel::G), IsClose(1.625e-3, Rounding(16)));
    REQUIRE_THAT(yield_strain(6, 0.75), IsClose(4.0, Rounding(8)));
}

TEST_CASE("plasticity: what has no stiffness never yields", "[A6.7][plasticity]")
{
    REQUIRE_THAT(yield_strain(1, 0), IsExactly(infinity));
    REQUIRE_THAT(yield_strain(0, 0), IsExactly(infinity));
    REQUIRE_THAT(yield_strain(1, -0.0), IsExactly(infinity));
    REQUIRE_THAT(yield_strain(0, -0.0), IsExactly(infinity));
    INFO("and what has no strength does at once");
    REQUIRE_THAT(yield_strain(0, 3), IsExactly(0.0));
}
TEST_CASE("plasticity: the first Lamé constant may be as negative as it likes",
          "[A6.5][plasticity]")
{
    for (Random random : seeds(10)) {
        const Matrix3d strain = random_symmetric(random);
        for (const double lambda : {-0.5, -2.0 / 3, -1.0, -5.0, -1e3}) {
            CAPTURE(lambda);
            const Matrix3d expected = lambda * strain.trace() * Matrix3d::Identity() + 2 * strain;
            REQUIRE_THAT(isotropic_stress(strain, lambda, 1),
                         IsClose(expected, Rounding(16, 4 * (2 - lambda) * strain.norm())));
        }
    }
}
