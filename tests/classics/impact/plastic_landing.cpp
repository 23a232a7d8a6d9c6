// SPDX-License-Identifier: MIT
// A body that does not bounce, or hardly, stays where it lands, from the moment when it touches.
#include "classics/problems.hpp"

#include <cmath>

namespace plastic_landing {

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: clay stays on the ground from the moment when it lands", "[classics]")
{
    struct Piece {
        Shape shape;
        double height; // from its lowest point to its center [m]
    };
    const std::vector<Piece> pieces = {{Sphere{0.1}, 0.1},
                                       {Box{{0.2, 0.2, 0.3}}, 0.1},
                                       {Capsule{0.1, 0.3}, 0.25},
                                       {Cylinder{0.1, 0.2}, 0.1}};
    for (const Piece& piece : pieces)
        for (const double restitution : {0., 1e-3})
            for (const double H : {0.05, 0.5, 10.})
                for (const double u : {0., 3.})
                    for (const double h : {1 / 60., 0.01, 1 / 480.}) {
                        CAPTURE(piece.height, restitution, H, u, h);
                        const Material material{restitution, 0};
                        RigidBody body = body_of(piece.shape, {0, piece.height + H, 0}, material);
                        body.state.velocity = {u, 0, 0};
                        World world =
                            solved({fixed(Box{{100, 1, 100}}, material, {0, -0.5, 0}), body});
                        const double lands = std::sqrt(2 * H / g);
                        const double bounce = std::pow(restitution * g * lands, 2) / (2 * g);
                        double off = 0;
                        for (int n = 1; n * h < lands + 0.3; ++n) {
                            step(world, h);
                            const double t = n * h;
                            const double y = t < lands ? H - g * t * t / 2 : 0;
                            const Vector3d exact(u * t, piece.height + y, 0);
                            off = std::max(off, (world.bodies[1].state.position - exact).norm());
                        }
                        check_at_most(off, 1e-6 + bounce, "error of the place [m]");
                    }
}

// The plate has the height y(t) and is shaken so hard that its acceleration reaches `share` g.
TEST_CASE("classics: no bounce on a shaken plate is lost at any phase", "[classics]")
{
    const double r = 0.05, f = 4, w = 2 * pi * f;
    for (const double share : {0.7, 2., 6.})
        for (int k = 0; k < 40; ++k)
            for (const double h : {1 / 60., 1 / 200.}) {
                const double A = share * g / (w * w), phase = 2 * pi * k / 40;
                const Material material{0.9, 0};
                const auto plate = [&](double t) {
                    return A * (std::sin(w * t + phase) - std::sin(phase));
                };
                World world = solved(
                    {driven(Box{{2, 1, 2}}, material, {0, -0.5, 0}, shaking({0, A, 0}, f, phase)),
                     body_of(Sphere{r}, {0, r + 3 * A, 0}, material)});
                double deepest = 0;
                for (int n = 1; n * h < 0.6; ++n) {
                    step(world, h);
                    const double gap = world.bodies[1].state.position.y() - r - plate(n * h);
                    deepest = std::max(deepest, -gap);
                }
                CAPTURE(share, phase, h);
                check_at_most(deepest, 1e-6, "overlap [m]");
            }
}

} // namespace plastic_landing
