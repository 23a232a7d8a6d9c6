// SPDX-License-Identifier: MIT
// The cases without contact: a free body, a heavy top and a pendulum.
//
// The top and the pendulum need no joint. A body pinned at a point o obeys d(I_o ω)/dt = l × m g,
// where I_o is the inertia about the pin. A free body of inertia I_o under the couple m g at l and
// -m g at o obeys the same equation. This works in every engine and has no joint error.
#include "benchmarks/engines/scenes.hpp"
#include "benchmarks/spin/run.hpp"
#include "cases.hpp"
#include "support/free_rotor.hpp"

#include <numbers>

namespace rigor {

namespace {

double angle_between(const Vector3d& a, const Vector3d& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// A body that touches nothing, so its shape is never used.
TrialBody turning_body(double mass, const Vector3d& inertia)
{
    TrialBody body = solid_ball(0.1, mass);
    body.inertia = inertia;
    return body;
}

} // namespace

std::vector<int> doubled(int first, int n)
{
    std::vector<int> all;
    for (int i = 0; i < n; ++i)
        all.push_back(first << i);
    return all;
}

AccuracyCase free_body_case()
{
    AccuracyCase c;
    c.name = "free_body";
    c.title = "Free box 1 × 2 × 3 m, 12 kg, ω = (1, 2, 3) rad/s, 10 s";
    c.error = "angle to the exact orientation [rad]";
    c.trial.bodies = {turning_body(spin_mass, spin_inertia)};
    c.trial.bodies[0].angular_velocity = spin_velocity;
    c.end = spin_end;
    c.steps = doubled(25, 11);
    c.peer_steps = doubled(150, 11);
    c.contestants = flight_contestants();
    const FreeRotor exact(spin_inertia, spin_velocity);
    c.error_of = [last = exact.orientation(spin_end)](const TrialEngine& engine, const auto&) {
        return rotation_angle(engine.motion(0).orientation, last);
    };
    return c;
}

AccuracyCase heavy_top_case()
{
    constexpr double m = 1, R = 0.05, H = 0.1, spin = 500, theta = std::numbers::pi / 6;
    constexpr double l = 0.75 * H;                       // from the apex to the center of mass [m]
    constexpr double I3 = 0.3 * m * R * R;               // about the axis [kg m²]
    constexpr double I1 = 0.6 * m * (R * R / 4 + H * H); // about the apex, across
    const double c_theta = std::cos(theta), L3 = I3 * spin;
    // I₁ cos θ Ω² - I₃ ω₃ Ω + m g l = 0; the slow precession is 2.02220460968698 rad/s
    const double Omega = (L3 - std::sqrt(L3 * L3 - 4 * I1 * c_theta * m * standard_gravity * l)) /
                         (2 * I1 * c_theta);
    const Vector3d axis(std::sin(theta), c_theta, 0);

    AccuracyCase c;
    c.name = "heavy_top";
    c.title = "Heavy top on its apex: cone 1 kg, 30°, spin 500 rad/s, 1 s";
    c.error = "angle to the exact axis [rad]";
    c.trial.bodies = {turning_body(m, Vector3d(I1, I1, I3))};
    TrialBody& top = c.trial.bodies[0];
    top.orientation = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis);
    top.angular_velocity = Omega * Vector3d::UnitY() + (spin - Omega * c_theta) * axis;
    c.trial.couple = Vector3d(0, -m * standard_gravity, 0);
    c.trial.arm = Vector3d(0, 0, l);
    c.end = 1;
    c.steps = doubled(100, 10);
    c.peer_steps = doubled(400, 10);
    c.contestants = flight_contestants();
    const Vector3d last = Eigen::AngleAxisd(Omega, Vector3d::UnitY()) * axis;
    c.error_of = [last](const TrialEngine& engine, const auto&) {
        return angle_between(engine.motion(0).orientation * Vector3d::UnitZ(), last);
    };
    return c;
}

AccuracyCase pendulum_case()
{
    constexpr double m = 1, L = 1, period = 1.93333485437325; // [s], for 90°
    AccuracyCase c;
    c.name = "pendulum";
    c.title = "Rod pendulum 1 m from 90°, ten and a quarter periods";
    c.error = "angle to the vertical, where it hangs exactly [rad]";
    c.trial.bodies = {turning_body(m, Vector3d(0.001, m * L * L / 3, m * L * L / 3))};
    c.trial.couple = Vector3d(0, -m * standard_gravity, 0);
    c.trial.arm = Vector3d(L / 2, 0, 0);
    c.end = 10.25 * period;
    c.steps = doubled(100, 11);
    c.peer_steps = doubled(200, 12);
    c.contestants = flight_contestants();
    c.error_of = [](const TrialEngine& engine, const auto&) {
        return angle_between(engine.motion(0).orientation * Vector3d::UnitX(), -Vector3d::UnitY());
    };
    return c;
}

} // namespace rigor
