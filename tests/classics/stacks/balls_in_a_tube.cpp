// SPDX-License-Identifier: MIT
// Two equal balls in a tube less than two diameters wide: the walls bear W cot θ each, the bottom
// both weights and the contact of the balls W/sin θ, θ the slope of the line of their centers
// (Lamb 1912, "Statics").
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: two balls in a tube push its walls by their slope", "[classics]")
{
    const double R = 0.1, h = 0.01;
    const Material smooth{0, 0};
    for (const double degrees : {20., 45., 80.}) {
        CAPTURE(degrees);
        const double a = degrees * pi / 180, half = R * std::cos(a);
        World world = solved({fixed(Plane{}, smooth),
                              fixed(Box{{1, 2, 2}}, smooth, {-half - R - 0.5, 0.5, 0}),
                              fixed(Box{{1, 2, 2}}, smooth, {half + R + 0.5, 0.5, 0}),
                              body_of(Sphere{R}, {-half, R, 0}, smooth),
                              body_of(Sphere{R}, {half, R + 2 * R * std::sin(a), 0}, smooth)});
        world.settings.optimisations.sleep = false;
        const double W = world.bodies[3].mass * g;
        run(world, 50, h);
        double bottom = 0, left = 0, right = 0, between = 0;
        for (const ContactRecord& contact : step(world, h)) {
            const double force = contact.impulse.norm() / h;
            const int other = std::min(contact.body1, contact.body2);
            (other == 0 ? bottom : other == 1 ? left : other == 2 ? right : between) += force;
        }
        CHECK_THAT(bottom, IsClose(2 * W, Order(1e-5 * W)));
        CHECK_THAT(left, IsClose(W / std::tan(a), Order(1e-5 * W)));
        CHECK_THAT(right, IsClose(W / std::tan(a), Order(1e-5 * W)));
        CHECK_THAT(between, IsClose(W / std::sin(a), Order(1e-5 * W)));
    }
}
