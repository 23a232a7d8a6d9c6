// SPDX-License-Identifier: MIT
// The pole of a free oblate planet goes round its axis of inertia, seen from the planet, once in
// A/(C - A) days: 305 for the Earth (Euler 1765, "Theoria motus corporum solidorum"; the real
// Earth yields a little, and Chandler found 430 days).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: the pole of a planet goes round in 305 days", "[classics]")
{
    const double A = 1, C = A * (1 + 1 / 305.), day = 2 * pi, off = 1e-6; // with ω₃ = 1
    RigidBody planet = free_box();
    set_mass(planet, 1, Vector3d(A, C, A).asDiagonal().toDenseMatrix());
    spin(planet, {off, 1, 0});
    for (const double days : {305 / 4., 305., 3050.}) {
        CAPTURE(days);
        World world = solved({planet}, {0, 0, 0});
        run_until(world, days * day, day / 8);
        const Vector3d w = rotation_matrix(world.bodies[0].state.orientation).transpose() *
                           angular_velocity(world.bodies[0]);
        const double angle = 2 * pi * days / 305;
        CHECK_THAT(Vector3d((w - Vector3d(0, w.y(), 0)) / off),
                   IsClose(Vector3d(std::cos(angle), 0, -std::sin(angle)),
                           Rounding(100 * 8 * days, 1 / off)));
    }
}
