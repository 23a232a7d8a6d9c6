// SPDX-License-Identifier: MIT
// A table with three to eight legs bears a load at its edge, beyond its feet. It stands as long as
// the resultant of weight and load meets the floor between the feet. The load may be many times the
// weight, so the forces of the step are far larger than those of gravity.
#include "classics/problems.hpp"

namespace loaded_tables {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double feet = 0.5, edge = 0.6, height = 0.5; // circles of the feet and of the load [m]

// @param share   of the load for which the resultant lies above the line between two feet
// @param weight  M g, without the load [N]
World loaded(int legs, double share, double weight, double friction)
{
    const Material material{0, friction};
    RigidBody table;
    table.name = "table";
    table.material = material;
    const double top = 0.05, leg = 0.05;
    table.parts.push_back({Cylinder{edge, top}, {0, height + top / 2, 0}, {}, 1000});
    for (int i = 0; i < legs; ++i) {
        const double at = 2 * pi * i / legs;
        table.parts.push_back({Box{{leg, height, leg}},
                               {feet * std::cos(at), height / 2, feet * std::sin(at)},
                               {},
                               1000});
    }
    const Vector3d center = set_mass_from_parts(table);
    const double mass = weight / g;
    set_mass(table, mass, mass * table.inertia / table.mass);
    table.state.position = center;

    // M g d = F (edge - d) with the distance d of the line between the centers of two feet
    const double middle = pi / legs, d = feet * std::cos(middle);
    AppliedForce load;
    load.force = {0, -share * weight * d / (edge - d), 0};
    load.point = Vector3d(edge * std::cos(middle), height, edge * std::sin(middle)) - center;
    World world = solved({table, fixed(Plane{}, material)});
    world.forces = {load};
    return world;
}

} // namespace

TEST_CASE("classics: a table bears a load beyond its feet", "[classics]")
{
    for (const int legs : {3, 4, 5, 6, 8})
        for (const double share : {0.3, 0.6, 0.9, 0.99})
            for (const double friction : {0.0, 0.5})
                for (const double h : {0.02, 0.005, 0.001}) {
                    World world = loaded(legs, share, 200, friction);
                    const RigidState before = world.bodies[0].state;
                    run_until(world, 0.2, h);
                    const RigidState& after = world.bodies[0].state;
                    CAPTURE(legs, share, friction, h);
                    check_at_most((after.position - before.position).norm(), 1e-5, "motion [m]");
                    check_at_most((after.orientation.v - before.orientation.v).norm(), 1e-5,
                                  "half of the angle of its turn [rad]");
                }
}

} // namespace loaded_tables
