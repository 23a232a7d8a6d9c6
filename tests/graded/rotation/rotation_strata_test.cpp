// SPDX-License-Identifier: MIT
// A3: turns that are nearly none, nearly half a turn or nearly a whole one, and bodies at rest that
// a torque turns.
#include "formulas/rotation.hpp"
#include "rotation_cases.hpp"
#include "support/close.hpp"
#include "support/seeds.hpp"

#include <numbers>

namespace rotation_strata_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// A turn by 2^-power rad, or by an angle that differs by so much from half a turn or a whole turn.
Eigen::Quaterniond nearly(Random& random, int power)
{
    const double whole = static_cast<double>(random.bits() % 3) * std::numbers::pi;
    const double sign = random.bits() % 2 == 0 ? 1 : -1;
    return turn((whole + sign * std::ldexp(1, -power)) * random.unit_vector());
}

BodyInertia point_mass()
{
    return {0.5, Matrix3d::Zero()};
}

} // namespace

TEST_CASE("rotation: two turns in a row turn a vector as one", "[A3.8][rotation]")
{
    for (Random random : seeds(5))
        for (int power = 1; power <= 44; ++power) {
            CAPTURE(power);
            const Eigen::Quaterniond q = nearly(random, power), b = random.eigen_quaternion(),
                                     a = q * b.conjugate();
            const Vector3d p = random.vector();
            REQUIRE_THAT(rotate(plain(q), p),
                         IsClose(rotate(plain(a), rotate(plain(b), p)), Rounding(64, 2)));
        }
}

TEST_CASE("rotation: what is nearly along the axis turns too", "[A3.8][rotation]")
{
    for (Random random : seeds(5)) {
        const Vector3d axis = random.unit_vector(), d = random.vector();
        const Eigen::Quaterniond q = turn(random.uniform(0.5, 3) * axis);
        for (int power = 1; power <= 40; ++power) {
            CAPTURE(power);
            const double small = std::ldexp(1, -power);
            REQUIRE_THAT(rotate(plain(q), axis + small * d),
                         IsClose(Vector3d(axis + small * (q * d)), Rounding(64, 2)));
        }
    }
}

TEST_CASE("rotation: the matrices of two turns multiply", "[A3.9][rotation]")
{
    for (Random random : seeds(5))
        for (int power = 1; power <= 44; ++power) {
            CAPTURE(power);
            const Eigen::Quaterniond q = nearly(random, power), b = random.eigen_quaternion(),
                                     a = q * b.conjugate();
            REQUIRE_THAT(
                to_matrix(plain(q)),
                IsClose(Matrix3d(to_matrix(plain(a)) * to_matrix(plain(b))), Rounding(64, 2)));
        }
}

TEST_CASE("rotation: symplectic Euler turns a body at rest under a torque", "[A3.15][rotation]")
{
    // q' depends on L' = L + h τ alone, so a torque acts like the momentum that it adds
    for (Random random : seeds(20)) {
        const BodyInertia body = {1, random.inertia().inverse()};
        const double h = random.uniform(0.01, 0.1);
        RigidState rest, moving;
        rest.orientation = moving.orientation = random.quaternion();
        const Vector3d tau = random.vector();
        moving.angular_momentum = h * tau;
        REQUIRE_THAT(
            step_symplectic_euler(rest, body, {{0, 0, 0}, tau}, h).orientation,
            IsClose(step_symplectic_euler(moving, body, {}, h).orientation, Rounding(64, 1)));
    }
}

TEST_CASE("rotation: the method of Buss turns a body at rest under a torque", "[A3.16][rotation]")
{
    // ω = 0 and ω̇ = I⁻¹ τ, so it turns by ½ h² I⁻¹ τ
    for (Random random : seeds(20)) {
        const BodyInertia body = {1, random.inertia().inverse()};
        const double h = random.uniform(0.01, 0.1);
        RigidState rest;
        rest.orientation = random.quaternion();
        const Vector3d tau = random.vector();
        const Vector3d angle = h * h / 2 * (world_inverse(body, rest.orientation) * tau);
        REQUIRE_THAT(step_buss(rest, body, {{0, 0, 0}, tau}, h).orientation,
                     IsClose(plain(turn(angle) * eigen(rest.orientation)), Rounding(64, 1)));
    }
}

TEST_CASE("rotation: symplectic Euler does not turn a body that a torque stops",
          "[A3.15][rotation]")
{
    for (Random random : seeds(10))
        for (const double h : {0x1p-10, 0.125, 1.}) { // h τ is exact
            CAPTURE(h);
            RigidState state;
            state.orientation = random.quaternion();
            state.angular_momentum = random.vector();
            const BodyInertia body = {1, random.inertia().inverse()};
            const RigidState after =
                step_symplectic_euler(state, body, {{0, 0, 0}, -state.angular_momentum / h}, h);
            REQUIRE_THAT(after.angular_momentum, IsExactly(Vector3d(0, 0, 0)));
            REQUIRE_THAT(after.orientation, IsClose(state.orientation, Rounding(16, 1)));
        }
}

TEST_CASE("rotation: Euler moves a point mass without a force", "[A3.15][rotation]")
{
    const RigidState state = {{1, 2, 3}, {}, {4, 5, 6}, {0, 0, 0}};
    REQUIRE_THAT(step_symplectic_euler(state, point_mass(), {}, 0.5).position,
                 IsClose(Vector3d(3, 4.5, 6), Rounding(8)));
}

TEST_CASE("rotation: Buss moves a point mass without a force", "[A3.16][rotation]")
{
    const RigidState state = {{1, 2, 3}, {}, {4, 5, 6}, {0, 0, 0}};
    REQUIRE_THAT(step_buss(state, point_mass(), {}, 0.5).position,
                 IsClose(Vector3d(3, 4.5, 6), Rounding(8)));
}

TEST_CASE("rotation: Euler keeps the quaternion unit however slow the turn", "[A3.15][rotation]")
{
    for (Random random : seeds(5))
        for (int power = 1; power <= 30; ++power) {
            CAPTURE(power);
            RigidState state;
            state.orientation = random.quaternion();
            state.angular_momentum = std::ldexp(1, -power) * random.vector();
            const BodyInertia body = {1, Matrix3d::Identity()};
            const RigidState after = step_symplectic_euler(state, body, {}, 1);
            REQUIRE_THAT(length(after.orientation), IsClose(1.0, Rounding(32)));
        }
}

TEST_CASE("rotation: Buss's correction counts in short steps too", "[A3.16][rotation]")
{
    // Ω = ω + h/2 ω̇ + h²/12 (ω̇ × ω)
    for (Random random : seeds(5)) {
        const BodyInertia body = {1, random.inertia().inverse()};
        RigidState state;
        state.orientation = random.quaternion();
        state.angular_momentum = random.vector();
        const Matrix3d I_inv = world_inverse(body, state.orientation);
        const Vector3d L = state.angular_momentum, w = I_inv * L, w_dot = -I_inv * w.cross(L);
        const double fast = std::max(1.0, I_inv.norm());
        for (int power = 1; power <= 14; ++power) {
            CAPTURE(power);
            const double h = std::ldexp(1 / fast, -power);
            const Vector3d W = w + h / 2 * w_dot + h * h / 12 * w_dot.cross(w);
            REQUIRE_THAT(step_buss(state, body, {}, h).orientation,
                         IsClose(plain(turn(h * W) * eigen(state.orientation)), Rounding(64, 2)));
        }
    }
}

} // namespace rotation_strata_test
