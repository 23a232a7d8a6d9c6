// SPDX-License-Identifier: MIT
// A0.1: kinetic energy of a body.
#include "formulas/pipeline.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("pipeline: energy of a body that moves and turns", "[A0.1][pipeline]")
{
    const Matrix3d I = Vector3d(1, 2, 3).asDiagonal();

    // ½ 2 · 25 = 25 of translation, ½ (1 + 2 + 3) = 3 of rotation
    const double E = kinetic_energy(2, Vector3d(3, 0, 4), I, Vector3d(1, 1, 1));

    REQUIRE_THAT(E, IsClose(28.0, Rounding(8, 28)));
}

TEST_CASE("pipeline: energy of a box that only turns", "[A0.1][pipeline]")
{
    const Matrix3d I = Vector3d(13, 10, 5).asDiagonal(); // a box of 1 m × 2 m × 3 m, 12 kg

    const double E = kinetic_energy(12, Vector3d::Zero(), I, Vector3d(1, 2, 3));

    REQUIRE_THAT(E, IsClose(49.0, Rounding(8, 49)));
}

TEST_CASE("pipeline: products of inertia count", "[A0.1][pipeline]")
{
    Matrix3d I;
    I << 2, -1, 0, -1, 2, 0, 0, 0, 3;

    // ω·I ω = 2 - 1 - 1 + 2
    const double E = kinetic_energy(1, Vector3d::Zero(), I, Vector3d(1, 1, 0));

    REQUIRE_THAT(E, IsClose(1.0, Rounding(8, 3)));
}

TEST_CASE("pipeline: a body at rest has no energy", "[A0.1][pipeline]")
{
    REQUIRE_THAT(kinetic_energy(5, Vector3d::Zero(), Matrix3d::Identity(), Vector3d::Zero()),
                 IsExactly(0.0));
}

TEST_CASE("pipeline: a little energy counts beside much", "[A0.1][pipeline]")
{
    const Vector3d e = Vector3d::UnitX();
    for (int power = 0; power <= 47; ++power) {
        CAPTURE(power);
        const double much = std::ldexp(1, power);
        REQUIRE_THAT(kinetic_energy(2 * much, e, Matrix3d::Identity(), e),
                     IsClose(much + 0.5, Rounding(4)));
        REQUIRE_THAT(kinetic_energy(1, e, 2 * much * Matrix3d::Identity(), e),
                     IsClose(much + 0.5, Rounding(4)));
    }
}

TEST_CASE("pipeline: energy is the sum of the particles' energies", "[A0.1][pipeline]")
{
    for (Random random : seeds(100)) {
        const Vector3d V = random.vector(), w = random.vector();
        double M = 0, sum = 0;
        Matrix3d I = Matrix3d::Zero();
        for (int pair = 0; pair < 4; ++pair) {
            const double m = random.mass();
            const Vector3d d = random.vector();
            for (const Vector3d& arm : {d, Vector3d(-d)}) { // in pairs: the center of mass is at 0
                M += m;
                sum += m / 2 * (V + w.cross(arm)).squaredNorm();
                I += m * (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());
            }
        }
        const double scale = M * V.squaredNorm() + w.squaredNorm() * I.norm();

        REQUIRE_THAT(kinetic_energy(M, V, I, w), IsClose(sum, Rounding(16, scale)));
    }
}

TEST_CASE("pipeline: energy is the same in every frame", "[A0.1][pipeline]")
{
    for (Random random : seeds(100)) {
        const double M = random.mass();
        const Vector3d V = random.vector(), w = random.vector();
        const Matrix3d I = random.inertia(), R = random.rotation();
        const double scale = M * V.squaredNorm() + w.squaredNorm() * I.norm();

        const double E = kinetic_energy(M, V, I, w);
        const double turned = kinetic_energy(M, R * V, R * I * R.transpose(), R * w);

        REQUIRE_THAT(turned, IsClose(E, Rounding(32, scale)));
    }
}

TEST_CASE("pipeline: energy of light and heavy, slow and fast bodies", "[A0.1][pipeline]")
{
    // M V² fits in a double, although the square of M V would overflow or underflow
    for (int power = -800; power <= 800; power += 100)
        for (int speed = -100; speed <= 100; speed += 50) {
            CAPTURE(power, speed);
            const double M = std::ldexp(1, power), v = std::ldexp(1, speed);
            REQUIRE_THAT(kinetic_energy(M, {v, 0, 0}, M * Matrix3d::Identity(), {0, v, 0}),
                         IsClose(M * v * v, Rounding(8)));
        }
}
