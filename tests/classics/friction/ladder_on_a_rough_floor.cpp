// SPDX-License-Identifier: MIT
// A ladder against a smooth wall on a rough floor stands if tan θ ≥ 1/(2 μ), θ its angle with the
// floor (Lamb 1912, "Statics").
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a ladder stands if the floor is rough enough", "[classics]")
{
    const double L = 2, foot = 0.001;
    for (const double degrees : {40., 55., 70.})
        for (const double share : {0.98, 1.02})
            for (const double h : {1 / 60., 1 / 240.}) {
                CAPTURE(degrees, share, h);
                const double a = degrees * pi / 180, mu = share / (2 * std::tan(a));
                const Vector3d X(foot + L / 2 * std::cos(a), foot + L / 2 * std::sin(a), 0);
                World world =
                    solved({fixed(Plane{}, {0, mu}),
                            fixed(Plane{}, {0, mu}, {0, 0, 0}, turn({0, 0, 1}, -pi / 2)),
                            body_of(Capsule{foot, L}, X, {0, mu}, turn({0, 0, 1}, pi / 2 - a))});
                world.bodies[2].state.orientation = turn({0, 0, 1}, pi / 2 - a);
                world.pair_laws = {{0, 2, {}, mu, true}, {1, 2, {}, 0., true}};
                // The rod leans against the wall x = 0: its upper end is on the left.
                world.bodies[2].state.orientation = turn({0, 0, 1}, pi / 2 - a);
                run(world, static_cast<int>(2 / h), h);
                const double moves = (world.bodies[2].state.position - X).norm();
                if (share > 1)
                    check_at_most(moves, 1e-3, "movement [m]");
                else
                    check_at_least(moves, 0.05, "movement [m]");
            }
}
