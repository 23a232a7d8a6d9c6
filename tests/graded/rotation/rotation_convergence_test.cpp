// SPDX-License-Identifier: MIT
// A3.15 and A3.16: motions with an exact solution, and how fast the error falls with the step. The
// expected values are the solution of Euler's equations of a free body by Jacobi's elliptic
// functions, to 15 digits.
#include "formulas/rotation.hpp"
#include "rotation_cases.hpp"
#include "support/close.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

using Step = RigidState (*)(const RigidState&, const BodyInertia&, const Wrench&, double);

RigidState run(Step step, const BodyInertia& body, RigidState state, double end, int n,
               const Wrench& wrench = {})
{
    for (int i = 0; i < n; ++i)
        state = step(state, body, wrench, end / n);
    return state;
}

/// ω along the axes of the body.
Vector3d body_rates(const BodyInertia& body, const RigidState& state)
{
    return body.inverse_inertia * (eigen(state.orientation).conjugate() * state.angular_momentum);
}

// The orientation of the box 10 s after it starts with ω = (1, 2, 3), and its ω along its axes.
const Eigen::Quaterniond box_q10(-0.7167345284363959, 0.02657340199601567, 0.01350657848027917,
                                 0.6967087213399667);
const Vector3d box_w10(-1.441479761782112, 1.32591216920842, 3.268251472830505);

/// A rotor with I = 0.04 kg m² across its axis z and J = 0.02 kg m² about it, ω = (2, -4, 6) rad/s.
/// Its axis precesses about L at |L|/I = 5.385 rad/s, at the angle 56.145° to L.
constexpr double rotor_I = 0.04, rotor_J = 0.02;
const BodyInertia rotor = {1, Vector3d(1 / rotor_I, 1 / rotor_I, 1 / rotor_J).asDiagonal()};
const Vector3d rotor_w(2, -4, 6), rotor_L(0.08, -0.16, 0.12);

/// Exact orientation of the rotor: exp(t L/I) exp(t (ω_z - L_z/I) e_z).
Eigen::Quaterniond rotor_orientation(double t)
{
    const double own_spin = rotor_w.z() - rotor_L.z() / rotor_I;
    return turn(t / rotor_I * rotor_L) * turn(Vector3d(0, 0, t * own_spin));
}

RigidState spinning_rotor()
{
    RigidState state;
    state.angular_momentum = rotor_L;
    return state;
}

/// Solution of q' = ½ (0, ω) q with ω = I⁻¹ (L + t τ), by Runge–Kutta 4 in plain Eigen.
Eigen::Quaterniond runge_kutta(const BodyInertia& body, const RigidState& start,
                               const Vector3d& torque, double end, int n)
{
    const auto rate = [&](const Eigen::Vector4d& q, double t) -> Eigen::Vector4d {
        const Eigen::Quaterniond u(q);
        const Vector3d L = start.angular_momentum + t * torque;
        const Vector3d w = u * (body.inverse_inertia * (u.conjugate() * L));
        return 0.5 * (Eigen::Quaterniond(0, w.x(), w.y(), w.z()) * u).coeffs();
    };
    const double h = end / n;
    Eigen::Vector4d q = eigen(start.orientation).coeffs();
    for (int i = 0; i < n; ++i) {
        const double t = i * h;
        const Eigen::Vector4d k1 = rate(q, t), k2 = rate(q + h / 2 * k1, t + h / 2),
                              k3 = rate(q + h / 2 * k2, t + h / 2), k4 = rate(q + h * k3, t + h);
        q = (q + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)).normalized();
    }
    return Eigen::Quaterniond(q);
}

} // namespace

TEST_CASE("rotation: symplectic Euler tumbles the box with order 1", "[A3.15][rotation]")
{
    std::vector<double> errors;
    Vector3d w;
    for (int n : {1600, 3200, 6400}) {
        const auto end = run(step_symplectic_euler, box(), spinning_box({1, 2, 3}), 10, n);
        errors.push_back(turn_between(eigen(end.orientation), box_q10).norm());
        w = body_rates(box(), end);
    }
    check_order(errors, 1);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(0.45)));
    REQUIRE_THAT(w, IsClose(box_w10, Order(0.8)));
}

TEST_CASE("rotation: symplectic Euler turns the symmetric rotor with order 1", "[A3.15][rotation]")
{
    std::vector<double> errors;
    for (int n : {400, 800, 1600}) {
        const auto end = run(step_symplectic_euler, rotor, spinning_rotor(), 1, n);
        errors.push_back(turn_between(eigen(end.orientation), rotor_orientation(1)).norm());
    }
    check_order(errors, 1);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(0.02)));
}

TEST_CASE("rotation: Buss's step tumbles the box with order 2", "[A3.16][rotation]")
{
    std::vector<double> errors, rate_errors;
    for (int n : {500, 1000, 2000}) {
        const auto end = run(step_buss, box(), spinning_box({1, 2, 3}), 10, n);
        errors.push_back(turn_between(eigen(end.orientation), box_q10).norm());
        rate_errors.push_back((body_rates(box(), end) - box_w10).norm());
    }
    check_order(errors, 2);
    check_order(rate_errors, 2);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(5e-4)));
    REQUIRE_THAT(rate_errors.back(), IsClose(0.0, Order(1.5e-3)));
}

TEST_CASE("rotation: the box's ω returns along its axes after a period", "[A3.16][rotation]")
{
    std::vector<double> errors;
    for (int n : {200, 400, 800}) {
        const auto end = run(step_buss, box(), spinning_box({1, 2, 3}), 3.67184730265235, n);
        errors.push_back((body_rates(box(), end) - Vector3d(1, 2, 3)).norm());
    }
    check_order(errors, 2);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(1e-3)));
}

TEST_CASE("rotation: the tennis racket flips on time", "[A3.16][rotation]")
{
    // The racket flips every 9.41035970436993 s. The order is measured at 5 s, half way through the
    // first flip.
    const Vector3d w5(0.655929773068489, -1.76801944452792, 0.815831130092729);
    const Vector3d flipped(0.1, -2, -0.1),
        w10(0.164146942774017, -1.99116951183221, -0.190874255368313);
    const auto rates_at = [](double t, int n) {
        return body_rates(box(), run(step_buss, box(), spinning_box({0.1, 2, 0.1}), t, n));
    };
    std::vector<double> errors;
    for (int n : {100, 200, 400})
        errors.push_back((rates_at(5, n) - w5).norm());
    check_order(errors, 2);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(1e-3)));
    REQUIRE_THAT(rates_at(9.41035970436993, 1000), IsClose(flipped, Order(1e-2)));
    REQUIRE_THAT(rates_at(10, 1000), IsClose(w10, Order(1e-2)));
}

TEST_CASE("rotation: about the middle axis a wobble grows exponentially", "[A3.16][rotation]")
{
    // growth rate λ = W √((I₁-I₂)(I₂-I₃)/(I₁I₃)), and the direction (ω₁, ω₃) of pure growth
    const double W = 2, growth = 0.960768922830523, small = 1e-5, t = 2;
    const double third = growth * 13 / ((10 - 5) * W);
    std::vector<double> errors;
    for (int n : {50, 100, 200}) {
        const auto end = run(step_buss, box(), spinning_box({small, W, small * third}), t, n);
        const Vector3d w = body_rates(box(), end) / (small * std::exp(growth * t));
        errors.push_back(std::hypot(w.x() - 1, w.z() - third));
    }
    check_order(errors, 2);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(1e-3)));
}

TEST_CASE("rotation: Buss's step turns the symmetric rotor with order 2", "[A3.16][rotation]")
{
    std::vector<double> errors, cone_errors;
    for (int n : {100, 200, 400}) {
        const auto end = run(step_buss, rotor, spinning_rotor(), 1, n);
        errors.push_back(turn_between(eigen(end.orientation), rotor_orientation(1)).norm());
        const Vector3d axis = eigen(end.orientation) * Vector3d::UnitZ();
        const double cone = std::atan2(axis.cross(rotor_L).norm(), axis.dot(rotor_L));
        cone_errors.push_back(std::abs(cone * 180 / 3.14159265358979 - 56.1454851873795));
    }
    check_order(errors, 2);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(2e-3)));
    REQUIRE_THAT(cone_errors.back(), IsClose(0.0, Order(0.05)));
}

TEST_CASE("rotation: Buss's step leaves out Δt³ ω̈/6 and nothing else", "[A3.16][rotation]")
{
    // ω of a symmetric rotor precesses about L: ω̈ = (L/I) × ((L/I) × ω). The other sign of the
    // last term of Ω would leave Δt³/6 ω̇ × ω as well.
    const Vector3d P = rotor_L / rotor_I;
    const Vector3d left_out = P.cross(P.cross(rotor_w)) / 6;
    std::vector<double> errors;
    for (double h : {0.02, 0.01, 0.005}) {
        const RigidState after = step_buss(spinning_rotor(), rotor, {}, h);
        const Vector3d missing = turn_between(rotor_orientation(h), eigen(after.orientation));
        errors.push_back((missing / (h * h * h) - left_out).norm() / left_out.norm());
    }
    check_order(errors, 1);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(0.02)));
}

TEST_CASE("rotation: the energy error of Buss's step is -Δt³/3 (ω̇ × ω)·Iω̇", "[A3.16][rotation]")
{
    // The effect of the missing Δt³ ω̈/6 on the energy of a free body. The other sign of the last
    // term of Ω would halve it.
    const Vector3d w(1, 2, 3), L(13, 20, 15);
    const Vector3d I_w_dot = -w.cross(L);
    const Vector3d w_dot = box().inverse_inertia * I_w_dot;
    const double expected = -w_dot.cross(w).dot(I_w_dot) / 3;
    std::vector<double> errors;
    for (double h : {0.02, 0.01, 0.005}) {
        const RigidState after = step_buss(spinning_box(w), box(), {}, h);
        const double gained = kinetic_energy_of_rotation(box(), after) - 49;
        errors.push_back(std::abs(gained / (h * h * h) / expected - 1));
    }
    check_order(errors, 1);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(0.02)));
}

TEST_CASE("rotation: under a torque Buss's step is of order 2", "[A3.16][rotation]")
{
    RigidState start = spinning_box({1, 2, 3});
    start.orientation = {0.5, {0.1, -0.7, 0.5}};
    const Wrench wrench = {{0, 0, 0}, {30, -50, 40}};
    const Eigen::Quaterniond exact = runge_kutta(box(), start, wrench.torque, 1, 4000);
    std::vector<double> errors;
    for (int n : {50, 100, 200}) {
        const auto end = run(step_buss, box(), start, 1, n, wrench);
        errors.push_back(turn_between(eigen(end.orientation), exact).norm());
    }
    check_order(errors, 2);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(1e-3)));
}

TEST_CASE("rotation: a fast top precesses steadily", "[A3.16][rotation]")
{
    // A cone of 1 kg, radius 5 cm and height 10 cm stands on its apex, 30° off the vertical, and
    // spins at 500 rad/s. With L about the apex, its axis precesses at 2.0222 rad/s. The torque
    // follows the axis and is held over each step, which leaves order 1.
    const double m = 1, I = 6.375e-3, J = 7.5e-4, center = 0.075, spin = 500, end = 0.5;
    const double tilt = 0.523598775598299, precession = 2.02220460968698;
    const BodyInertia top = {1 / m, Vector3d(1 / I, 1 / I, 1 / J).asDiagonal()};
    const auto axis_of = [](const RigidState& state) {
        return Vector3d(eigen(state.orientation) * Vector3d::UnitZ());
    };
    std::vector<double> errors;
    for (int n : {500, 1000, 2000}) {
        RigidState state;
        state.orientation = plain(turn({0, 0, -tilt}) * turn({-1.5707963267949, 0, 0}));
        const Vector3d start = axis_of(state), w(0, precession, 0);
        state.angular_momentum = I * (w - w.dot(start) * start) + J * spin * start;
        for (int i = 0; i < n; ++i) {
            const Vector3d torque = (center * axis_of(state)).cross(Vector3d(0, -9.81 * m, 0));
            state = step_buss(state, top, {{0, 0, 0}, torque}, end / n);
        }
        const Vector3d axis = axis_of(state);
        errors.push_back(std::abs(std::atan2(-axis.z(), axis.x()) - precession * end));
    }
    check_order(errors, 1);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(1e-4)));
}
