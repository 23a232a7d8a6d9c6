// SPDX-License-Identifier: MIT
// Without friction and loss a motion runs backwards by the same laws: if all velocities are turned
// round, it comes back to where it began. The method for bodies on springs is symmetric in time, so
// the motion comes back up to rounding.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a motion runs back if its velocities are turned round", "[classics]")
{
    for (unsigned seed = 0; seed < 6; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        std::vector<RigidBody> bodies;
        for (int i = 0; i < 5; ++i) {
            bodies.push_back(ball_of_mass(0.1, 2 + i, 2 * random.vector()));
            bodies.back().state.velocity = random.vector();
        }
        World world = solved(bodies);
        for (int i = 0; i < 5; ++i)
            for (int j = 0; j < i; ++j) {
                world.springs.push_back({i, j, {0, 0.1, 0}, {0.1, 0, 0}, 50, 0, 0.5});
                world.pair_laws.push_back({j, i, {}, {}, false});
            }
        sort_by_pair(world.pair_laws);
        run(world, 100, 0.01);
        check_at_least(largest_distance(world, solved(bodies)), 0.5, "way [m]");
        for (RigidBody& body : world.bodies) {
            body.state.velocity *= -1;
            body.state.angular_momentum *= -1;
        }
        run(world, 100, 0.01);
        check_at_most(largest_distance(world, solved(bodies)), 1e-9, "distance [m]");
    }
}
