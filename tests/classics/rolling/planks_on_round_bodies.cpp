// SPDX-License-Identifier: MIT
// A plank rocks on a log without slip ("rolling board"; Routh, "Dynamics of a system of rigid
// bodies", part 1). Its contact moves faster than any point of the plank, and no friction does
// work, so the energy stays.
#include "classics/problems.hpp"
#include "formulas/rotation.hpp"

namespace planks_on_round_bodies {

using namespace rigor;
using namespace rigor::testing;

namespace {

struct Rocker {
    Shape shape;
    double half;      // half its thickness [m]
    Quaternion lying; // turns its length to x
};

// The energy above that of rest on top [J], which is all of it for the motion in a plane.
double energy_of(const RigidBody& body, double rest)
{
    const Vector3d w = angular_velocity(body);
    return body.mass * body.state.velocity.squaredNorm() / 2 +
           w.dot(body.state.angular_momentum) / 2 +
           body.mass * g * (body.state.position.y() - rest);
}

} // namespace

TEST_CASE("classics: a plank rocks on any round body without loss", "[classics]")
{
    const Quaternion on_its_side = turn({1, 0, 0}, pi / 2), along_x = turn({0, 0, 1}, pi / 2);
    const Material rough{0, 2};
    const std::vector<Rocker> rockers = {{Box{{1.2, 0.06, 0.4}}, 0.03, {}},
                                         {Box{{1.2, 0.2, 0.05}}, 0.1, {}},
                                         {Box{{1.2, 0.1, 2}}, 0.05, {}},
                                         {Capsule{0.03, 1.2}, 0.03, along_x},
                                         {Cylinder{0.03, 1.2}, 0.03, along_x}};
    Sweep sweep;
    for (const double R : {0.5, 1.})
        for (const auto& [ground, q] : {std::pair<Shape, Quaternion>(Sphere{R}, Quaternion()),
                                        {Cylinder{R, 1}, on_its_side},
                                        {Capsule{R, 1}, on_its_side},
                                        {Ellipsoid{{R, R, 1.5 * R}}, Quaternion()},
                                        {Torus{0.7 * R, 0.3 * R}, on_its_side}})
            for (const Rocker& rocker : rockers)
                for (const double h : {0.01, 0.005}) {
                    if (!sweep.takes_next()) continue;
                    // rolled to one side by the angle a from its place on top
                    const double a = 0.1;
                    const Vector3d n(std::sin(a), std::cos(a), 0), t(n.y(), -n.x(), 0);
                    const Vector3d X = (R + rocker.half) * n - R * a * t;
                    const Quaternion turned = multiply(turn({0, 0, 1}, -a), rocker.lying);
                    World world = solved({fixed(ground, rough, {0, 0, 0}, q),
                                          body_of(rocker.shape, X, rough, turned)});
                    const double rest = R + rocker.half;
                    const double first = energy_of(world.bodies[1], rest);
                    double most = 0;
                    for (double time = 0; time < 4; time += h) {
                        step(world, h);
                        most = std::max(most, energy_of(world.bodies[1], rest));
                    }
                    CAPTURE(R, rocker.half, h);
                    check_at_most(most / first, 1.002, "energy, as a share of the first");
                    check_at_least(energy_of(world.bodies[1], rest) / first, 0.98,
                                   "energy that is left");
                }
}

} // namespace planks_on_round_bodies
