// SPDX-License-Identifier: MIT
// The motion of any free body (Poinsot 1834, "Théorie nouvelle de la rotation des corps"): the
// angular momentum and the energy stay, so ω touches a fixed plane, ω · L = 2 E, and in the body it
// goes along the curve where two ellipsoids meet.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: the angular velocity of a free body stays in a plane", "[classics]")
{
    for (unsigned seed = 0; seed < 10; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        RigidBody body = free_box();
        set_mass(body, 12, random.inertia());
        spin(body, 3 * random.vector());
        const Vector3d L = body.state.angular_momentum;
        const double E2 = L.dot(angular_velocity(body));
        std::vector<double> errors;
        for (const int steps : {200, 400, 800}) {
            World world = solved({body}, {0, 0, 0});
            double off = 0;
            for (int n = 0; n < steps; ++n) {
                step(world, 4. / steps);
                REQUIRE_THAT(world.bodies[0].state.angular_momentum,
                             IsClose(L, Rounding(0, 1))); // equal in every bit
                off = std::max(off, std::abs(L.dot(angular_velocity(world.bodies[0])) / E2 - 1));
            }
            errors.push_back(off);
        }
        CAPTURE(errors);
        check_at_most(errors.back(), 1e-6, "relative error of the energy");
        if (errors[1] > 1e-12) check_at_most(errors[1], errors[0] / 12, "error by half the step");
    }
}
