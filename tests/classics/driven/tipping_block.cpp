// SPDX-License-Identifier: MIT
// A block that tips over its edge does so on any ground alike that has no acceleration: at rest, as
// a belt, before its drive starts, or as part of a motion that is too small to count. On a ground
// that is shaken, the block tips by the equation of motion in the frame of the ground,
//
//     (M d² + I) θ'' = -M g d sin(α - θ) + M a d cos(α - θ)
//
// with the distance d of the edge from the center of mass, the angle α of this line to the
// vertical, and the acceleration -a of the ground (Housner 1963, "The behavior of inverted pendulum
// structures during earthquakes").
#include "classics/problems.hpp"

namespace tipping_block {

using namespace rigor;
using namespace rigor::testing;

namespace {

const Vector3d sides(0.25, 1, 0.3); // sides of the block, M = 1 kg [m]
const Material rough{0, 3};

RigidBody block()
{
    RigidBody body = body_of(Box{sides}, {0, sides.y() / 2, 0}, rough);
    const Vector3d squares = sides.cwiseProduct(sides);
    set_mass(body, 1, (Vector3d::Constant(squares.sum()) - squares).asDiagonal() * (1. / 12));
    return body;
}

double tilt(const World& world)
{
    const Quaternion& q = world.bodies[1].state.orientation;
    return 2 * std::atan2(q.v.norm(), std::abs(q.s));
}

// The tilt after a time T from the equation of motion, by the midpoint rule with very small steps.
double exact_tilt(double T, const std::function<double(double)>& acceleration)
{
    const int steps = 200000;
    const double h = T / steps, d = 0.5 * std::hypot(sides.x(), sides.y()),
                 alpha = std::atan2(sides.x(), sides.y()),
                 I = (sides.x() * sides.x() + sides.y() * sides.y()) / 12;
    double theta = 0, rate = 0;
    for (int i = 0; i < steps; ++i) {
        const auto angular = [&](double t, double angle) {
            const double a = acceleration(t), s = alpha - angle;
            return d * (a * std::cos(s) - g * std::sin(s)) / (d * d + I);
        };
        const double t = i * h;
        if (theta == 0 && angular(t + h / 2, 0) <= 0) continue; // it still stands
        const double middle = theta + h / 2 * rate, rate_middle = rate + h / 2 * angular(t, theta);
        rate += h * angular(t + h / 2, middle);
        theta += h * rate_middle;
    }
    return theta;
}

} // namespace

TEST_CASE("classics: a block tips alike on grounds that have no acceleration", "[classics]")
{
    const double T = 0.4, rise = 20; // the force at the center of mass is this times t [N/s]
    const double exact = exact_tilt(T, [&](double t) { return rise * t; });
    Drive later = moving({1, 0, 0}), ended = moving({1, 0, 0}), belt = moving({1e-9, 0, 0});
    later.start = 10;
    ended.start = -2;
    ended.end = -1;
    belt.is_belt = true;
    const std::pair<std::string, Drive> grounds[] = {{"at rest", {}},
                                                     {"moves", moving({1, 0, 0})},
                                                     {"starts later", later},
                                                     {"has ended", ended},
                                                     {"is a belt", belt},
                                                     {"hardly shakes", shaking({1e-9, 0, 0}, 1)},
                                                     {"hardly turns", turning({0, 1e-9, 0})}};
    for (const double h : {0.01, 0.005})
        for (const auto& [name, drive] : grounds) {
            CAPTURE(h, name);
            RigidBody body = block();
            if (name == "moves") body.state.velocity = {1, 0, 0};
            World world = solved({driven(Box{{8, 0.2, 2}}, rough, {0, -0.1, 0}, drive), body});
            AppliedForce force;
            force.body = 1;
            force.force = {rise, 0, 0};
            force.factor = [](double t) { return t; };
            world.forces = {force};
            run_until(world, T, h);
            CHECK_THAT(tilt(world), IsClose(exact, Order(3 * h * h)));
        }
}

TEST_CASE("classics: a block tips on a ground that is shaken", "[classics]")
{
    const double T = 0.4, A = 0.08, omega = 2 * pi * 1.1;
    const double exact =
        exact_tilt(T, [&](double t) { return A * omega * omega * std::sin(omega * t); });
    std::vector<double> errors;
    for (const double h : {0.02, 0.01, 0.005}) {
        RigidBody body = block();
        body.state.velocity = {A * omega, 0, 0};
        World world =
            solved({driven(Box{{8, 0.2, 2}}, rough, {0, -0.1, 0}, shaking({A, 0, 0}, 1.1)), body});
        run_until(world, T, h);
        errors.push_back(std::abs(tilt(world) - exact));
    }
    CAPTURE(errors, exact);
    CHECK(errors[2] < 0.1 * errors[0]);
    check_at_most(errors[1], 1e-3 * exact, "error of the tilt at the default step [rad]");
}

} // namespace tipping_block
