// SPDX-License-Identifier: MIT
// Bodies that driven bodies squeeze. Where two flanks of a driven gear close in on a tooth, or a
// driven plate presses a body to the floor, no motion obeys the law of contact, since driven bodies
// yield to nothing. What happens then is a matter of choice, but nothing may become much faster
// than the driven body: it does not push faster than it moves, and it is not elastic.
#include "classics/problems.hpp"

#include "formulas/rotation.hpp"
#include "geometry/meshes/generators.hpp"
#include "rigid/bodies/mass.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <map>

namespace bodies_in_jams {

using namespace rigor;
using namespace rigor::testing;

namespace {

// The highest speed of a center of mass, or of a point at the distance `reach` from it [m/s].
double fastest(World& world, int body, double reach, double T, double h)
{
    double speed = 0;
    for (int i = 0; i < static_cast<int>(std::lround(T / h)); ++i) {
        step(world, h);
        const RigidBody& squeezed = world.bodies[body];
        speed = std::max(
            {speed, squeezed.state.velocity.norm(), reach * angular_velocity(squeezed).norm()});
    }
    return speed;
}

constexpr double pitch = 0.02; // radius of a gear by its number of teeth [m]

// Gears are turned about y. The level set of a mesh is costly, so that each gear is made once.
const Shape& gear_of(int teeth)
{
    static std::map<int, Shape> made;
    const auto found = made.find(teeth);
    if (found != made.end()) return found->second;
    return made.emplace(teeth, mesh_of(gear_mesh(teeth, pitch / 2 * teeth, 0, 0.048)))
        .first->second;
}

struct Train {
    int teeth1 = 12, teeth2 = 36;
    double stiffness = 0;    // spring that holds the axle of gear 2 [N/m]
    bool has_bearing = true; // whether gear 2 can turn about its axle only
    double friction = 0;
};

// A driven gear and a gear in mesh with it, whose axle a spring holds, in a frame turned by chance.
World gears(const Train& train, double omega, Random random)
{
    const Quaternion q = random.quaternion();
    const Matrix3d R = rotation_matrix(q);
    const double r1 = pitch / 2 * train.teeth1, r2 = pitch / 2 * train.teeth2;
    const Vector3d X = R * Vector3d(r1 + r2, 0, 0);
    const Material material{0, train.friction};
    // A tooth of gear 1 stands in the middle of a gap of gear 2, give or take the backlash.
    const double phase = pi / train.teeth2 * (1 + random.uniform(-0.06, 0.06));
    RigidBody gear =
        body_of(gear_of(train.teeth2), X, material, multiply(q, turn({0, 1, 0}, phase)));
    if (train.has_bearing) let_turn_about(gear, {0, 1, 0});
    World world = solved(
        {driven(gear_of(train.teeth1), material, {0, 0, 0}, turning(R * Vector3d(0, omega, 0)), q),
         gear},
        {0, 0, 0});
    world.springs.push_back(
        {1, -1, {0, 0, 0}, X, train.stiffness, train.stiffness / 1000, 0, false});
    return world;
}

} // namespace

TEST_CASE("classics: gears in mesh do not outrun the gear that drives them", "[classics]")
{
    Sweep sweep;
    constexpr double most = 8; // times the rim speed of the driven gear
    for (const auto& [teeth1, teeth2] : {std::pair(12, 36), std::pair(8, 24), std::pair(20, 20)})
        for (const double stiffness : {1e6, 1e5})
            for (const double friction : {0.1, 0.})
                for (const bool has_bearing : {true, false})
                    for (const double h : {0.005, 0.0025})
                        for (Random random : seeds(5)) {
                            if (!sweep.takes_next()) continue;
                            CAPTURE(teeth1, teeth2, stiffness, friction, has_bearing, h);
                            const double omega = random.uniform(1, 4);
                            const double rim = omega * pitch / 2 * teeth1;
                            World world = gears({teeth1, teeth2, stiffness, has_bearing, friction},
                                                omega, random);
                            const double speed = fastest(world, 1, pitch / 2 * teeth2, 0.15, h);
                            check_at_most(speed, most * rim, "speed of the gear [m/s]");
                        }
}

TEST_CASE("classics: a mesh that a plate presses to a smooth floor is not shot out", "[classics]")
{
    Sweep sweep;
    // Times the speed of the plate and the speed that corrects penetration. The normals of a mesh
    // have errors up to 2°, so that the plates are a wedge that drives the mesh out.
    constexpr double most = 25;
    constexpr double correction = 0.1; // in a world without gravity [m/s]
    const std::vector<std::pair<const char*, Shape>> shapes = {
        {"cross", mesh_of(cross_mesh(0.2, 0.07))},
        {"ring", mesh_of(ring_mesh(0.05, 0.1, 0.2, 48))},
        {"gear", mesh_of(gear_mesh(12, 0.09, 0, 0.2))}};
    for (const auto& [name, shape] : shapes)
        for (const double speed : {0.2, 0.05})
            for (const double weight : {g, 0.})
                for (const double h : {0.01, 0.0025})
                    for (Random random : seeds(3)) {
                        if (!sweep.takes_next()) continue;
                        CAPTURE(name, speed, weight, h);
                        World world = solved(
                            {fixed(Plane{}, {0, 0}),
                             driven(Box{{1, 0.1, 1}}, {0, 0}, {0, 0.26, 0}, moving({0, -speed, 0})),
                             body_of(shape, {0.01, 0.105, 0.02}, {0, 0},
                                     turn(random.unit_vector(), 0.35))},
                            {0, -weight, 0});
                        check_at_most(fastest(world, 2, 0, 0.08 / speed, h),
                                      most * (speed + (weight == 0 ? correction : 0)),
                                      "speed of the mesh [m/s]");
                    }
}

} // namespace bodies_in_jams
