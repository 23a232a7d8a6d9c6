// SPDX-License-Identifier: MIT
// A ring or a gear hangs on a fixed horizontal axle. It swings there as a physical pendulum or
// rests, but it never passes through: its center stays below the axle's by the difference of the
// radii.
#include "classics/problems.hpp"

#include "geometry/meshes/generators.hpp"

#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

struct Ring {
    const char* name;
    Shape shape;
    double radius; // radius of the hole [m]
};

std::vector<Ring> rings()
{
    return {{"ring of 24", mesh_of(ring_mesh(0.3, 0.5, 0.25, 24)), 0.3},
            {"ring of 48", mesh_of(ring_mesh(0.3, 0.5, 0.25, 48)), 0.3},
            {"ring of 96", mesh_of(ring_mesh(0.3, 0.5, 0.1, 96)), 0.3},
            {"thin ring", mesh_of(ring_mesh(0.3, 0.33, 0.1, 48)), 0.3},
            {"gear", mesh_of(gear_mesh(12, 0.5, 0.15, 0.2)), 0.15}};
}

// Axles along y, of this radius in the plane of the ring.
std::vector<std::pair<const char*, Shape>> axles(double radius, double length)
{
    return {{"cylinder", Cylinder{radius, length}},
            {"cone", Cone{4. / 3 * radius, length}},
            {"capsule", Capsule{radius, length}}};
}

} // namespace

TEST_CASE("classics: a ring hangs on an axle", "[classics][unsanitized]")
{
    Sweep sweep;
    const Material material{0, 0.5};
    const Quaternion along_z = turn({1, 0, 0}, std::numbers::pi / 2);
    for (const Ring& ring : rings())
        for (const double share : {0.3, 0.6, 0.9})
            for (const double length : {1., 4., 20.})
                for (const auto& [name, axle] : axles(share * ring.radius, length)) {
                    if (!sweep.takes_next()) continue;
                    CAPTURE(ring.name, name, share, length);
                    const double hangs = -(1 - share) * ring.radius;
                    RigidBody body = body_of(ring.shape, {0, hangs, 0.003}, material, along_z);
                    World world = world_of({fixed(axle, material, {0, 0, 0}, along_z), body});
                    world.settings.formulas_are_reference = true;
                    double lowest = hangs;
                    for (int i = 0; i < 120; ++i) {
                        step(world, 1 / 120.);
                        lowest = std::min(lowest, world.bodies[1].state.position.y());
                    }
                    // Down the slope of a cone of 1 m, a ring slides to where the cone is thinner.
                    const bool slides = std::holds_alternative<Cone>(axle) && length == 1;
                    // [radii of the hole]. The facets have an error of 0.01.
                    const double allowed = slides ? 0.15 : 0.01;
                    check_at_most(hangs - lowest, allowed * ring.radius, "sinking [m]");
                }
}
