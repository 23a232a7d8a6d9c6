// SPDX-License-Identifier: MIT
// A1: lists with equal elements, and points that are very near the center of mass.
#include "formulas/kinematics.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>

namespace kinematics_strata_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// The number of equal elements in a list: a power of two, so that `many` times a number is exact.
constexpr std::size_t many = 1 << 14;

Tolerance of_many(double scale)
{
    return Rounding(many, static_cast<double>(many) * scale);
}

} // namespace

TEST_CASE("kinematics: equal particles count each time", "[A1.7][kinematics]")
{
    for (Random random : seeds(2)) {
        const Vector3d X = random.vector();
        const std::vector<Particle> one = random.particles(1);
        const Matrix6d alone = generalized_mass(one, X);
        REQUIRE_THAT(generalized_mass({many, one[0]}, X),
                     IsClose(Matrix6d(many * alone), of_many(alone.norm())));
    }
}

TEST_CASE("kinematics: equal forces count each time", "[A1.8][kinematics]")
{
    for (Random random : seeds(2)) {
        const Vector3d X = random.vector();
        const PointForce one = {random.vector(), random.vector()};
        const Wrench alone = net_wrench({one}, X), all = net_wrench({many, one}, X);
        REQUIRE_THAT(all.force, IsClose(Vector3d(many * alone.force), of_many(2)));
        REQUIRE_THAT(all.torque, IsClose(Vector3d(many * alone.torque), of_many(6)));
    }
}

TEST_CASE("kinematics: equal particles pull equally", "[A1.13][kinematics]")
{
    for (Random random : seeds(2)) {
        const Vector3d X = random.vector(), V = random.vector(), w = random.vector();
        const std::vector<Particle> one = random.particles(1);
        const Wrench alone = inertial_wrench(one, X, V, w),
                     all = inertial_wrench({many, one[0]}, X, V, w);
        const double scale = 50 * one[0].mass; // lengths and rates are less than 4
        REQUIRE_THAT(all.force, IsClose(Vector3d(many * alone.force), of_many(scale)));
        REQUIRE_THAT(all.torque, IsClose(Vector3d(many * alone.torque), of_many(scale)));
    }
}

TEST_CASE("kinematics: the shortest lever turns the velocity", "[A1.5][kinematics]")
{
    for (Random random : seeds(5)) {
        const Vector3d X = random.vector(), w = random.vector(), direction = random.vector();
        for (int power = 1; power <= 39; ++power) {
            CAPTURE(power);
            const Vector3d x = X + std::ldexp(1, -power) * direction;
            REQUIRE_THAT(point_velocity({0, 0, 0}, w, X, x),
                         IsClose(Vector3d(w.cross(x - X)), Rounding(32, 2)));
        }
    }
}

TEST_CASE("kinematics: a force with a short lever still turns", "[A1.8][kinematics]")
{
    for (Random random : seeds(5)) {
        const Vector3d X = random.vector(), f = random.vector(), direction = random.vector();
        const PointForce far = {random.vector(), random.vector()};
        for (int power = 1; power <= 39; ++power) {
            CAPTURE(power);
            const PointForce near = {f, X + std::ldexp(1, -power) * direction};
            const Vector3d torque = (far.point - X).cross(far.force) + (near.point - X).cross(f);
            REQUIRE_THAT(net_wrench({far, near}, X).torque, IsClose(torque, Rounding(64, 8)));
        }
    }
}

TEST_CASE("kinematics: near the center of mass there is still a force", "[A1.13][kinematics]")
{
    // F = M ω × (ω × d), where d leads from X to the center of mass
    for (Random random : seeds(5)) {
        const Vector3d a = random.vector(), w = random.vector(), direction = random.vector();
        const Vector3d center = random.vector();
        const std::vector<Particle> two = {{1, center + a}, {1, center - a}};
        for (int power = 1; power <= 36; ++power) {
            CAPTURE(power);
            const Vector3d X = center + std::ldexp(1, -power) * direction;
            const Vector3d d = (two[0].position - X + (two[1].position - X)) / 2;
            REQUIRE_THAT(inertial_wrench(two, X, {0, 0, 0}, w).force,
                         IsClose(Vector3d(2 * w.cross(w.cross(d))), Rounding(64, 24)));
        }
    }
}

TEST_CASE("kinematics: the modes of a particle that moves almost with the center change",
          "[A1.12][kinematics]")
{
    for (Random random : seeds(5))
        for (int power = 0; power <= 44; ++power) {
            CAPTURE(power);
            const Vector3d V = 16 * random.vector(),
                           v = V + std::ldexp(16, -power) * random.vector();
            const Matrix36d found = velocity_mode_rates(V, v);
            REQUIRE_THAT(Matrix3d(found.leftCols<3>()), IsExactly(Matrix3d(Matrix3d::Zero())));
            const Vector3d d = V - v;
            Matrix3d expected;
            expected << 0, -d.z(), d.y(), //
                d.z(), 0, -d.x(),         //
                -d.y(), d.x(), 0;
            REQUIRE_THAT(Matrix3d(found.rightCols<3>()), IsExactly(expected));
        }
}

TEST_CASE("kinematics: a light particle far away counts", "[A1.7][kinematics]")
{
    // 1 kg at X, which has no moment, and 4^-k kg at X + 2^k u: m r² is that of 1 kg at X + u
    const Vector3d X(0.5, -1, 2), u(1, -2, 0.5);
    const Matrix3d expected = u.squaredNorm() * Matrix3d::Identity() - u * u.transpose();
    for (int k = 0; k <= 30; ++k) {
        CAPTURE(k);
        const Particle heavy{1, X}, light{std::ldexp(1, -2 * k), X + std::ldexp(1, k) * u};
        for (const auto& particles : {std::vector{heavy, light}, std::vector{light, heavy}})
            REQUIRE_THAT(Matrix3d(generalized_mass(particles, X).block<3, 3>(3, 3)),
                         IsClose(expected, Rounding(16)));
    }
}

TEST_CASE("kinematics: a light particle far away pulls", "[A1.13][kinematics]")
{
    // beside 1 kg at X, whose acceleration is 0
    const Vector3d X(0.5, -1, 2), u(1, -2, 0.5), omega(1, 0.5, -2);
    for (int k = 0; k <= 30; ++k) {
        CAPTURE(k);
        const Particle heavy{1, X}, light{std::ldexp(1, -2 * k), X + std::ldexp(1, k) * u};
        const Wrench alone = inertial_wrench({light}, X, Vector3d::Zero(), omega);
        for (const auto& particles : {std::vector{heavy, light}, std::vector{light, heavy}}) {
            const Wrench all = inertial_wrench(particles, X, Vector3d::Zero(), omega);
            REQUIRE_THAT(all.force, IsClose(alone.force, Rounding(16)));
            REQUIRE_THAT(all.torque, IsClose(alone.torque, Rounding(16)));
        }
    }
}

} // namespace kinematics_strata_test
