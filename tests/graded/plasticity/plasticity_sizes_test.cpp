// SPDX-License-Identifier: MIT
// A6: stresses and strains of every size. The von Mises stress and the formulas of elasticity are
// proportional to them, so none is too small or too large; an elastic strain of steel is about
// 1e-3. All factors are powers of two, which leave the digits of a number alone.
#include "formulas/plasticity.hpp"
#include "plasticity_cases.hpp"
#include "support/seeds.hpp"

#include <limits>
#include <vector>

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
        constexpr int largest = 480; // from 2^-480, about 1e-145, to 2^480
        factor = std::ldexp(1, static_cast<int>(random.bits() % (2 * largest + 1)) - largest);
    }
};

// From 2^-484, about 1e-146, to 2^484: the squares of such stresses are doubles.
std::vector<double> sizes()
{
    std::vector<double> result;
    for (int power = -484; power <= 484; power += 22)
        result.push_back(std::ldexp(1, power));
    return result;
}

template <class Mises> void check_sizes(Mises mises)
{
    for (Random random : seeds(5)) {
        const Matrix3d stress = random_symmetric(random);
        const double usual = mises(stress);
        for (const double size : sizes()) {
            CAPTURE(size);
            REQUIRE_THAT(mises(Matrix3d(size * stress)),
                         IsClose(size * usual, Rounding(64, size * stress.norm())));
        }
    }
}

} // namespace

TEST_CASE("plasticity: a stress of any size has its deviator", "[A6.1][plasticity]")
{
    for (Random random : seeds(5)) {
        const Matrix3d stress = random_symmetric(random), usual = deviator(stress);
        for (const double size : sizes()) {
            CAPTURE(size);
            REQUIRE_THAT(deviator(size * stress),
                         IsClose(Matrix3d(size * usual), Rounding(16, size * stress.norm())));
        }
    }
}

TEST_CASE("plasticity: principal stresses of any size", "[A6.2][plasticity]")
{
    check_sizes([](const Matrix3d& s) { return von_mises_principal(s(0, 0), s(1, 1), s(2, 2)); });
}

TEST_CASE("plasticity: a stress of any size has its von Mises stress by the norm",
          "[A6.3][plasticity]")
{
    check_sizes(von_mises_frobenius);
}

TEST_CASE("plasticity: a stress of any size has its von Mises stress", "[A6.4][plasticity]")
{
    check_sizes(von_mises);
}

TEST_CASE("plasticity: a strain of any size has its stress", "[A6.5][plasticity]")
{
    for (Random random : seeds(80)) {
        const Stretched solid(random);
        CAPTURE(solid.factor);
        const Matrix3d usual = isotropic_stress(solid.strain, solid.lambda, solid.G);
        const double k = solid.factor;
        const auto expected = IsClose(Matrix3d(k * usual), Rounding(16));
        REQUIRE_THAT(isotropic_stress(k * solid.strain, solid.lambda, solid.G), expected);
        REQUIRE_THAT(isotropic_stress(solid.strain, k * solid.lambda, k * solid.G), expected);
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
        const double k = solid.factor;
        CAPTURE(k);
        const auto expected = IsClose(2 * solid.G * k * mises_of(solid.strain),
                                      Rounding(256, solid.G * k * solid.strain.norm()));
        REQUIRE_THAT(von_mises_from_strain(k * solid.strain, solid.G), expected);
        REQUIRE_THAT(von_mises_from_strain(solid.strain, k * solid.G), expected);
    }
}

TEST_CASE("plasticity: a yield strain of any size", "[A6.7][plasticity]")
{
    for (Random random : seeds(80)) {
        const Stretched solid(random);
        const double k = solid.factor, usual = solid.lambda / (2 * solid.G);
        CAPTURE(k);
        REQUIRE_THAT(yield_strain(k * solid.lambda, solid.G), IsClose(k * usual, Rounding(8)));
        REQUIRE_THAT(yield_strain(solid.lambda, k * solid.G), IsClose(usual / k, Rounding(8)));
        REQUIRE_THAT(yield_strain(k * solid.lambda, k * solid.G), IsClose(usual, Rounding(8)));
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
        const double scale = solid.strain.norm() + stress.norm() / solid.G;
        REQUIRE_THAT(plastic_flow(k * solid.strain, k * stress, k * yield_stress, solid.G),
                     IsClose(Matrix3d(k * usual), Rounding(64, k * scale)));
        REQUIRE_THAT(plastic_flow(solid.strain, k * stress, k * yield_stress, k * solid.G),
                     IsClose(usual, Rounding(64, scale)));
    }
}

} // namespace plasticity_sizes_test
