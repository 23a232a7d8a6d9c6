// SPDX-License-Identifier: MIT
// A6.1 to A6.4: the deviator and the three forms of the von Mises stress.
#include "formulas/plasticity.hpp"
#include "plasticity_cases.hpp"
#include "support/seeds.hpp"

#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::sqrt3;

// The von Mises stress entry by entry: √(½ ((σ_xx - σ_yy)² + …) + 3 (σ_xy² + …))
double mises_by_entries(const Matrix3d& s)
{
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        sum += std::pow(s(i, i) - s(j, j), 2) / 2 + 3 * s(i, j) * s(i, j);
    }
    return std::sqrt(sum);
}

} // namespace

TEST_CASE("plasticity: the deviator by hand", "[A6.1][plasticity]")
{
    Matrix3d stress, expected;
    stress << 4, 1, 2, 1, 1, 3, 2, 3, 1; // a third of its trace is 2
    expected << 2, 1, 2, 1, -1, 3, 2, 3, -1;

    REQUIRE_THAT(deviator(stress), IsClose(expected, Rounding(8, 8)));
    REQUIRE_THAT(deviator(Matrix3d::Zero()), IsExactly(Matrix3d(Matrix3d::Zero())));
}

TEST_CASE("plasticity: pressure has no deviator", "[A6.1][plasticity]")
{
    for (const double p : {-1e9, -0.1, 1e-12, 0.7, 3e8}) {
        CAPTURE(p);
        REQUIRE_THAT(deviator(p * Matrix3d::Identity()),
                     IsClose(Matrix3d(Matrix3d::Zero()), Rounding(8, std::abs(p))));
    }
}

TEST_CASE("plasticity: a stress is its deviator and a pressure", "[A6.1][plasticity]")
{
    for (Random random : seeds(100)) {
        const Matrix3d stress = random_symmetric(random);

        const Matrix3d s = deviator(stress);

        INFO("its trace is 0");
        REQUIRE_THAT(s.trace(), IsClose(0.0, Rounding(16, stress.norm())));
        INFO("the rest is the mean of the three normal stresses, in all directions");
        REQUIRE_THAT(Matrix3d(stress - s),
                     IsClose(Matrix3d(stress.trace() / 3 * Matrix3d::Identity()),
                             Rounding(16, stress.norm())));
    }
}

TEST_CASE("plasticity: no pressure changes the deviator and no turn does", "[A6.1][plasticity]")
{
    for (Random random : seeds(100)) {
        const Matrix3d stress = random_symmetric(random), R = random.rotation();
        const double p = random.uniform(-100, 100);
        const Matrix3d s = deviator(stress);

        REQUIRE_THAT(deviator(stress + p * Matrix3d::Identity()),
                     IsClose(s, Rounding(16, stress.norm() + std::abs(p))));
        REQUIRE_THAT(deviator(s), IsClose(s, Rounding(16, stress.norm())));
        REQUIRE_THAT(deviator(turned(R, stress)),
                     IsClose(turned(R, s), Rounding(32, stress.norm())));
    }
}

TEST_CASE("plasticity: a rod that is pulled or pushed from its principal stresses",
          "[A6.2][plasticity]")
{
    for (const double sigma : {-3.0, 0.25, 250e6}) {
        CAPTURE(sigma);
        const double expected = std::abs(sigma);
        REQUIRE_THAT(von_mises_principal(sigma, 0, 0), IsClose(expected, Rounding(32)));
        REQUIRE_THAT(von_mises_principal(0, sigma, 0), IsClose(expected, Rounding(32)));
        REQUIRE_THAT(von_mises_principal(0, 0, sigma), IsClose(expected, Rounding(32)));
        INFO("squeezed from the two other sides it is the same");
        REQUIRE_THAT(von_mises_principal(0, sigma, sigma), IsClose(expected, Rounding(32)));
    }
}

TEST_CASE("plasticity: shear and pressure from their principal stresses", "[A6.2][plasticity]")
{
    REQUIRE_THAT(von_mises_principal(2, 0, -2), IsClose(2 * sqrt3, Rounding(8)));
    REQUIRE_THAT(von_mises_principal(3, 1, 2), IsClose(sqrt3, Rounding(8)));
    for (const double p : {0.0, 0.1, -7e8})
        REQUIRE_THAT(von_mises_principal(p, p, p), IsExactly(0.0));
}

TEST_CASE("plasticity: the order of the principal stresses does not matter and no pressure does",
          "[A6.2][plasticity]")
{
    for (Random random : seeds(100)) {
        const Vector3d s = random.vector();
        const double p = random.uniform(-10, 10);
        const double expected = mises_by_entries(s.asDiagonal());
        const Tolerance rounding = Rounding(64, s.norm());

        REQUIRE_THAT(von_mises_principal(s[0], s[1], s[2]), IsClose(expected, rounding));
        REQUIRE_THAT(von_mises_principal(s[1], s[2], s[0]), IsClose(expected, rounding));
        REQUIRE_THAT(von_mises_principal(s[2], s[1], s[0]), IsClose(expected, rounding));
        REQUIRE_THAT(von_mises_principal(s[0] + p, s[1] + p, s[2] + p),
                     IsClose(expected, Rounding(64, s.norm() + std::abs(p))));
    }
}

TEST_CASE("plasticity: pull and shear from the norm of the stress", "[A6.3][plasticity]")
{
    REQUIRE_THAT(von_mises_frobenius(diagonal(0, -3, 0)), IsClose(3.0, Rounding(8)));
    REQUIRE_THAT(von_mises_frobenius(shear(2)), IsClose(2 * sqrt3, Rounding(8)));
    REQUIRE_THAT(von_mises_frobenius(diagonal(1, 0, 0) + shear(1)), IsClose(2.0, Rounding(8)));
    REQUIRE_THAT(von_mises_frobenius(Matrix3d::Zero()), IsExactly(0.0));
}

TEST_CASE("plasticity: the norm of a stress and its trace give the von Mises stress",
          "[A6.3][plasticity]")
{
    for (Random random : seeds(100)) {
        const Matrix3d stress = random_symmetric(random);

        const double found = von_mises_frobenius(stress);

        INFO("compared are the squares: under the root digits cancel");
        REQUIRE_THAT(found * found, IsClose(std::pow(mises_by_entries(stress), 2),
                                            Rounding(128, stress.squaredNorm())));
    }
}

TEST_CASE("plasticity: rounding under the root never makes a pressure shear", "[A6.3][plasticity]")
{
    for (Random random : seeds(100)) {
        const double p = random.uniform(-1e9, 1e9);
        const Matrix3d pressure = p * Matrix3d::Identity();

        const double found = von_mises_frobenius(pressure);
        REQUIRE_THAT(found * found, IsClose(0.0, Rounding(128, pressure.squaredNorm())));

        const Matrix3d nearly = turned(random.rotation(), pressure); // with rounding errors
        const double beside = von_mises_frobenius(nearly);
        REQUIRE_THAT(beside * beside, IsClose(0.0, Rounding(128, pressure.squaredNorm())));
    }
}

TEST_CASE("plasticity: pull and shear from the deviator", "[A6.4][plasticity]")
{
    REQUIRE_THAT(von_mises(diagonal(0, 0, -3)), IsClose(3.0, Rounding(32)));
    REQUIRE_THAT(von_mises(shear(2)), IsClose(2 * sqrt3, Rounding(32)));
    REQUIRE_THAT(von_mises(diagonal(1, 0, 0) + shear(1)), IsClose(2.0, Rounding(32)));
    REQUIRE_THAT(von_mises(Matrix3d::Zero()), IsExactly(0.0));
    INFO("the shear at which a steel of 250 MPa yields");
    REQUIRE_THAT(von_mises(shear(144.337567297406e6)), IsClose(250e6, Rounding(256)));
}

TEST_CASE("plasticity: no turn and no pressure changes the von Mises stress", "[A6.4][plasticity]")
{
    for (Random random : seeds(100)) {
        const Matrix3d stress = random_symmetric(random), R = random.rotation();
        const double p = random.uniform(-100, 100);
        const double expected = mises_by_entries(stress);

        REQUIRE_THAT(von_mises(stress), IsClose(expected, Rounding(256, stress.norm())));
        REQUIRE_THAT(von_mises(turned(R, stress)), IsClose(expected, Rounding(512, stress.norm())));
        REQUIRE_THAT(von_mises(stress + p * Matrix3d::Identity()),
                     IsClose(expected, Rounding(256, stress.norm() + std::abs(p))));
    }
}

TEST_CASE("plasticity: the three forms are equal", "[A6.4][plasticity]")
{
    for (Random random : seeds(100)) {
        const Vector3d principal = random.vector();
        const Matrix3d stress = turned(random.rotation(), principal.asDiagonal());
        const double scale = principal.norm();

        const double from_principal = von_mises_principal(principal[0], principal[1], principal[2]);
        const double from_norm = von_mises_frobenius(stress), from_deviator = von_mises(stress);

        REQUIRE_THAT(from_deviator, IsClose(from_principal, Rounding(128, scale)));
        INFO("compared are the squares: under the root digits cancel");
        REQUIRE_THAT(from_deviator * from_deviator,
                     IsClose(from_norm * from_norm, Rounding(256, scale * scale)));
    }
}

TEST_CASE("plasticity: a small shear does not drown in a large pressure", "[A6.4][plasticity]")
{
    for (const double p : {1e3, -1e6, 1e9}) {
        CAPTURE(p);
        const Matrix3d stress = p * Matrix3d::Identity() + shear(1);
        REQUIRE_THAT(von_mises(stress), IsClose(sqrt3, Rounding(16, std::abs(p))));
    }
}

TEST_CASE("plasticity: large and small stresses are measured alike", "[A6.4][plasticity]")
{
    for (const double unit : {1e-100, 1e-12, 1e12, 1e100}) {
        CAPTURE(unit);
        const Matrix3d stress = unit * (diagonal(1, 0, 0) + shear(1));
        REQUIRE_THAT(von_mises(stress), IsClose(2 * unit, Rounding(32)));
    }
}
