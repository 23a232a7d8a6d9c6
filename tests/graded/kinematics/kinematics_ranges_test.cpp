// SPDX-License-Identifier: MIT
// A1: small numbers, matrices that are nearly skew, many particles, and sums that are empty after
// sums that were not.
#include "formulas/kinematics.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace {

// w*, whose columns are w × e₁, w × e₂ and w × e₃.
Matrix3d star_of(const Vector3d& w)
{
    Matrix3d star;
    for (int i = 0; i < 3; ++i)
        star.col(i) = w.cross(Vector3d::Unit(i));
    return star;
}

constexpr int many = 1000; // a sum of n terms may be wrong by n eps of their magnitudes

} // namespace

TEST_CASE("kinematics: the cross-product matrix of small vectors", "[A1.1][kinematics]")
{
    for (Random random : seeds(10))
        for (int power = 0; power <= 300; power += 3) {
            const Vector3d w = std::pow(10.0, -power) * random.vector();
            CAPTURE(power);
            Matrix3d star; // its entries are those of w, however small their squares are
            star << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
            REQUIRE_THAT(cross_matrix(w), IsClose(star, Rounding(8)));
        }
}

TEST_CASE("kinematics: the cross-product matrix has each component, however small",
          "[A1.1][kinematics]")
{
    for (int power = 0; power <= 1000; power += power < 80 ? 4 : 40)
        for (int i = 0; i < 3; ++i) {
            CAPTURE(power, i);
            Vector3d w(1, 1, 1);
            w[i] = std::ldexp(1, -power);
            REQUIRE_THAT(cross_matrix(w), IsExactly(star_of(w)));
        }
}

TEST_CASE("kinematics: however small its symmetric part is, it has no effect", "[A1.4][kinematics]")
{
    for (Random random : seeds(10)) {
        const Vector3d w = random.vector();
        const Matrix3d R = random.rotation(), symmetric = random.positive_definite();
        for (int power = 1; power <= 15; ++power)
            for (const double scale : {1.0, 1e-4, 1e-8, 1e-12, 1e-100}) {
                const double share = std::pow(10.0, -power);
                CAPTURE(share, scale);
                const Matrix3d A = scale * (star_of(w) + share * symmetric);
                REQUIRE_THAT(angular_velocity(A * R, R),
                             IsClose(Vector3d(scale * w), Rounding(32, scale * (2 + share * 10))));
            }
    }
}

TEST_CASE("kinematics: a thousand particles have one mass", "[A1.7][kinematics]")
{
    Random random(1);
    const std::vector<Particle> particles = random.particles(many);
    double mass = 0;
    for (const Particle& particle : particles)
        mass += particle.mass;
    const Matrix6d M = generalized_mass(particles, Vector3d::Zero());
    REQUIRE_THAT(Matrix3d(M.topLeftCorner<3, 3>()),
                 IsClose(Matrix3d(mass * Matrix3d::Identity()), Rounding(many, mass)));
}

TEST_CASE("kinematics: the inertial wrench of a thousand particles", "[A1.13][kinematics]")
{
    for (Random random : seeds(5)) {
        const std::vector<Particle> particles = random.particles(many);
        const Vector3d X = random.vector(), V = random.vector(), w = random.vector();
        Wrench expected;
        double mass = 0;
        for (const auto& [m, x] : particles) {
            const Vector3d f = m * w.cross(w.cross(x - X));
            expected.force += f;
            expected.torque += (x - X).cross(f);
            mass += m;
        }
        // |ω|² is at most 3, a lever arm at most 2√3
        REQUIRE_THAT(inertial_wrench(particles, X, V, w),
                     IsClose(expected, Rounding(many, mass * 3 * 12)));
    }
}

TEST_CASE("kinematics: no force after forces has no wrench", "[A1.8][kinematics]")
{
    for (Random random : seeds(5)) {
        const Vector3d X = random.vector();
        net_wrench({{random.vector(), random.vector()}}, X);
        REQUIRE_THAT(net_wrench({}, X), IsExactly(Wrench()));
    }
}

TEST_CASE("kinematics: no particle after particles has no wrench", "[A1.13][kinematics]")
{
    for (Random random : seeds(5)) {
        const Vector3d X = random.vector(), V = random.vector(), w = random.vector();
        inertial_wrench(random.particles(3), X, V, w);
        REQUIRE_THAT(inertial_wrench({}, X, V, w), IsExactly(Wrench()));
    }
}

TEST_CASE("kinematics: a point that is nearly on the axis moves a little", "[A1.5][kinematics]")
{
    // Each term of ω × (x - X) is exact, and the others are 0.
    for (int power = 1; power <= 100; ++power)
        for (int axis = 0; axis < 3; ++axis)
            for (const double along : {-3.0, 1.0, 5.0}) {
                CAPTURE(power, axis, along);
                const double off = std::ldexp(1, -power);
                const Vector3d e = Vector3d::Unit(axis), f = Vector3d::Unit((axis + 1) % 3);
                const Vector3d found =
                    point_velocity({0, 0, 0}, 2 * e, {0, 0, 0}, along * e + off * f);
                REQUIRE_THAT(found, IsClose(Vector3d(2 * off * e.cross(f)), Rounding(8)));
            }
}
