// SPDX-License-Identifier: MIT
// Two equal balls collide on a table. Without friction each keeps its velocity perpendicular to the
// line of centers, and along that line they exchange the velocities, as in free space (Coriolis
// 1835, "Théorie mathématique des effets du jeu de billard"). The line of centers is that of the
// moment of impact, wherever in a step it lies.
#include "framework/rigid/worlds.hpp"

#include "support/catch.hpp"

#include <cmath>

namespace billiards {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double radius = 0.03, speed = 2; // [m], [m/s]

// The velocity of the struck ball by the law.
Vector3d struck(double offset, double restitution)
{
    const double s = offset / (2 * radius); // sine of the cut
    const Vector3d n(std::sqrt(1 - s * s), 0, s);
    return (1 + restitution) / 2 * speed * n.x() * n;
}

// The largest error of a ball's velocity after the collision [m/s].
double error(double offset, double restitution, double start, double h, bool has_table)
{
    const Material smooth{restitution, 0};
    RigidBody cue = body_of(Sphere{radius}, {-start, radius, 0}, smooth);
    RigidBody target = body_of(Sphere{radius}, {0, radius, offset}, smooth);
    cue.state.velocity = {speed, 0, 0};
    World world = has_table ? world_of({fixed(Plane{}, smooth), cue, target})
                            : world_of({cue, target}, {0, 0, 0});
    world.settings.formulas_are_reference = true;
    run(world, static_cast<int>(std::lround(0.3 / h)), h);
    const std::size_t first = has_table ? 1 : 0;
    const Vector3d v = struck(offset, restitution);
    return std::max((world.bodies[first + 1].state.velocity - v).norm(),
                    (world.bodies[first].state.velocity - (Vector3d(speed, 0, 0) - v)).norm());
}

} // namespace

TEST_CASE("classics: billiard balls part as in free space", "[classics]")
{
    for (const double restitution : {1., 0.9, 0.5})
        for (const double cut : {-0.9, -0.5, 0., 0.3, 0.7, 0.95})
            for (const double start : {0.2, 0.213, 0.2271})
                for (const double h : {0.02, 0.01, 1 / 240.})
                    for (const bool has_table : {false, true}) {
                        CAPTURE(restitution, cut, start, h, has_table);
                        CHECK_THAT(error(2 * radius * cut, restitution, start, h, has_table),
                                   IsClose(0.0, Order(1e-6 * speed)));
                    }
}

} // namespace billiards
