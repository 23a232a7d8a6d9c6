// SPDX-License-Identifier: MIT
// A block slides down a wedge that itself slides on the ground, both without friction. The wedge of
// mass M under a block of mass m is pushed away with the acceleration
// g sin α cos α / (M/m + sin² α) (Lamb 1914, "Dynamics"; Goldstein, "Classical mechanics"). All
// forces are constant, so velocities and places are those of even accelerations, up to the
// tolerance of the solver.
#include "classics/problems.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double thickness = 0.2, sole_height = 0.1, slab_height = 2; // [m]

// Ground, wedge and block. The wedge is a slab at the angle over a sole, with its own mass.
World wedge_world(double angle, double ratio, double heading)
{
    const Material smooth{0, 0};
    const Quaternion tilted = turn({0, 0, 1}, -angle), turned = turn({0, 1, 0}, heading);
    const Matrix3d R = rotation_matrix(turned);
    RigidBody wedge;
    wedge.name = "wedge";
    wedge.material = smooth;
    wedge.parts = {Part{Box{{4, thickness, 1}}, {0, slab_height, 0}, tilted},
                   Part{Box{{4, thickness, 1}}, {0, sole_height, 0}, {}}};
    set_mass_from_parts(wedge);
    wedge.state.position = R * (Vector3d(0, sole_height, 0) - wedge.parts[1].position);
    wedge.state.orientation = turned;
    const Vector3d n(std::sin(angle), std::cos(angle), 0), down(n.y(), -n.x(), 0);
    const Eigen::Quaterniond q = eigen(turned) * eigen(tilted);
    RigidBody block = body_of(Box{{0.4, thickness, 0.4}},
                              R * (Vector3d(0, slab_height, 0) + thickness * n - 1.2 * down),
                              smooth, {q.w(), q.vec()});
    set_mass(wedge, ratio * block.mass, wedge.inertia * (ratio * block.mass / wedge.mass));
    World world = world_of({fixed(Plane{}, smooth), wedge, block});
    world.settings.formulas_are_reference = true;
    return world;
}

} // namespace

TEST_CASE("classics: a wedge slides away from under its block evenly", "[classics]")
{
    for (const double degrees : {15., 30., 45.})
        for (const double ratio : {1., 3., 10.})
            for (const double heading : {0., 0.6})
                for (const double h : {1 / 60., 1 / 240.}) {
                    CAPTURE(degrees, ratio, heading, h);
                    const double a = degrees * std::numbers::pi / 180, T = 0.5;
                    World world = wedge_world(a, ratio, heading);
                    const Vector3d start = world.bodies[1].state.position;
                    run(world, static_cast<int>(std::lround(T / h)), h);
                    const double A =
                        g * std::sin(a) * std::cos(a) / (ratio + std::sin(a) * std::sin(a));
                    const Vector3d away =
                        rotation_matrix(turn({0, 1, 0}, heading)) * Vector3d(-1, 0, 0);
                    const RigidState& s = world.bodies[1].state;
                    CHECK_THAT(s.velocity, IsClose(Vector3d(A * T * away), Order(1e-5 * A * T)));
                    CHECK_THAT(Vector3d(s.position - start),
                               IsClose(Vector3d(A * T * T / 2 * away), Order(1e-4 * A * T * T)));
                }
}
