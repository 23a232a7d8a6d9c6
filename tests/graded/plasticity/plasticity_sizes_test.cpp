// SPDX-License-Identifier: MIT
// A6.5 to A6.8: strains of every size. The formulas of elasticity are linear, so no strain is too
// small or too large for them; an elastic strain of steel is about 1e-3. All factors are powers of
// two, which leave the digits of a number alone.
#include "formulas/plasticity.hpp"
#include "plasticity_cases.hpp"
#include "support/seeds.hpp"

#include <limits>

namespace plasticity_sizes_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// A strain and constants of a material, and the factor by which the strain grows.
struct Stretched {
    Matrix3d strain;
    double lambda, G, factor;
    explicit Stretched(Random& random)
    {
        strain = random_symmetric(random);
        lambda = random.uniform(0.1, 2);
        G = random.uniform(0.1, 2);
        constexpr int largest = 80; // from 2^-80, about 1e-24, to 2^80
        factor = std::ldexp(1, static_cast<int>(random.bits() % (2 * largest + 1)) - largest);
    }
};

double mises_of(const Matrix3d& sigma)
{
    return std::sqrt(1.5) * (sigma - sigma.trace() / 3 * Matrix3d::Identity()).norm();
}

} // namespace

TEST_CASE("plasticity: a strain of any size has its stress", "[A6.5][plasticity]")
{
    for (Random random : seeds(80)) {
        const Stretched solid(random);
        CAPTURE(solid.factor);
        const Matrix3d usual = isotropic_stress(solid.strain, solid.lambda, solid.G);
        const Matrix3d stress =
            isotropic_stress(solid.factor * solid.strain, solid.lambda, solid.G);
        REQUIRE_THAT(stress, IsClose(Matrix3d(solid.factor * usual), Rounding(16)));
    }
}

TEST_CASE("plasticity: a solid however soft in shear has a stress", "[A6.5][plasticity]")
{
    Matrix3d shear = Matrix3d::Zero();
    shear(0, 1) = shear(1, 0) = 0.25;
    for (int power = -60; power <= 60; power += 4) {
        CAPTURE(power);
        const double G = std::ldexp(1, power);
        REQUIRE_THAT(isotropic_stress(shear, 1, G), IsClose(Matrix3d(2 * G * shear), Rounding(8)));
        REQUIRE_THAT(isotropic_stress(shear, 3, G), IsClose(Matrix3d(2 * G * shear), Rounding(8)));
    }
}

TEST_CASE("plasticity: a strain of any size has its von Mises stress", "[A6.6][plasticity]")
{
    for (Random random : seeds(80)) {
        const Stretched solid(random);
        CAPTURE(solid.factor);
        const double expected = 2 * solid.G * solid.factor * mises_of(solid.strain);
        const double mises = von_mises_from_strain(solid.factor * solid.strain, solid.G);
        REQUIRE_THAT(
            mises, IsClose(expected, Rounding(256, solid.G * solid.factor * solid.strain.norm())));
    }
}

TEST_CASE("plasticity: a yield strain of any size", "[A6.7][plasticity]")
{
    for (Random random : seeds(80)) {
        const Stretched solid(random);
        CAPTURE(solid.factor);
        const double expected = solid.factor * solid.lambda / (2 * solid.G);
        REQUIRE_THAT(yield_strain(solid.factor * solid.lambda, solid.G),
                     IsClose(expected, Rounding(8)));
    }
}

TEST_CASE("plasticity: a plastic strain of any size grows in proportion", "[A6.8][plasticity]")
{
    for (Random random : seeds(80)) {
        const Stretched solid(random);
        const Matrix3d stress = random_symmetric(random);
        const double share = random.bits() % 2 == 0 ? 0.5 : 2; // at 2 nothing yields
        const double yield_stress = share * mises_of(stress), k = solid.factor;
        CAPTURE(k, share);
        const Matrix3d usual = plastic_flow(solid.strain, stress, yield_stress, solid.G);
        const Matrix3d flow = plastic_flow(k * solid.strain, k * stress, k * yield_stress, solid.G);
        const double scale = k * (solid.strain.norm() + stress.norm() / solid.G);
        REQUIRE_THAT(flow, IsClose(Matrix3d(k * usual), Rounding(64, scale)));
    }
}

} // namespace plasticity_sizes_test
