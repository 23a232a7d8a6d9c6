// SPDX-License-Identifier: MIT
// Where balance ends: a little below the critical value everything stands still, a little above it
// falls. The critical values are those of statics, and none depends on the step.
#include "classics/problems.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::testing;

// Bricks of length L lean out by L/2, L/4, L/6 … from the top down (Phear 1850, "Elementary
// mechanics"; Hall 2005, "Overhang", American Scientist 93).
TEST_CASE("classics: bricks lean out by the harmonic series and no farther", "[classics]")
{
    const double L = 1, H = 0.2;
    for (const int n : {1, 2, 3, 4, 6})
        for (const double share : {0.98, 1.02})
            for (const double h : {1 / 60., 1 / 240.}) {
                CAPTURE(n, share, h);
                std::vector<RigidBody> bodies = {fixed(Box{{2, 1, 1}}, {0, 0.5}, {-1, -0.5, 0})};
                double edge = 0;
                for (int i = 0; i < n; ++i) {
                    edge += share * L / (2 * (n - i));
                    bodies.push_back(
                        body_of(Box{{L, H, 0.5}}, {edge - L / 2, H * (i + 0.5), 0}, {0, 0.8}));
                }
                World world = solved(bodies);
                run(world, static_cast<int>(2 / h), h);
                const double falls = H * (n - 0.5) - world.bodies.back().state.position.y();
                if (share < 1)
                    check_at_most(std::abs(falls), 1e-9, "movement [m]");
                else
                    check_at_least(falls, 0.1, "fall [m]");
            }
}

// A block on a rough incline tips over its lower edge where tan α exceeds width over height.
TEST_CASE("classics: a block tips where its weight leaves its base", "[classics]")
{
    const double H = 0.5;
    for (const double shape : {0.3, 0.8, 1.5})
        for (const double share : {0.99, 1.01})
            for (const double heading : {0., 0.5})
                for (const double h : {1 / 60., 1 / 240.}) {
                    CAPTURE(shape, share, heading, h);
                    const double angle = std::atan(shape * share);
                    const Quaternion q = turn({0, 1, 0}, heading);
                    const Vector3d gravity =
                        rotation_matrix(q) * Vector3d(g * std::sin(angle), -g * std::cos(angle), 0);
                    const Vector3d X(0, H / 2, 0);
                    World world = solved({fixed(Plane{}, {0, 5}),
                                          body_of(Box{{shape * H, H, shape * H}}, X, {0, 5}, q)},
                                         gravity);
                    run(world, static_cast<int>(3 / h), h);
                    const double moves = (world.bodies[1].state.position - X).norm();
                    if (share < 1)
                        check_at_most(moves, 1e-9, "movement [m]");
                    else
                        check_at_least(moves, 0.1, "movement [m]");
                }
}

// Three equal logs: the upper one on the two lower ones, which touch but do not push each other.
// They stay if μ between logs is at least tan 15°, and μ on the ground at least a third of that.
TEST_CASE("classics: a log on two logs needs friction above and below", "[classics]")
{
    const double critical = std::tan(std::numbers::pi / 12);
    const Quaternion lying = turn({1, 0, 0}, std::numbers::pi / 2);
    for (const double R : {0.03, 0.3})
        for (const double above : {0.95, 1.05, 2.})
            for (const double below : {0.95, 1.05, 2.})
                for (const double h : {1 / 60., 1 / 240.}) {
                    CAPTURE(R, above, below, h);
                    const Vector3d top(0, R * (1 + std::sqrt(3.)), 0);
                    const Shape log = Cylinder{R, 1};
                    World world = solved(
                        {fixed(Plane{}, {0, 1}), body_of(log, {-R, R, 0}, {0, 1}, lying),
                         body_of(log, {R, R, 0}, {0, 1}, lying), body_of(log, top, {0, 1}, lying)});
                    world.pair_laws = {{0, 1, {}, below * critical / 3, true},
                                       {0, 2, {}, below * critical / 3, true},
                                       {1, 3, {}, above * critical, true},
                                       {2, 3, {}, above * critical, true}};
                    run(world, static_cast<int>(1.5 / h), h);
                    const double falls = top.y() - world.bodies[3].state.position.y();
                    if (std::min(above, below) > 1)
                        check_at_most(std::abs(falls), 1e-9, "movement [m]");
                    else
                        check_at_least(falls, 0.5 * R, "fall [m]");
                }
}

// A slab of height 2b on a rough round log of radius R rocks about the top if b < R, and rolls off
// if b > R (Routh 1905, "Dynamics of a system of rigid bodies", on rocking stones).
TEST_CASE("classics: a slab rocks on a log that is thicker than itself", "[classics]")
{
    const double R = 0.5;
    const Material rough{0, 50};
    const Quaternion lying = turn({1, 0, 0}, std::numbers::pi / 2);
    for (const double share : {0.5, 0.9, 1.1, 1.3})
        for (const bool is_ball : {false, true})
            for (const double h : {1 / 60., 1 / 240.}) {
                CAPTURE(share, is_ball, h);
                const double b = share * R;
                RigidBody slab = body_of(Box{{2, 2 * b, 0.5}}, {0, R + b, 0}, rough);
                spin(slab, {0, 0, 0.1});
                World world = solved({is_ball ? fixed(Sphere{R}, rough)
                                              : fixed(Cylinder{R, 2}, rough, {0, 0, 0}, lying),
                                      slab});
                double tilt = 0;
                for (double t = 0; t < 5 && tilt < 0.5; t += h) {
                    step(world, h);
                    const Matrix3d Q = rotation_matrix(world.bodies[1].state.orientation);
                    tilt = std::max(tilt, std::acos(std::min(1.0, Q(1, 1))));
                }
                if (share < 1)
                    check_at_most(tilt, 0.15, "tilt [rad]");
                else
                    check_at_least(tilt, 0.5, "tilt [rad]");
            }
}
