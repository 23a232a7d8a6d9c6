// SPDX-License-Identifier: MIT
// A block on a slope a little steeper than its angle of friction slides with the acceleration
// g (sin α - μ cos α), whatever its size and however weak gravity is. A short way, compared with
// its size, does not mean that it is at rest.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace slow_slide {

TEST_CASE("classics: a block of any size slides on a slope that is hardly too steep", "[classics]")
{
    const double angle = std::atan(0.3);
    for (const double size : {0.01, 0.1, 1., 10., 100., 1000.})
        for (const double gravity : {g, 0.1 * g})
            for (const double excess : {0.03, 0.003}) // (tan α - μ)/tan α
                for (const double h : {0.02, 0.01}) {
                    CAPTURE(size, gravity, excess, h);
                    const Material rough{0, 0.3 * (1 - excess)};
                    World world = solved({fixed(Plane{}, rough), body_of(Box{{size, size, size}},
                                                                         {0, size / 2, 0}, rough)},
                                         gravity / g * gravity_on_slope(angle));
                    const double T = 10, a = gravity * excess * std::sin(angle);
                    run_until(world, T, h);
                    CHECK_THAT(world.bodies[1].state.position.x(),
                               IsClose(a * T * T / 2, Order(1e-3)));
                }
}

TEST_CASE("classics: a block of any size stays on a slope that is not steep enough", "[classics]")
{
    const double angle = std::atan(0.3);
    for (const double size : {0.01, 0.1, 1., 10., 100., 1000.})
        for (const double h : {0.02, 0.01}) {
            CAPTURE(size, h);
            const Material rough{0, 0.31};
            World world = solved(
                {fixed(Plane{}, rough), body_of(Box{{size, size, size}}, {0, size / 2, 0}, rough)},
                gravity_on_slope(angle));
            run_until(world, 5, h);
            check_at_most(std::abs(world.bodies[1].state.position.x()), 1e-6 * size, "way [m]");
            CHECK(world.bodies[1].rest.is_asleep());
        }
}

} // namespace slow_slide
