// SPDX-License-Identifier: MIT
// A3: Euler angles from the smallest to many turns, quaternions with a tiny component, and
// products of small and large ones.
#include "formulas/rotation.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>

namespace rotation_small_test {

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("rotation: one Euler angle alone turns about its axis however small or large it is",
          "[A3.3][rotation]")
{
    for (int power = -45; power <= 20; ++power)
        for (const double sign : {1.0, -1.0})
            for (int axis = 0; axis < 3; ++axis) {
                CAPTURE(power, sign, axis);
                const double angle = sign * std::ldexp(1, power);
                const int i = (axis + 1) % 3, j = (axis + 2) % 3;
                Matrix3d R = Matrix3d::Identity();
                R(i, i) = R(j, j) = std::cos(angle);
                R(j, i) = std::sin(angle);
                R(i, j) = -std::sin(angle);
                REQUIRE_THAT(euler_to_matrix(angle * Vector3d::Unit(axis)),
                             IsClose(R, Rounding(16, 1)));
            }
}

TEST_CASE("rotation: a tiny component of a quaternion stays", "[A3.7][rotation]")
{
    for (int power = 1; power <= 45; ++power) {
        CAPTURE(power);
        const double tiny = std::ldexp(1, -power), length = std::sqrt(1 + tiny * tiny);
        for (int axis = 0; axis < 3; ++axis) {
            const Vector3d u = Vector3d::Unit(axis);
            const Quaternion turn = normalize({2, 2 * tiny * u}),
                             half_turn = normalize({2 * tiny, 2 * u});
            REQUIRE_THAT(turn.v, IsClose(Vector3d(tiny / length * u), Rounding(16)));
            REQUIRE_THAT(half_turn.s, IsClose(tiny / length, Rounding(16)));
        }
    }
}

TEST_CASE("rotation: a product is as small or large as its factors", "[A3.5][rotation]")
{
    // a power of two changes no digit
    for (Random random : seeds(5)) {
        const Quaternion a = random.quaternion(), b = random.quaternion(), one = multiply(a, b);
        for (int power = -300; power <= 300; power += 2) {
            CAPTURE(power);
            const double k = std::ldexp(1, power);
            const Quaternion expected = {k * one.s, k * one.v};
            REQUIRE_THAT(multiply({k * a.s, k * a.v}, b), IsClose(expected, Rounding(16, k)));
            REQUIRE_THAT(multiply(a, {k * b.s, k * b.v}), IsClose(expected, Rounding(16, k)));
        }
    }
}

// Each component of a product is a sum of four terms, and its error is a rounding error of these,
// however large the other components are.
TEST_CASE("rotation: small components of a product are kept beside large ones", "[A3.5][rotation]")
{
    const auto entries = [](const Quaternion& q) -> Eigen::Vector4d {
        return {q.s, q.v.x(), q.v.y(), q.v.z()};
    };
    const auto quaternion = [](const Eigen::Vector4d& q) -> Quaternion {
        return {q[0], q.tail<3>()};
    };
    for (Random random : seeds(20))
        for (int power = 0; power <= 60; power += 3) {
            CAPTURE(power);
            Eigen::Vector4d a = entries(random.quaternion()), b = entries(random.quaternion());
            for (int i = 0; i < 4; ++i) {
                if (random.bits() % 2 == 0) a[i] = std::ldexp(a[i], -power);
                if (random.bits() % 2 == 0) b[i] = std::ldexp(b[i], -power);
            }
            Eigen::Matrix4d terms; // row i: the terms of component i of the product
            terms << a[0] * b[0], -a[1] * b[1], -a[2] * b[2], -a[3] * b[3], //
                a[0] * b[1], a[1] * b[0], a[2] * b[3], -a[3] * b[2],        //
                a[0] * b[2], a[2] * b[0], a[3] * b[1], -a[1] * b[3],        //
                a[0] * b[3], a[3] * b[0], a[1] * b[2], -a[2] * b[1];
            const Eigen::Vector4d found = entries(multiply(quaternion(a), quaternion(b)));
            for (int i = 0; i < 4; ++i) {
                CAPTURE(i);
                REQUIRE_THAT(found[i],
                             IsClose(terms.row(i).sum(), Rounding(8, terms.row(i).lpNorm<1>())));
            }
        }
}

} // namespace rotation_small_test
