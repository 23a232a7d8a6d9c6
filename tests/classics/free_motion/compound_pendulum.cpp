// SPDX-License-Identifier: MIT
// A body that a steady force pulls at a point turns about its center of mass as a pendulum (Huygens
// 1673): I θ̈ = -F d sin θ. From the angle θ₀ it takes K(sin θ₀/2)/ω to the middle, with
// ω² = F d/I, and passes there with 2 ω sin θ₀/2. The center of mass itself is accelerated by F/M.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a pendulum takes longer for wide swings", "[classics]")
{
    const double F = 40, d = 0.3, w = std::sqrt(F * d / free_moments.z());
    for (const double degrees : {5., 90., 179.}) {
        const double angle = degrees * pi / 180;
        const double T = std::comp_ellint_1(std::sin(angle / 2)) / w; // a quarter of the period
        std::vector<double> errors;
        for (const int steps : {40, 80, 160}) {
            World world = solved({free_box()}, {0, 0, 0});
            world.bodies[0].state.orientation = turn({0, 0, 1}, angle);
            AppliedForce pull;
            pull.force = {0, -F, 0};
            pull.point = {0, -d, 0};
            world.forces = {pull};
            run(world, steps, T / steps);
            const RigidBody& body = world.bodies[0];
            const double turned =
                2 * std::atan2(body.state.orientation.v.z(), body.state.orientation.s);
            const double rate = angular_velocity(body).z() + 2 * w * std::sin(angle / 2);
            errors.push_back((std::abs(turned) + std::abs(rate)) / angle);
            CHECK_THAT(body.state.position.y(), IsClose(-F / 12 * T * T / 2, Rounding(1e3)));
        }
        CAPTURE(degrees, errors);
        check_order(errors, 4);
        check_at_most(errors.back(), 1e-5, "relative error");
    }
}
