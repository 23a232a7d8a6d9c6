// SPDX-License-Identifier: MIT
// A3.15 and A3.16: the closed form of one step, and motions whose exact solution the step must meet
// up to rounding. How fast the errors fall is tested in rotation_convergence_test.cpp.
#include "formulas/rotation.hpp"
#include "rotation_cases.hpp"
#include "support/close.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

const Vector3d gravity(0, -9.81, 0);

/// Compares each field at its own scale.
void check_step(const RigidState& actual, const RigidState& expected, const StepCase& c)
{
    const auto& [X, q, V, L] = c.state;
    const double h = c.time_step, force = c.body.inverse_mass * c.wrench.force.norm();
    const double speed = c.speed + h * c.body.inverse_inertia.norm() * c.wrench.torque.norm();
    REQUIRE_THAT(actual.velocity, IsClose(expected.velocity, Rounding(8, V.norm() + h * force)));
    REQUIRE_THAT(actual.position,
                 IsClose(expected.position, Rounding(16, X.norm() + h * V.norm() + h * h * force)));
    REQUIRE_THAT(
        actual.angular_momentum,
        IsClose(expected.angular_momentum, Rounding(8, L.norm() + h * c.wrench.torque.norm())));
    // ω passes through I⁻¹ and I, whose condition number is at most 10 and multiplies the scale
    REQUIRE_THAT(actual.orientation,
                 IsClose(expected.orientation, Rounding(64, 1 + 10 * h * speed)));
}

} // namespace

TEST_CASE("rotation: symplectic Euler takes the new V and the new L", "[A3.15][rotation]")
{
    for (Random random : seeds(100)) {
        const StepCase c = random_step(random);
        const double h = c.time_step;
        RigidState expected = c.state;
        expected.velocity += h * c.body.inverse_mass * c.wrench.force;
        expected.position += h * expected.velocity;
        expected.angular_momentum += h * c.wrench.torque;
        const Vector3d w = world_inverse(c.body, c.state.orientation) * expected.angular_momentum;
        const Vector3d by = 2 * std::atan(w.norm() * h / 2) * w.normalized();
        expected.orientation = plain(turn(by) * eigen(c.state.orientation));

        check_step(step_symplectic_euler(c.state, c.body, c.wrench, h), expected, c);
    }
}

TEST_CASE("rotation: symplectic Euler in free fall", "[A3.15][rotation]")
{
    // x_n = x₀ + n h v₀ + g h² n(n+1)/2
    const double m = 2, h = 0.01;
    const int n = 100;
    const BodyInertia ball = {1 / m, 5 * Matrix3d::Identity()};
    RigidState state;
    state.position = {0, 1, 0};
    state.velocity = {3, 4, 0};
    for (int i = 0; i < n; ++i)
        state = step_symplectic_euler(state, ball, {m * gravity, {0, 0, 0}}, h);

    const double t = n * h;
    const Vector3d X = Vector3d(3 * t, 1 + 4 * t, 0) + h * h * n * (n + 1) / 2 * gravity;
    REQUIRE_THAT(state.position, IsClose(X, Rounding(n, 1 + 5 * t + 5 * t * t)));
    REQUIRE_THAT(state.velocity,
                 IsClose(Vector3d(Vector3d(3, 4, 0) + t * gravity), Rounding(n, 15)));
    REQUIRE_THAT(state.orientation, IsClose(Quaternion(), Rounding(8, 1)));
}

TEST_CASE("rotation: symplectic Euler keeps L and the length of q", "[A3.15][rotation]")
{
    RigidState state = spinning_box({1, 2, 3});
    const Vector3d L = state.angular_momentum;
    for (int i = 0; i < 1000; ++i) {
        state = step_symplectic_euler(state, box(), {}, 0.05);
        REQUIRE_THAT(state.angular_momentum, IsExactly(L));
        REQUIRE_THAT(length(state.orientation), IsClose(1.0, Rounding(32)));
    }
}

TEST_CASE("rotation: symplectic Euler leaves a static body alone", "[A3.15][rotation]")
{
    for (Random random : seeds(20)) {
        const StepCase c = random_step(random);
        const BodyInertia fixed = {0, Matrix3d::Zero()};
        const RigidState after = step_symplectic_euler(c.state, fixed, c.wrench, c.time_step);
        REQUIRE_THAT(after, IsExactly(c.state));
    }
}

TEST_CASE("rotation: Buss's step is one turn by ΔtΩ", "[A3.16][rotation]")
{
    for (Random random : seeds(100)) {
        const StepCase c = random_step(random);
        const auto& [X, q, V, L] = c.state;
        const double h = c.time_step;
        const Vector3d acceleration = c.body.inverse_mass * c.wrench.force;
        const Matrix3d I_inv = world_inverse(c.body, q);
        const Vector3d w = I_inv * L, w_dot = I_inv * (c.wrench.torque - w.cross(L));
        const Vector3d by = h * w + h * h / 2 * w_dot + h * h * h / 12 * w_dot.cross(w);
        RigidState expected;
        expected.velocity = V + h * acceleration;
        expected.position = X + h * V + h * h / 2 * acceleration;
        expected.angular_momentum = L + h * c.wrench.torque;
        expected.orientation = plain(turn(by) * eigen(q));

        check_step(step_buss(c.state, c.body, c.wrench, h), expected, c);
    }
}

TEST_CASE("rotation: Buss's step flies a parabola exactly", "[A3.16][rotation]")
{
    const double m = 2, h = 0.25;
    const int n = 8;
    const BodyInertia ball = {1 / m, 5 * Matrix3d::Identity()};
    RigidState state;
    state.position = {0, 1, 0};
    state.velocity = {3, 4, 0};
    for (int i = 0; i < n; ++i)
        state = step_buss(state, ball, {m * gravity, {0, 0, 0}}, h);

    const double t = n * h;
    const Vector3d X = Vector3d(3 * t, 1 + 4 * t, 0) + t * t / 2 * gravity;
    REQUIRE_THAT(state.position, IsClose(X, Rounding(8 * n, 1 + 5 * t + 5 * t * t)));
    REQUIRE_THAT(state.velocity,
                 IsClose(Vector3d(Vector3d(3, 4, 0) + t * gravity), Rounding(n, 25)));
}

TEST_CASE("rotation: an isotropic body turns exactly in one step of any size", "[A3.16][rotation]")
{
    const BodyInertia ball = {1, Matrix3d::Identity() / 2.0}; // I = 2 δ
    for (Random random : seeds(20)) {
        const Vector3d w = random.vector();
        RigidState state;
        state.orientation = random.quaternion();
        state.angular_momentum = 2 * w;
        for (double t : {0.1, 10.0, 1000.0}) {
            const Quaternion expected = plain(turn(t * w) * eigen(state.orientation));
            const RigidState after = step_buss(state, ball, {}, t);
            // ω × L is a rounding error, which Δt² and Δt³ multiply
            const double turned = t * w.norm();
            const double scale = 1 + turned * (1 + turned * (1 + turned));
            REQUIRE_THAT(after.orientation, IsClose(expected, Rounding(16, scale)));
        }
    }
}

TEST_CASE("rotation: spun up about one axis the angle is exact", "[A3.16][rotation]")
{
    // under a constant torque along a principal axis θ = ω₀ t + ½ α t²
    const double I = 5, w = 3, torque = 4, h = 0.5;
    const int n = 10;
    RigidState state = spinning_box({0, 0, w});
    for (int i = 0; i < n; ++i)
        state = step_buss(state, box(), {{0, 0, 0}, {0, 0, torque}}, h);
    const double t = n * h, angle = w * t + torque / I * t * t / 2;
    const Quaternion expected = {std::cos(angle / 2), {0, 0, std::sin(angle / 2)}};
    REQUIRE_THAT(state.orientation, IsClose(expected, Rounding(8 * n, angle)));
    REQUIRE_THAT(state.angular_momentum,
                 IsClose(Vector3d(0, 0, I * w + torque * t), Rounding(8 * n)));
}

TEST_CASE("rotation: Buss's step keeps L and the length of q", "[A3.16][rotation]")
{
    RigidState state = spinning_box({1, 2, 3});
    const Vector3d L = state.angular_momentum;
    const int n = 1000;
    for (int i = 0; i < n; ++i)
        state = step_buss(state, box(), {}, 0.05);
    REQUIRE_THAT(state.angular_momentum, IsExactly(L));
    REQUIRE_THAT(length(state.orientation), IsClose(1.0, Rounding(4 * n)));
}

TEST_CASE("rotation: Buss's step leaves a static body alone", "[A3.16][rotation]")
{
    for (Random random : seeds(20)) {
        const StepCase c = random_step(random);
        const BodyInertia fixed = {0, Matrix3d::Zero()};
        REQUIRE_THAT(step_buss(c.state, fixed, c.wrench, c.time_step), IsExactly(c.state));
    }
}
