// SPDX-License-Identifier: MIT
// The numbers that a handout says of its scenes.
#include "handouts/handouts.hpp"
#include "handouts/reached/scene_runs.hpp"
#include "rigid/step/step.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/run/make_world.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::handouts;

TEST_CASE("scenes: a matrix without repair swells, and the velocity modes hardly do", "[tables]")
{
    const auto growth = [](const std::string& name) {
        const Run bar = run(name, {});
        return bar.last.solids[0].totals.elastic_energy;
    };
    const double swollen = growth("a3-rotation/unrepaired_matrix");
    const Run bar = run("a3-rotation/unrepaired_matrix", {});
    // The length grows by √(1 + |ω|² h²) in each of the 250 steps, the energy by its square.
    const double longer = std::sqrt(bar.last.solids[0].totals.kinetic_energy /
                                    bar.first.solids[0].totals.kinetic_energy);
    CHECK(std::abs(longer - std::pow(1 + 9 * 0.02 * 0.02, 125)) < 1e-9 * longer);
    check_says("a3-rotation",
               "after 250 steps it is " + number(longer, "%.2f") + " times as long.");
    CHECK(swollen > 1e4);
    CHECK(growth("a1-kinematics/velocity_modes") < 1e-6 * swollen);
}

TEST_CASE("scenes: a spin that was filmed is too slow by the sine formula", "[tables]")
{
    const Run cubes = run("a1-kinematics/filmed_spin", {});
    const double I = 1.28;
    double sum = 5; // ω of the first cube [rad/s]
    for (const double apart : {0.1, 0.4})
        sum += std::sin(5 * apart) / apart;
    CHECK(std::abs(cubes.first.angular_momentum.z() - I * sum) < 1e-12 * I * sum);
}

TEST_CASE("scenes: a force has the torque of its point in world space", "[tables]")
{
    const Run cubes = run("a1-kinematics/one_wrench", {});
    const double impulse = 600 * 0.3; // [N s], on each cube
    CHECK(std::abs(cubes.last.momentum.x() - 3 * impulse) < 1e-9 * impulse);
}

TEST_CASE("scenes: a box whose spin is held gains energy", "[numbers]")
{
    const Run box = run("a3-rotation/held_spin", {});
    const double first = box.first.kinetic_energy, last = box.last.kinetic_energy;
    check_says("a3-rotation", "goes from " + number(first, "%.0f") + " J to " +
                                  number(last, "%.1f") + " J, " + number(last / first, "%.2f") +
                                  " times as much");
}

TEST_CASE("scenes: the period of the box and the cone of the rotor", "[numbers]")
{
    // Moments a < b < c, 2 T = ω·Iω and L² of the box with ω = (1, 2, 3). The period of ω is
    // 4 K(m) √(a b c / ((b - a)(2 T c - L²))), K(m) = π/2 / agm(1, √(1 - m)).
    const double a = 5, b = 10, c = 13, twice = 98, L2 = 794;
    const double scale = (b - a) * (twice * c - L2);
    double x = 1, y = std::sqrt(1 - (c - b) * (L2 - twice * a) / scale);
    for (int i = 0; i < 8; ++i) {
        const double mean = (x + y) / 2;
        y = std::sqrt(x * y);
        x = mean;
    }
    const double K = std::numbers::pi / 2 / x;
    check_says("a3-rotation",
               "its period of " + number(4 * K * std::sqrt(a * b * c / scale), "%.3f") + " s");
    // a rotor with I = 0.04 across its axis z and 0.02 about it, ω = (2, -4, 6)
    const Vector3d L(0.04 * 2, 0.04 * -4, 0.02 * 6);
    const double cone = std::acos(L.z() / L.norm()) * 180 / std::numbers::pi;
    check_says("a3-rotation", "on its cone of " + number(cone, "%.2f") + "°");
    check_says("a3-rotation",
               "go around $L$ together, at " + number(L.norm() / 0.04, "%.3f") + " rad/s");
}

TEST_CASE("scenes: the particles that move by six numbers", "[numbers]")
{
    const Scene scene =
        load_scene(assignments() / "a1-kinematics" / "scenes" / "velocity_modes.json");
    const std::size_t n = make_deformable_world(scene).solids.at(0).rest.vertices.size();
    check_says("a1-kinematics", "it moves " + std::to_string(n) + " particles with");
    CHECK(scene.description.find("A bar of " + std::to_string(n)) == 0);
}

TEST_CASE("scenes: the first step of the seesaw", "[numbers]")
{
    const Scene scene = load_scene(assignments() / "a5-contact" / "scenes" / "seesaw.json");
    World world = make_world(scene);
    const Vector3d edge(-0.03, 0.5, 0); // the left edge of the ridge
    double torque = 0, inertia = 0;
    for (const RigidBody& body : world.bodies) {
        if (body.is_static) continue;
        const Vector3d arm = body.state.position - edge;
        torque -= 9.81 * body.mass * arm.x();
        inertia += body.inertia(2, 2) + body.mass * arm.squaredNorm();
    }
    const double together = torque / inertia;
    check_says("a5-contact", "= " + number(together, "%.8f") + " \\ \\mathrm{rad}/\\mathrm{s}^2");
    check_says("a5-contact", "turns with " + number(together, "%.8f") + " rad/s²");
    step(world, scene.time_step);
    const RigidBody& plank = world.bodies.at(2);
    const double w = plank.state.angular_momentum.z() / plank.inertia(2, 2);
    const double by_shocks = w / scene.time_step;
    check_says("a5-contact", "shock propagation gives " + number(by_shocks, "%.2f") + ".");
    check_says("a5-contact",
               "and the error is " + number(100 * (by_shocks / together - 1), "%.0f") + " %.");
}
