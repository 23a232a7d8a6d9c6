// SPDX-License-Identifier: MIT
// A3: small turns, matrices that are nearly rotations or very small, angles on both sides of gimbal
// lock, the smallest and the largest quaternions.
#include "formulas/rotation.hpp"
#include "rotation_cases.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"

#include <limits>
#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::pi;

// A turn by `angle`, as small as it may be, about a random axis.
Quaternion small_turn(Random& random, double angle)
{
    return {std::cos(angle / 2), std::sin(angle / 2) * random.unit_vector()};
}

// q (0, p) q̄, where only terms that are small themselves cancel.
Vector3d turned(const Quaternion& q, const Vector3d& p)
{
    return p + 2 * q.s * q.v.cross(p) + 2 * q.v.cross(q.v.cross(p));
}

} // namespace

TEST_CASE("rotation: the naive update turns by as little as it is told", "[A3.1][rotation]")
{
    for (Random random : seeds(10)) {
        const Matrix3d R = random.rotation();
        const Vector3d w = random.vector();
        for (int power = 1; power <= 14; ++power) {
            const double step = std::pow(10.0, -power);
            CAPTURE(step);
            Matrix3d expected = R;
            for (int i = 0; i < 3; ++i)
                expected.col(i) += step * w.cross(R.col(i));
            REQUIRE_THAT(advance_matrix(R, w, step), IsClose(expected, Rounding(8, 1)));
        }
    }
}

TEST_CASE("rotation: a small matrix has the same axes", "[A3.2][rotation]")
{
    for (Random random : seeds(10)) {
        const Matrix3d R = random.rotation();
        for (int power = 0; power <= 140; power += 5) {
            const double scale = std::pow(10.0, -power);
            CAPTURE(scale);
            REQUIRE_THAT(gram_schmidt(scale * R), IsClose(R, Rounding(64, 1)));
        }
    }
}

TEST_CASE("rotation: what is nearly a rotation becomes one", "[A3.2][rotation]")
{
    for (Random random : seeds(10)) {
        const Matrix3d R = random.rotation();
        Matrix3d error;
        error << random.vector(), random.vector(), random.vector();
        for (int power = 1; power <= 14; ++power) {
            const double share = std::pow(10.0, -power);
            CAPTURE(share);
            REQUIRE_THAT(gram_schmidt(R + share * error), IsRotation());
        }
    }
}

TEST_CASE("rotation: gimbal lock begins at a cosine of 1e-12", "[A3.4][rotation]")
{
    // angles near 3π/2 are 9e-16 apart, which is a thousandth of 1e-12
    for (const double locked : {pi / 2, -pi / 2, 3 * pi / 2, -3 * pi / 2})
        for (const double side : {1.0, -1.0}) {
            CAPTURE(locked, side);
            check_that(!euler_rates({0.3, locked + side * 0.99e-12, 0.2}, {1, 2, 3}).has_value(),
                       "no rates at θ within 1e-12 of gimbal lock");
            check_that(euler_rates({0.3, locked + side * 1.01e-12, 0.2}, {1, 2, 3}).has_value(),
                       "rates at θ farther than 1e-12 from gimbal lock");
        }
}

TEST_CASE("rotation: the smallest and the largest quaternions are normalized", "[A3.7][rotation]")
{
    for (int power = -1074; power <= 1022; power += 4) {
        CAPTURE(power);
        const double size = std::ldexp(1.0, power);
        REQUIRE_THAT(normalize({size, {0, -size, 0}}),
                     IsClose(Quaternion{std::sqrt(0.5), {0, -std::sqrt(0.5), 0}}, Rounding(8, 1)));
    }
    // one component is far larger than the others, and may be negative
    for (const double sign : {1.0, -1.0})
        for (int power = 0; power <= 1000; power += 8) {
            CAPTURE(sign, power);
            const double small = std::ldexp(1, -power), length = std::hypot(1, small);
            REQUIRE_THAT(
                normalize({sign, {0, 0, small}}),
                IsClose(Quaternion{sign / length, {0, 0, small / length}}, Rounding(8, 1)));
            REQUIRE_THAT(
                normalize({small, {0, sign, 0}}),
                IsClose(Quaternion{small / length, {0, sign / length, 0}}, Rounding(8, 1)));
        }
    // any direction: in between, the squares keep only some of their digits
    for (Random random : seeds(2)) {
        const Quaternion q = random.quaternion();
        for (int power = -960; power <= 1000; power += 4) {
            CAPTURE(power);
            const double size = std::ldexp(1.0, power);
            REQUIRE_THAT(normalize({size * q.s, size * q.v}), IsClose(q, Rounding(8, 1)));
        }
    }
    const double largest = std::numeric_limits<double>::max();
    REQUIRE_THAT(normalize({largest, {-largest, largest, -largest}}),
                 IsClose(Quaternion{0.5, {-0.5, 0.5, -0.5}}, Rounding(8, 1)));
}

TEST_CASE("rotation: a small turn rotates a vector by as little", "[A3.8][rotation]")
{
    for (Random random : seeds(20))
        for (int power = 0; power <= 14; ++power) {
            const double angle = std::pow(10.0, -power);
            CAPTURE(angle);
            const Quaternion q = small_turn(random, angle);
            const Vector3d p = random.vector();
            REQUIRE_THAT(rotate(q, p), IsClose(turned(q, p), Rounding(16, 2)));
        }
}

TEST_CASE("rotation: a small turn has a matrix that turns by as little", "[A3.9][rotation]")
{
    for (Random random : seeds(20))
        for (int power = 0; power <= 14; ++power) {
            const double angle = std::pow(10.0, -power);
            CAPTURE(angle);
            const Quaternion q = small_turn(random, angle);
            const Matrix3d R = to_matrix(q);
            for (int i = 0; i < 3; ++i)
                REQUIRE_THAT(Vector3d(R.col(i)),
                             IsClose(turned(q, Vector3d::Unit(i)), Rounding(16, 1)));
        }
}

TEST_CASE("rotation: small components of ω count in the longest step", "[A3.13][rotation]")
{
    for (int power = 0; power <= 30; ++power)
        for (int axis = 0; axis < 3; ++axis) {
            CAPTURE(power, axis);
            const double small = std::ldexp(1, -power);
            Vector3d omega = Vector3d::Zero();
            omega[axis] = 1;
            omega[(axis + 1) % 3] = -small;
            REQUIRE_THAT(max_time_step(omega), IsClose(pi / 2 / std::hypot(1, small), Rounding(8)));
        }
}

TEST_CASE("rotation: the slower a body turns, the longer its step may be", "[A3.13][rotation]")
{
    for (int power = 0; power <= 150; power += 3) {
        const double speed = std::pow(10.0, -power);
        CAPTURE(speed);
        REQUIRE_THAT(max_time_step({0, speed, 0}), IsClose(pi / 2 / speed, Rounding(32)));
    }
}
