// SPDX-License-Identifier: MIT
// A3: inputs at the limits of the formulas: columns that nearly depend on each other, quaternions
// that are nearly unit, steep pitch angles, rods and point masses.
#include "formulas/rotation.hpp"
#include "rotation_cases.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"

#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::pi;

// Checks a step against its closed form.
// @param by  the rotation vector of the step [rad]
void check_motion(const RigidState& actual, const StepCase& c, const Vector3d& X,
                  const Vector3d& by)
{
    const double h = c.time_step;
    const Vector3d V = c.state.velocity + h * c.body.inverse_mass * c.wrench.force;
    const Vector3d L = c.state.angular_momentum + h * c.wrench.torque;
    const Quaternion turned =
        by.isZero(0) ? c.state.orientation : plain(turn(by) * eigen(c.state.orientation));
    REQUIRE_THAT(actual.velocity, IsClose(V, Rounding(64, 1 + V.norm())));
    REQUIRE_THAT(actual.position, IsClose(X, Rounding(64, 1 + X.norm())));
    REQUIRE_THAT(actual.angular_momentum, IsClose(L, Rounding(64, 1 + L.norm())));
    REQUIRE_THAT(actual.orientation, IsClose(turned, Rounding(256, 1 + by.norm())));
}

// A step of a point mass (no inertia at all), or of a rod along its own z-axis.
StepCase degenerate_step(Random& random, bool is_rod)
{
    StepCase c = random_step(random);
    const double across = is_rod ? random.uniform(0.5, 2) : 0;
    c.body.inverse_inertia = Vector3d(across, across, 0).asDiagonal();
    return c;
}

} // namespace

TEST_CASE("rotation: columns that are nearly parallel still give a rotation", "[A3.2][rotation]")
{
    for (Random random : seeds(50)) {
        const Matrix3d axes = random.rotation();
        const Vector3d a = axes.col(0), t = axes.col(1);
        for (const double angle : {1e-13, 1e-12, 1e-11, 1e-9, 1e-7, 1e-5, 1e-3}) {
            CAPTURE(angle);
            Matrix3d R;
            R << random.mass() * a, random.mass() * (a + angle * t), random.vector();
            const Matrix3d Q = gram_schmidt(R);
            REQUIRE_THAT(Q, IsRotation());
            REQUIRE_THAT(Vector3d(Q.col(0)), IsClose(a, Rounding(64, 1)));
            INFO("the second column is what R₁ has besides its part along R₀");
            REQUIRE_THAT(Vector3d(Q.col(1)), IsClose(t, Rounding(256, 1 / angle)));
        }
    }
}

TEST_CASE("rotation: a quaternion that is nearly unit is normalized too", "[A3.7][rotation]")
{
    for (Random random : seeds(20)) {
        const Quaternion unit = random.quaternion();
        for (const double d : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13}) {
            for (const double length_before : {1 + d, 1 - d}) {
                CAPTURE(length_before);
                const Quaternion q = {length_before * unit.s, length_before * unit.v};
                REQUIRE_THAT(length(normalize(q)), IsClose(1.0, Rounding(32)));
            }
        }
    }
}

TEST_CASE("rotation: pitched beyond a quarter turn there are Euler rates", "[A3.4][rotation]")
{
    for (Random random : seeds(50)) {
        Vector3d angles = pi * random.vector();
        angles.y() = pi + 1.4 * random.uniform(-1, 1); // cos θ < 0
        const Vector3d w = 5 * random.vector();
        const std::optional<Vector3d> rates = euler_rates(angles, w);
        check_that(rates.has_value(), "rates of the angles, since cos θ is not 0");
        const Eigen::Quaterniond yaw(Eigen::AngleAxisd(angles.z(), Vector3d::UnitZ())),
            pitch(Eigen::AngleAxisd(angles.y(), Vector3d::UnitY()));
        const Vector3d sum = rates->x() * (yaw * (pitch * Vector3d::UnitX())) +
                             rates->y() * (yaw * Vector3d::UnitY()) +
                             rates->z() * Vector3d::UnitZ();
        REQUIRE_THAT(sum, IsClose(w, Rounding(64, w.norm() + rates->lpNorm<1>())));
    }
}

TEST_CASE("rotation: close to gimbal lock there are still Euler rates", "[A3.4][rotation]")
{
    for (const double off : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 2e-12})
        for (const double theta : {pi / 2 - off, pi / 2 + off, -pi / 2 + off, -pi / 2 - off}) {
            CAPTURE(theta);
            const std::optional<Vector3d> rates = euler_rates({0.3, theta, 0}, {1, 2, 3});
            check_that(rates.has_value(), "rates of the angles, since cos θ is not 0");
            // without yaw φ̇ = ω_x / cos θ, θ̇ = ω_y and ψ̇ = ω_z + φ̇ sin θ
            const double roll = 1 / std::cos(theta);
            REQUIRE_THAT(*rates, IsClose(Vector3d(roll, 2, 3 + roll * std::sin(theta)),
                                         Rounding(16, std::abs(roll) + 3)));
        }
}

TEST_CASE("rotation: the linear update turns by as little as it is told", "[A3.12][rotation]")
{
    // neighboring speeds differ by a factor of 2, so that a series for short turns is tested also
    // where its error is largest
    for (int power = -3; power <= 500; ++power) {
        const double speed = std::ldexp(1, -power);
        CAPTURE(speed);
        const Quaternion q = advance_linear({1, {0, 0, 0}}, {0, speed, 0}, 0.5);
        const double half = std::atan(speed / 4);
        REQUIRE_THAT(q, IsClose(Quaternion{std::cos(half), {0, std::sin(half), 0}}, Rounding(16)));
    }
}

TEST_CASE("rotation: symplectic Euler moves rods and point masses", "[A3.15][rotation]")
{
    for (Random random : seeds(40))
        for (const bool is_rod : {true, false}) {
            CAPTURE(is_rod);
            const StepCase c = degenerate_step(random, is_rod);
            const double h = c.time_step;
            const Vector3d V = c.state.velocity + h * c.body.inverse_mass * c.wrench.force;
            const Vector3d L = c.state.angular_momentum + h * c.wrench.torque;
            const Vector3d w = world_inverse(c.body, c.state.orientation) * L;
            const Vector3d by =
                is_rod ? Vector3d(2 * std::atan(w.norm() * h / 2) * w.normalized()) : L * 0;
            check_motion(step_symplectic_euler(c.state, c.body, c.wrench, h), c,
                         c.state.position + h * V, by);
        }
}

TEST_CASE("rotation: Buss's step moves rods and point masses", "[A3.16][rotation]")
{
    for (Random random : seeds(40))
        for (const bool is_rod : {true, false}) {
            CAPTURE(is_rod);
            const StepCase c = degenerate_step(random, is_rod);
            const double h = c.time_step;
            const Matrix3d I_inv = world_inverse(c.body, c.state.orientation);
            const Vector3d& L = c.state.angular_momentum;
            const Vector3d w = I_inv * L, w_dot = I_inv * (c.wrench.torque - w.cross(L));
            const Vector3d by = h * (w + h / 2 * w_dot + h * h / 12 * w_dot.cross(w));
            const Vector3d X = c.state.position + h * c.state.velocity +
                               h * h / 2 * c.body.inverse_mass * c.wrench.force;
            check_motion(step_buss(c.state, c.body, c.wrench, h), c, X, by);
        }
}
