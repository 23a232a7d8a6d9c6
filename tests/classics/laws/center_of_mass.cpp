// SPDX-License-Identifier: MIT
// Whatever bodies do to each other, their center of mass goes on evenly, and the sum of their
// moments of momentum stays (Newton 1687, "Principia", corollary 4 of the laws; Euler).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a swarm that collides goes on as one", "[classics]")
{
    for (const double restitution : {0., 0.5, 1.}) {
        CAPTURE(restitution);
        Random random(5);
        std::vector<RigidBody> bodies;
        for (int i = 0; i < 12; ++i) {
            const Vector3d X(0.8 * (i % 3), 0.8 * (i / 3 % 2), 0.8 * (i / 6));
            bodies.push_back(body_of(i % 2 == 0 ? Shape(Sphere{0.3}) : Shape(Box{{0.5, 0.4, 0.5}}),
                                     X, {restitution, 0.5}, random.quaternion()));
            bodies.back().state.velocity = Vector3d(1, 0.5, 0) + 2 * random.vector();
            spin(bodies.back(), 2 * random.vector());
        }
        World world = solved(bodies, {0, 0, 0});
        const Totals before = totals(world);
        double mass = 0;
        Vector3d center = Vector3d::Zero();
        for (const RigidBody& body : bodies) {
            mass += body.mass;
            center += body.mass * body.state.position;
        }
        bool has_touched = false;
        for (int n = 0; n < 100; ++n)
            has_touched |= !step(world, 0.01).empty();
        CHECK(has_touched);
        const Totals after = totals(world);
        Vector3d center_after = Vector3d::Zero();
        for (const RigidBody& body : world.bodies)
            center_after += body.mass * body.state.position;
        CHECK_THAT(after.momentum, IsClose(before.momentum, Rounding(1e4, mass * 3)));
        CHECK_THAT(Vector3d(center_after / mass),
                   IsClose(Vector3d((center + before.momentum) / mass), Rounding(1e4, 3)));
        CHECK_THAT(after.angular_momentum,
                   IsClose(before.angular_momentum, Rounding(1e4, mass * 10)));
        check_at_most(after.kinetic_energy, before.kinetic_energy, "energy", mass);
    }
}
