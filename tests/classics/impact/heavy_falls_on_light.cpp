// SPDX-License-Identifier: MIT
// A heavy body falls on a light one that lies on the ground, without restitution. By Poisson's and
// by Newton's law of plastic impact everything stops (Routh 1905, "Dynamics of a system of rigid
// bodies", chapter IV): nothing leaves, and energy never rises. Only the ratio of the masses makes
// it hard: the ground's push reaches the heavy body through the light one.
#include "classics/problems.hpp"

#include "geometry/meshes/generators.hpp"
#include "geometry/shapes/solid_mesh.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

double energy_of(const World& world)
{
    double energy = totals(world).kinetic_energy;
    for (const RigidBody& body : world.bodies)
        energy += body.mass * g * body.state.position.y();
    return energy;
}

void multiply_mass(RigidBody& body, double ratio)
{
    set_mass(body, ratio * body.mass, ratio * body.inertia);
}

constexpr double height = 0.4;                         // height of the fall [m]
const double impact_speed = std::sqrt(2 * g * height); // [m/s]

struct Fall {
    double leaves = 0; // highest upward speed of a body [m/s]
    double gain = 0;   // largest rise of the energy in a step, over the energy of the fall
    double sinks = 0;  // how far the heavy body ends below its place [m]
};

Fall fall(World world, double rest_height, double h)
{
    Fall result;
    const RigidBody& heavy = world.bodies[2];
    const double scale = heavy.mass * g * height;
    double before = energy_of(world);
    for (double t = 0; t < 1; t += h) {
        step(world, h);
        const double energy = energy_of(world);
        result.gain = std::max(result.gain, (energy - before) / scale);
        before = energy;
        for (const RigidBody& body : world.bodies)
            result.leaves = std::max(result.leaves, body.state.velocity.y());
    }
    result.sinks = rest_height - heavy.state.position.y();
    return result;
}

struct Upper {
    const char* name;
    Shape shape;
    double half; // its lowest point below its center [m]
};

std::vector<Upper> uppers()
{
    return {{"box", Box{{1, 1, 1}}, 0.5},
            {"sphere", Sphere{0.5}, 0.5},
            {"capsule", Capsule{0.5, 0.6}, 0.8},
            {"cylinder", Cylinder{0.5, 1}, 0.5},
            {"cone", Cone{0.5, 1}, 0.25},
            {"ellipsoid", Ellipsoid{{0.6, 0.5, 0.4}}, 0.5},
            {"torus", Torus{0.4, 0.1}, 0.1},
            {"mesh", Mesh{std::make_shared<SolidMesh>(box_mesh({1, 1, 1}))}, 0.5}};
}

} // namespace

TEST_CASE("classics: a heavy body that falls on a light one stops with it",
          "[classics][unsanitized]")
{
    Sweep sweep;
    const Material plastic{0, 0.5};
    for (const ContactMethod method :
         {ContactMethod::built_in, ContactMethod::simultaneous, ContactMethod::one_at_a_time,
          ContactMethod::shock_propagation})
        for (const double h : {1 / 60., 1 / 240.})
            for (const Upper& upper : uppers())
                for (const double ratio : {1., 10., 1e2, 1e3, 1e4, 1e5, 1e6}) {
                    if (method != ContactMethod::built_in && h < 1 / 100.) continue;
                    if (!sweep.takes_next()) continue;
                    CAPTURE(static_cast<int>(method), h, upper.name, ratio);
                    RigidBody light = body_of(Box{{1, 1, 1}}, {0, 0.5, 0}, plastic);
                    RigidBody heavy =
                        body_of(upper.shape, {0, 1 + height + upper.half, 0}, plastic);
                    multiply_mass(heavy, ratio * light.mass / heavy.mass);
                    World world = world_of({fixed(Plane{}, plastic), light, heavy});
                    world.settings.contact_method = method;
                    world.settings.formulas_are_reference = true;
                    const Fall f = fall(world, 1 + upper.half, h);
                    const bool solves_all_at_once =
                        method == ContactMethod::built_in || method == ContactMethod::simultaneous;
                    if (solves_all_at_once) {
                        check_at_most(f.leaves, 1e-3 * impact_speed, "speed of leaving");
                        check_at_most(f.sinks, 1e-5, "sinking [m]");
                        check_at_most(f.gain, 1e-9, "gain of energy");
                    } else { // a fixed number of impulses leaves overlap, which is then corrected
                        check_at_most(f.leaves, 0.2 * impact_speed, "speed of leaving");
                        check_at_most(f.gain, 1e-3, "gain of energy");
                    }
                }
}

namespace {

struct Leg {
    const char* name;
    Shape shape;
    double height; // [m]
};

// A slab above columns of light bodies, with `ratio` times the mass of each.
World slab_on_legs(const Leg& leg, int columns, int layers, double ratio)
{
    const Material plastic{0, 0.5};
    std::vector<RigidBody> bodies = {fixed(Plane{}, plastic)};
    for (int layer = 0; layer < layers; ++layer)
        for (int i = 0; i < columns; ++i) {
            const double angle = 2 * std::numbers::pi * (i + 0.5) / columns;
            bodies.push_back(
                body_of(leg.shape,
                        {0.6 * std::cos(angle), (layer + 0.5) * leg.height, 0.6 * std::sin(angle)},
                        plastic));
        }
    RigidBody slab =
        body_of(Box{{1.6, 0.3, 1.6}}, {0, layers * leg.height + 0.15 + height, 0}, plastic);
    multiply_mass(slab, ratio * bodies[1].mass / slab.mass);
    bodies.push_back(slab);
    World world = world_of(std::move(bodies));
    world.settings.formulas_are_reference = true;
    return world;
}

} // namespace

TEST_CASE("classics: a heavy slab that falls on light legs stops with them",
          "[classics][unsanitized]")
{
    Sweep sweep;
    const Shape cube = Mesh{std::make_shared<SolidMesh>(box_mesh({0.4, 0.4, 0.4}))};
    for (const Leg& leg :
         {Leg{"box", Box{{0.4, 0.4, 0.4}}, 0.4}, Leg{"mesh", cube, 0.4},
          Leg{"cylinder", Cylinder{0.2, 0.4}, 0.4}, Leg{"torus", Torus{0.2, 0.05}, 0.1}})
        for (const int columns : {3, 4})
            for (const int layers : {1, 2})
                for (const double ratio : {10., 1e3, 1e5, 1e6})
                    for (const double h : {1 / 60., 1 / 240.}) {
                        if (layers == 2 && leg.height < 0.4) continue; // tori slide off each other
                        if (!sweep.takes_next()) continue;
                        CAPTURE(leg.name, columns, layers, ratio, h);
                        World world = slab_on_legs(leg, columns, layers, ratio);
                        const double scale = world.bodies.back().mass * g * height;
                        double before = energy_of(world), gain = 0, leaves = 0;
                        for (double t = 0; t < 0.7; t += h) {
                            step(world, h);
                            const double energy = energy_of(world);
                            gain = std::max(gain, (energy - before) / scale);
                            before = energy;
                            for (const RigidBody& body : world.bodies)
                                leaves = std::max(leaves, body.state.velocity.y());
                        }
                        const double ends = world.bodies.back().state.position.y();
                        // If the solver does not converge in a step, single legs keep some speed.
                        check_at_most(leaves, 0.06 * impact_speed, "speed of leaving");
                        // The position correction lifts the slab out of what it has sunk in.
                        check_at_most(gain, 2e-3, "gain of energy");
                        check_at_most(layers * leg.height + 0.15 - ends, 0.015, "sinking [m]");
                    }
}
