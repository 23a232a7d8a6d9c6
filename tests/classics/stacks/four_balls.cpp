// SPDX-License-Identifier: MIT
// Three balls that touch on a table carry a fourth one if friction between balls is at least
// √3 - √2, and on the table a quarter of that: each lower contact sees the line of centers under
// the half angle (a classical problem of statics; Lamb 1912).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a ball on three balls needs friction above and below", "[classics]")
{
    const double R = 0.1, critical = std::sqrt(3.) - std::sqrt(2.);
    for (const double above : {0.95, 1.05, 2.})
        for (const double below : {0.95, 1.05, 2.})
            for (const double h : {1 / 60., 1 / 240.}) {
                CAPTURE(above, below, h);
                std::vector<RigidBody> bodies = {fixed(Plane{}, {0, 1})};
                for (int i = 0; i < 3; ++i) {
                    const double angle = 2 * pi * i / 3, r = 2 * R / std::sqrt(3.);
                    bodies.push_back(
                        body_of(Sphere{R}, {r * std::cos(angle), R, r * std::sin(angle)}, {0, 1}));
                }
                const double top = R + 2 * R * std::sqrt(2. / 3);
                bodies.push_back(body_of(Sphere{R}, {0, top, 0}, {0, 1}));
                World world = solved(bodies);
                for (int i = 1; i <= 3; ++i)
                    world.pair_laws.push_back({0, i, {}, below * critical / 4, true});
                for (int i = 1; i <= 3; ++i)
                    world.pair_laws.push_back({i, 4, {}, above * critical, true});
                run(world, static_cast<int>(1.5 / h), h);
                const double falls = top - world.bodies[4].state.position.y();
                if (std::min(above, below) > 1)
                    check_at_most(std::abs(falls), 1e-6, "movement [m]");
                else
                    check_at_least(falls, 0.3 * R, "fall [m]");
            }
}
