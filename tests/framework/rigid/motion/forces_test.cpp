// SPDX-License-Identifier: MIT
// Bodies on which springs and applied forces pull.
#include "framework/rigid/integrators.hpp"
#include "framework/rigid/worlds.hpp"
#include "rigid/motion/forces.hpp"
#include "rigid/step/step.hpp"
#include "support/free_rotor.hpp"

#include <algorithm>
#include <complex>

using namespace rigor;
using namespace rigor::testing;

namespace {

// A box on a spring along x whose other end is fixed at the origin and whose rest length is 0.
World oscillator(double stiffness, double damping = 0)
{
    World world = world_of({free_box()}, {0, 0, 0});
    world.bodies[0].state.position = {1, 0, 0};
    world.springs.push_back({0, -1, {0, 0, 0}, {0, 0, 0}, stiffness, damping, 0});
    return world;
}

// A box that hangs on a spring by a point off its center, swings and rotates.
World swing()
{
    World world = world_of({free_box({0.3, -0.2, 0.5})});
    world.bodies[0].state.position = {1, -1, 0};
    world.springs.push_back({0, -1, {0.5, 0.3, -0.2}, {0, 0, 0}, 600, 0, 1});
    return world;
}

double energy(const World& world)
{
    const RigidBody& body = world.bodies[0];
    const RigidState& s = body.state;
    const Spring& spring = world.springs[0];
    const Vector3d end = rotation_matrix(s.orientation) * spring.point1 + s.position;
    const double stretch = (end - spring.point2).norm() - spring.rest_length;
    return totals(world).kinetic_energy - body.mass * world.settings.gravity.dot(s.position) +
           0.5 * spring.stiffness * stretch * stretch;
}

} // namespace

TEST_CASE("pulled: a spring between two bodies keeps their momentum and its period", "[rigid]")
{
    const double k = 40;
    for (const Integrator integrator : {Integrator::matrix, Integrator::runge_kutta}) {
        std::vector<double> errors;
        for (int n : {50, 100, 200}) {
            RigidBody a = free_box(), b = a;
            set_mass(b, 4, a.inertia);
            b.state.position = {1.5, 0, 0};
            World world = world_of({a, b}, {0, 0, 0});
            world.settings.integrator = integrator;
            world.springs.push_back({0, 1, {0, 0, 0}, {0, 0, 0}, k, 0, 1});
            const double omega = std::sqrt(k / 3); // the reduced mass is 12·4/16
            const double end = 3 / omega;
            run(world, n, end / n);
            const double distance =
                (world.bodies[1].state.position - world.bodies[0].state.position).x();
            errors.push_back(std::abs(distance - (1 + 0.5 * std::cos(omega * end))));
            CHECK_THAT(totals(world).momentum, IsClose(Vector3d(0, 0, 0), Rounding(n, 20)));
        }
        check_order(errors, 4);
        CHECK(errors.back() < 1e-7);
    }
}

TEST_CASE("pulled: off-center springs and forces keep their order while bodies turn", "[rigid]")
{
    for (const auto& [integrator, damping] :
         {std::pair(Integrator::runge_kutta, 0.0), std::pair(Integrator::runge_kutta, 0.5),
          std::pair(Integrator::matrix, 0.0), std::pair(Integrator::matrix, 0.5)}) {
        CAPTURE(integrator, damping);
        const auto end_state = [kind = integrator, c = damping](int n) {
            World world = world_of({free_box({1, 2, 3}), free_box({-2, 0.5, 1})});
            world.settings.integrator = kind;
            world.bodies[1].state.position = {2, 0, 0};
            world.springs.push_back({0, 1, {0.5, 0.3, -0.2}, {-0.4, 0.1, 0.6}, 60, c, 1});
            world.springs.push_back({0, -1, {0, 1, 0}, {0, 3, 0}, 30, 0, 1});
            world.forces.push_back({1, {3, -2, 5}, {0.2, 0.4, 0.1}, 0, 100});
            run(world, n, 1.0 / n);
            return world.bodies[0].state;
        };
        const RigidState exact = end_state(2560);
        std::vector<double> errors;
        for (int n : {40, 80, 160}) {
            const RigidState s = end_state(n);
            errors.push_back((s.position - exact.position).norm() +
                             rotation_angle(eigen(s.orientation), eigen(exact.orientation)));
        }
        check_order(errors, 4);
    }
}

TEST_CASE("pulled: a damped spring keeps its order and its decay", "[rigid]")
{
    const double k = 600, c = 30, m = 12, end = 1;
    const double gamma = c / (2 * m), omega = std::sqrt(k / m - gamma * gamma);
    const double exact =
        std::exp(-gamma * end) * (std::cos(omega * end) + gamma / omega * std::sin(omega * end));
    for (const Integrator integrator : {Integrator::matrix, Integrator::runge_kutta}) {
        std::vector<double> errors;
        for (int n : {50, 100, 200}) {
            World world = oscillator(k, c);
            world.settings.integrator = integrator;
            run(world, n, end / n);
            errors.push_back(std::abs(world.bodies[0].state.position.x() - exact));
        }
        check_order(errors, 4);
        CHECK(errors.back() < 1e-6);
    }
}

TEST_CASE("pulled: what swings on a spring keeps its energy", "[rigid]")
{
    const double h = 0.05, start = energy(swing());
    const auto worst = [&](World& world, int steps) {
        double largest = 0;
        for (int i = 0; i < steps; ++i) {
            step(world, h);
            largest = std::max(largest, std::abs(energy(world) - start));
        }
        return largest;
    };
    World world = swing();
    const double first = worst(world, 2000);
    worst(world, 16000);
    CHECK(worst(world, 2000) < 2 * first);
    CHECK(first < 1e-4 * std::abs(start));

    World losing = swing();
    losing.settings.integrator = Integrator::matrix;
    CHECK(worst(losing, 2000) > 10 * first);
}

TEST_CASE("pulled: springs and dampers of any stiffness follow the exact motion", "[rigid]")
{
    const double h = 0.01, m = 12;
    for (const double zeta : {0., 0.05, 0.3, 2., 10.}) // share of the critical damping
        for (const double phase : {0.2, 0.9, 1.1, 2., 4.9, 5.2, 7., 30., 90., 400.}) {
            if (2 * zeta * phase > 400) continue;
            CAPTURE(zeta, phase);
            const double omega = phase / h, gamma = zeta * omega;
            World world = oscillator(m * omega * omega, 2 * m * gamma);
            // x'' + 2 γ x' + ω² x = 0 with x = 1, x' = 0 has the roots -γ ± s.
            const std::complex<double> s = std::sqrt(std::complex(gamma * gamma - omega * omega));
            for (int i = 1; i * phase < 40; ++i) {
                step(world, h);
                const double t = i * h;
                const double exact = (std::exp((s - gamma) * t) * (s + gamma) / (2. * s) +
                                      std::exp((-s - gamma) * t) * (s - gamma) / (2. * s))
                                         .real();
                REQUIRE_THAT(world.bodies[0].state.position.x(), IsClose(exact, Order(6e-3)));
            }
            run(world, 50, h);
            check_at_most(world.bodies[0].state.position.norm(), 1.001, "distance [m]");
        }
}

TEST_CASE("pulled: a spring too stiff for the step is refused in words", "[rigid]")
{
    World world = oscillator(12e12);
    CHECK_THROWS_WITH(step(world, 0.01), Catch::Contains("spring or damper is too stiff"));
    // The message compares √(k/M) h, which is 2000 · 0.3 at the second body, with its limit.
    world = oscillator(12);
    world.bodies.push_back(free_box());
    world.bodies[1].name = "fast";
    world.springs.push_back({1, -1, {0, 0, 0}, {0, 0, 0}, 12 * 4e6, 0, 0});
    CHECK_THROWS_WITH(step(world, 0.3),
                      Catch::Contains("body 'fast'") && Catch::Contains("up to 500, found 600"));
    CHECK_NOTHROW(step(world, 0.2499));
    world.springs.clear();
    world.forces.push_back({1, {1, 0, 0}, {0, 0, 0}, 0, 100, {0, 0, 0}, false, 1000});
    CHECK_THROWS_WITH(step(world, 0.1),
                      Catch::Contains("body 'fast'") && Catch::Contains("up to 500, found 628.3"));
    world = oscillator(12e12);
    world.springs[0].stiffness = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS(step(world, 0.01));
}

TEST_CASE("pulled: a force from one step's start to another's gives its whole impulse", "[rigid]")
{
    for (const Integrator integrator : all_integrators) {
        CAPTURE(static_cast<int>(integrator));
        World world = world_of({free_box()}, {0, 0, 0});
        world.settings.integrator = integrator;
        world.forces.push_back({0, {6, 0, 0}, {0, 0, 0}, 0.25, 0.75});
        run(world, 16, 0.0625);
        CHECK_THAT(world.bodies[0].state.velocity, IsClose(Vector3d(0.25, 0, 0), Rounding(16)));
    }
}

TEST_CASE("forces: the rate of a medium is the derivative of its drag", "[rigid]")
{
    const auto drag_at = [](const Drag& drag, double v) {
        return drag.linear * v + drag.quadratic * v * v;
    };
    World world = world_of({free_box()}, {0, 0, 0});
    for (const Drag& drag : {Drag{2, 0, 0}, Drag{0, 3, 0}, Drag{2, 3, 0}})
        for (const double v : {0.1, 1.0, 50.0}) {
            CAPTURE(drag.linear, drag.quadratic, v);
            world.bodies[0].drag = drag;
            world.bodies[0].state.velocity = v * Vector3d(2, -1, 2) / 3;
            const double dv = 1e-3 * v, M = world.bodies[0].mass;
            const double slope = (drag_at(drag, v + dv) - drag_at(drag, v - dv)) / (2 * dv);
            // The central difference of a parabola is exact.
            CHECK_THAT(fastest_force_rate(world).rate, IsClose(slope / M, Rounding(1e5)));
        }
}
