// SPDX-License-Identifier: MIT
// Springs and dampers between bodies of which some stand on the ground: what contacts hold does not
// fall within a step, so dampers do not feel such a fall.
#include "classics/problems.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace springs_on_the_ground {

using namespace rigor;
using namespace rigor::testing;

namespace {

RigidBody with_mass(RigidBody body, double M)
{
    set_mass(body, M, body.inertia * (M / body.mass));
    return body;
}

// A body of 20 kg on a spring that stands on a wheel or a block, which stands on the ground or on a
// road. The spring bears the weight of the body.
struct Stand {
    double wheel_mass, stiffness, damping;
    bool is_box;

    static constexpr double body_mass = 20, length = 0.5;
    double height() const
    {
        return length - body_mass * g / stiffness;
    } // from the wheel to the body [m]

    World world(const RigidBody& ground) const
    {
        const Shape shape = is_box ? Shape(Box{{0.2, 0.1, 0.2}}) : Shape(Sphere{0.05});
        World world =
            solved({ground, with_mass(body_of(shape, {0, 0.05, 0}, {0, 0.5}), wheel_mass),
                    with_mass(body_of(Box{{0.2, 0.2, 0.2}}, {0, 0.05 + height(), 0}), body_mass)});
        world.springs = {{1, 2, {0, 0, 0}, {0, 0, 0}, stiffness, damping, length}};
        return world;
    }
};

} // namespace

TEST_CASE("classics: what stands on a damped spring stays in equilibrium", "[classics]")
{
    Sweep sweep;
    for (const double wheel_mass : {0.3, 3., 30.})
        for (const double damping : {0., 20., 80., 320.})
            for (const bool is_box : {false, true})
                for (const double h : {0.02, 0.01, 0.0025}) {
                    if (!sweep.takes_next()) continue;
                    CAPTURE(wheel_mass, damping, is_box, h);
                    const Stand stand{wheel_mass, 4000, damping, is_box};
                    World world = stand.world(fixed(Box{{4, 1, 4}}, {0, 0.5}, {0, -0.5, 0}));
                    double off = 0;
                    for (int n = 0; n * h < 2; ++n) {
                        step(world, h);
                        off = std::max(off, std::abs(world.bodies[2].state.position.y() - 0.05 -
                                                     stand.height()));
                    }
                    check_at_most(off, 1e-6, "distance from the equilibrium [m]");
                }
}

// The body on the spring over a wavy road (a quarter of a car): the wheel follows the road y(t), so
// M X'' = k (l - (X - y - r)) - c (X' - y') - M g.
TEST_CASE("classics: a quarter of a car on a wavy road", "[classics]")
{
    const double A = 0.005, f = 2, w = 2 * pi * f, T = 3;
    for (const double wheel_mass : {0.5, 3.}) {
        const Stand stand{wheel_mass, 4000, 80, false};
        using State = std::array<double, 2>; // X, from the equilibrium on a flat road, and X'
        const auto rate = [&](double t, const State& s) -> State {
            const double y = A * std::sin(w * t), v = A * w * std::cos(w * t);
            return {s[1],
                    (stand.stiffness * (y - s[0]) + stand.damping * (v - s[1])) / Stand::body_mass};
        };
        State s = {0, A * w};
        const int fine = 30000;
        for (int n = 0; n < fine; ++n) { // Runge and Kutta
            const double h = T / fine, t = n * h;
            const auto at = [&](const State& k, double part) -> State {
                return {s[0] + part * h * k[0], s[1] + part * h * k[1]};
            };
            const State k1 = rate(t, s), k2 = rate(t + h / 2, at(k1, 0.5)),
                        k3 = rate(t + h / 2, at(k2, 0.5)), k4 = rate(t + h, at(k3, 1));
            for (int i = 0; i < 2; ++i)
                s[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
        }
        std::vector<double> errors;
        for (const int steps : {300, 600, 1200}) {
            World world =
                stand.world(driven(Box{{4, 1, 4}}, {0, 0.5}, {0, -0.5, 0}, shaking({0, A, 0}, f)));
            for (int i : {1, 2})
                world.bodies[i].state.velocity = {0, A * w, 0};
            run(world, steps, T / steps);
            const RigidState& body = world.bodies[2].state;
            const double x = body.position.y() - 0.05 - stand.height();
            const double natural = std::sqrt(stand.stiffness / Stand::body_mass);
            errors.push_back(std::hypot(x - s[0], (body.velocity.y() - s[1]) / natural));
        }
        CAPTURE(wheel_mass, errors);
        check_at_most(errors[0], 0.15 * A, "error with steps of 10 ms [m]");
        check_order(errors, 2);
    }
}

TEST_CASE("classics: a smooth floor takes nothing from a block on a spring", "[classics]")
{
    for (const double turn_of_a_step : {0.14, 0.28, 1., 3., 10.}) // angular frequency times h
        for (const double h : {0.01, 1 / 60.}) {
            CAPTURE(turn_of_a_step, h);
            const double w = turn_of_a_step / h, M = 0.3, A = 0.05, T = 3;
            World world =
                solved({fixed(Plane{}, {0, 0}),
                        with_mass(body_of(Box{{0.1, 0.1, 0.1}}, {A, 0.05, 0}, {0, 0}), M)});
            world.springs = {{-1, 1, {-1, 0.05, 0}, {0, 0, 0}, M * w * w, 0, 1}};
            const int steps = static_cast<int>(std::lround(T / h));
            run(world, steps, h);
            const double x = world.bodies[1].state.position.x(),
                         v = world.bodies[1].state.velocity.x();
            check_at_most(std::abs(std::hypot(x, v / w) - A), 1e-6 * A, "change of amplitude [m]");
            check_at_most(std::abs(x - A * std::cos(w * steps * h)), 2e-3 * A,
                          "error of the place");
        }
}

TEST_CASE("classics: friction takes energy from a block on a spring however stiff it is",
          "[classics][unsanitized]")
{
    Sweep sweep;
    for (const double k : {1e3, 1e4, 5e4, 1.2e5, 2e5, 1e6, 1e7})
        for (const double mu : {0.05, 0.3, 1.})
            for (const double h : {0.01, 1 / 60.}) {
                if (!sweep.takes_next()) continue;
                CAPTURE(k, mu, h);
                World world =
                    solved({fixed(Plane{}, {0, mu}),
                            with_mass(body_of(Box{{0.2, 0.2, 0.2}}, {0.001, 0.1, 0}, {0, mu}), 1)});
                world.springs = {{-1, 1, {-1, 0.1, 0}, {0, 0, 0}, k, 0, 1}};
                const double first = k * 1e-6 / 2;
                double most = 0;
                for (int n = 0; n * h < 1; ++n) {
                    step(world, h);
                    const double x = world.bodies[1].state.position.x(),
                                 v = world.bodies[1].state.velocity.x();
                    most = std::max(most, v * v / 2 + k * x * x / 2);
                }
                check_at_most(most, (1 + 1e-6) * first, "energy [J]");
            }
}

// Friction holds a block, from which a body hangs by a damped spring that is pulled at.
TEST_CASE("classics: a block that friction holds is a fixed end of a damped spring", "[classics]")
{
    const double k = 500, force = 8;
    for (const double damping : {0.5, 30., 200.})
        for (const double h : {0.02, 0.01, 0.0025}) {
            CAPTURE(damping, h);
            World world =
                solved({fixed(Plane{}, {0, 0.5}),
                        with_mass(body_of(Box{{0.2, 0.2, 0.2}}, {0, 0.1, 0}, {0, 0.8}), 3),
                        with_mass(body_of(Box{{0.2, 0.2, 0.2}}, {1, 0.1, 0}, {0, 0}), 2)});
            world.springs = {{1, 2, {0, 0, 0}, {0, 0, 0}, k, damping, 1}};
            AppliedForce pull;
            pull.body = 2;
            pull.force = {force, 0, 0};
            world.forces = {pull};
            world.bodies[2].state.position.x() = 1 + force / k; // in equilibrium
            run_until(world, 2, h);
            check_at_most(std::abs(world.bodies[2].state.position.x() - 1 - force / k), 1e-7,
                          "distance from the equilibrium [m]");
            check_at_most(std::abs(world.bodies[1].state.position.x()), 1e-9, "slip [m]");
        }
}

} // namespace springs_on_the_ground
