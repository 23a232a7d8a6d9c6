// SPDX-License-Identifier: MIT
// A1: quarter and half turns of a body that spins; particles and forces at X itself, at the origin,
// and several at one place; lists that are empty after others that were not.
#include "formulas/kinematics.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"

#include <array>

namespace kinematics_special_inputs_test {

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("kinematics: any spin of a body in one of the 24 turns of a cube", "[A1.4][kinematics]")
{
    // the rows of R are axes, in any order and with any signs that make no mirror image
    int turns = 0;
    for (const std::array<int, 3>& order :
         {std::array{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}})
        for (int signs = 0; signs < 8; ++signs) {
            Matrix3d R = Matrix3d::Zero();
            for (int i = 0; i < 3; ++i)
                R(i, order[i]) = (signs >> i & 1) ? -1 : 1;
            if (R.row(0).cross(R.row(1)) != R.row(2)) continue;
            ++turns;
            for (int k = 0; k < 27; ++k) {
                const Vector3d omega(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
                Matrix3d R_dot; // each axis e of the body moves with the velocity ω × e
                for (int i = 0; i < 3; ++i)
                    R_dot.col(i) = omega.cross(R.col(i));
                CAPTURE(omega);
                REQUIRE_THAT(angular_velocity(R_dot, R), IsClose(omega, Rounding(8, 1)));
            }
        }
    check_count(turns, 24, "turns of a cube");
}

TEST_CASE("kinematics: a particle at X has mass but no moment", "[A1.7][kinematics]")
{
    Matrix6d expected = Matrix6d::Zero();
    expected.topLeftCorner<3, 3>() = 2 * Matrix3d::Identity();
    for (const Vector3d& X : {Vector3d(0, 0, 0), Vector3d(1, 2, 3)})
        REQUIRE_THAT(generalized_mass({{2, X}}, X), IsExactly(expected));
}

TEST_CASE("kinematics: a particle at the origin, and several at one place", "[A1.7][kinematics]")
{
    const Vector3d X(1, 0, 0);
    // a lever of 1 m along x: SᵀS has 1 on its diagonal but for the rotation about x
    const Matrix6d one = generalized_mass({{1, {0, 0, 0}}}, X),
                   all = generalized_mass({{1, {0, 0, 0}}, {2, {0, 0, 0}}, {2, {0, 0, 0}}}, X);
    const Matrix3d block = one.bottomRightCorner<3, 3>();
    REQUIRE_THAT(block, IsClose(Matrix3d(Vector3d(0, 1, 1).asDiagonal()), Rounding(8, 1)));
    REQUIRE_THAT(all, IsClose(Matrix6d(5 * one), Rounding(8)));
}

TEST_CASE("kinematics: forces at one point, and a couple whose one force acts at X",
          "[A1.8][kinematics]")
{
    const Wrench several = net_wrench(
        {{{1, 0, 0}, {0, 1, 0}}, {{0, 0, 2}, {0, 1, 0}}, {{0, 0, 2}, {0, 1, 0}}}, {0, 0, 0});
    REQUIRE_THAT(several.force, IsClose(Vector3d(1, 0, 4), Rounding(8)));
    REQUIRE_THAT(several.torque, IsClose(Vector3d(4, 0, -1), Rounding(8)));
    const Wrench couple = net_wrench({{{0, -1, 0}, {0, 0, 0}}, {{0, 1, 0}, {1, 0, 0}}}, {0, 0, 0});
    REQUIRE_THAT(couple.force, IsExactly(Vector3d(0, 0, 0)));
    REQUIRE_THAT(couple.torque, IsClose(Vector3d(0, 0, 1), Rounding(8)));
}

TEST_CASE("kinematics: particles at one place, and one alone", "[A1.13][kinematics]")
{
    const Vector3d X(0, 0, 0), w(0, 0, 1);
    const Wrench alone = inertial_wrench({{1, {1, 0, 0}}}, X, {0, 0, 0}, w);
    REQUIRE_THAT(alone.force, IsClose(Vector3d(-1, 0, 0), Rounding(8)));
    const Wrench several =
        inertial_wrench({{1, {1, 0, 0}}, {2, {1, 0, 0}}, {2, {1, 0, 0}}}, X, {0, 0, 0}, w);
    REQUIRE_THAT(several.force, IsClose(Vector3d(-5, 0, 0), Rounding(8)));
    // particles on the axis, which need no force, anywhere in the list
    for (std::size_t place = 0; place < 3; ++place) {
        std::vector<Particle> particles = {{1, {1, 0, 0}}, {2, {1, 0, 0}}};
        particles.insert(particles.begin() + static_cast<std::ptrdiff_t>(place), {4, {0, 0, 1}});
        const Wrench wrench = inertial_wrench(particles, X, {0, 0, 0}, w);
        REQUIRE_THAT(wrench.force, IsClose(Vector3d(-3, 0, 0), Rounding(8)));
    }
}

TEST_CASE("kinematics: no particle has no mass, also after others", "[A1.7][kinematics]")
{
    const Vector3d X(1, 2, 3);
    const Matrix6d some = generalized_mass({{2, {0, 0, 0}}, {3, {1, 0, 0}}}, X);
    const Matrix3d mass = some.topLeftCorner<3, 3>();
    REQUIRE_THAT(mass, IsClose(Matrix3d(5 * Matrix3d::Identity()), Rounding(8)));
    REQUIRE_THAT(generalized_mass({}, X), IsExactly(Matrix6d(Matrix6d::Zero())));
}

TEST_CASE("kinematics: no force is no wrench, also after others", "[A1.8][kinematics]")
{
    const Vector3d X(1, 2, 3);
    const Wrench some = net_wrench({{{1, 0, 0}, {0, 1, 0}}}, X);
    REQUIRE_THAT(some.force, IsClose(Vector3d(1, 0, 0), Rounding(8)));
    const Wrench none = net_wrench({}, X);
    REQUIRE_THAT(none.force, IsExactly(Vector3d(0, 0, 0)));
    REQUIRE_THAT(none.torque, IsExactly(Vector3d(0, 0, 0)));
}

TEST_CASE("kinematics: no particle needs no force, also after others", "[A1.13][kinematics]")
{
    const Vector3d X(0, 0, 0), V(1, 0, 0), w(0, 0, 1);
    const Wrench some = inertial_wrench({{1, {1, 0, 0}}}, X, V, w);
    REQUIRE_THAT(some.force, IsClose(Vector3d(-1, 0, 0), Rounding(8, 2)));
    const Wrench none = inertial_wrench({}, X, V, w);
    REQUIRE_THAT(none.force, IsExactly(Vector3d(0, 0, 0)));
    REQUIRE_THAT(none.torque, IsExactly(Vector3d(0, 0, 0)));
}

} // namespace kinematics_special_inputs_test
