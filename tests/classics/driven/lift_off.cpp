// SPDX-License-Identifier: MIT
// A driven body that moves as A sin(w t) carries what touches it as long as it can: a table lets a
// body go when its downward acceleration reaches g, and a piston lets a block on a floor go when
// its deceleration reaches μ g. Then the body flies or slides on by itself.
#include "classics/problems.hpp"

#include <algorithm>
#include <cmath>

namespace lift_off {

using namespace rigor;
using namespace rigor::testing;

namespace {

// Checks the error of the place at the time T, for several numbers of steps. The body leaves at
// most a step of length h too early or too late. Near this time, its acceleration and that of the
// driven body differ by at most j h, where j = A w³ bounds the change of the acceleration in time.
// So its velocity is wrong by at most j h²/2 when it leaves, and its place by at most t j h²/2 at
// the end.
// @param t  the time from leaving to the end [s]
template <class Error> void check_error(double A, double w, double T, double t, const Error& error)
{
    for (const int steps : {10, 23, 57, 200}) {
        CAPTURE(steps);
        const double h = T / steps;
        check_at_most(error(steps, h), t * A * w * w * w * h * h / 2, "error of the place [m]");
    }
}

} // namespace

TEST_CASE("classics: a shaken table throws what lies on it to the right height", "[classics]")
{
    const double f = 4, w = 2 * pi * f;
    struct Pile {
        Shape shape;
        double height; // from the lowest point of the shape to its center [m]
        int count;
    };
    const std::vector<Pile> piles = {{Box{{0.2, 0.2, 0.2}}, 0.1, 1},
                                     {Box{{0.2, 0.05, 0.3}}, 0.025, 4},
                                     {Sphere{0.1}, 0.1, 1},
                                     {Cylinder{0.1, 0.2}, 0.1, 1}};
    for (const Pile& pile : piles)
        for (const double share : {1.2, 2., 6.})
            for (const double heading : {0., 0.4}) {
                CAPTURE(pile.count, pile.height, share, heading);
                const double A = share * g / (w * w);
                const double leaves = std::asin(1 / share) / w;
                const double v = A * w * std::cos(w * leaves);
                const double T = leaves + std::min(v / g, 0.1); // before it lands
                const double t = T - leaves;
                const double y = A / share + v * t - g * t * t / 2;
                check_error(A, w, T, t, [&](int steps, double h) {
                    std::vector<RigidBody> bodies = {
                        driven(Box{{2, 1, 2}}, {0, 0.5}, {0, -0.5, 0}, shaking({0, A, 0}, f))};
                    for (int i = 0; i < pile.count; ++i) {
                        const double Y = (2 * i + 1) * pile.height;
                        bodies.push_back(
                            body_of(pile.shape, {0, Y, 0}, {0, 0.5}, turn({0, 1, 0}, heading)));
                        bodies.back().state.velocity = {0, A * w, 0};
                    }
                    World world = solved(bodies);
                    run(world, steps, h);
                    double off = 0;
                    for (int i = 0; i < pile.count; ++i) {
                        const double Y = (2 * i + 1) * pile.height + y;
                        off = std::max(
                            off, (world.bodies[i + 1].state.position - Vector3d(0, Y, 0)).norm());
                    }
                    return off;
                });
            }
}

TEST_CASE("classics: a piston pushes blocks away with its speed when they leave it", "[classics]")
{
    const double f = 1, w = 2 * pi * f, A = 0.2;
    for (const double mu : {0., 0.1, 0.5})
        for (const int count : {1, 3})
            for (const ContactMethod method :
                 {ContactMethod::built_in, ContactMethod::simultaneous}) {
                CAPTURE(mu, count, static_cast<int>(method));
                const double leaves = std::asin(mu * g / (A * w * w)) / w;
                const double v = A * w * std::cos(w * leaves);
                const double T = leaves + 0.15, t = T - leaves;
                const double x = A * std::sin(w * leaves) + v * t - mu * g * t * t / 2;
                check_error(A, w, T, t, [&](int steps, double h) {
                    std::vector<RigidBody> bodies = {
                        driven(Box{{1, 1, 1}}, {0, 0}, {-0.5, 0.6, 0}, shaking({A, 0, 0}, f)),
                        fixed(Box{{20, 1, 20}}, {0, mu}, {0, -0.5, 0})};
                    for (int i = 0; i < count; ++i) {
                        bodies.push_back(
                            body_of(Box{{0.2, 0.2, 0.2}}, {0.2 * i + 0.1, 0.1, 0}, {0, mu}));
                        bodies.back().state.velocity = {A * w, 0, 0};
                    }
                    World world = solved(bodies);
                    world.settings.contact_method = method;
                    run(world, steps, h);
                    return std::abs(world.bodies[2].state.position.x() - 0.1 - x);
                });
            }
}

} // namespace lift_off
