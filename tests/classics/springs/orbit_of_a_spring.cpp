// SPDX-License-Identifier: MIT
// A body that a spring without rest length pulls goes along an ellipse about the middle, sweeps
// equal areas in equal times, and takes as long for every ellipse (Newton 1687, "Principia", book
// I, propositions 10 and 1): X = X₀ cos ω t + V₀/ω sin ω t.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a body on a spring goes along an ellipse about the middle", "[classics]")
{
    const double M = 12, w = 3, T = 2 * pi / w * 1.3;
    const Vector3d X0(1, 0.2, 0);
    for (const Vector3d& V0 : {Vector3d(0, 3, 0), Vector3d(0, 0, 0.5), Vector3d(1, -4, 2)}) {
        std::vector<double> errors;
        for (const int steps : {40, 80, 160}) {
            World world = solved({free_box()}, {0, 0, 0});
            RigidState& s = world.bodies[0].state;
            s.position = X0;
            s.velocity = V0;
            world.springs = {{-1, 0, {0, 0, 0}, {0, 0, 0}, M * w * w, 0, 0}};
            run(world, steps, T / steps);
            const Vector3d X = X0 * std::cos(w * T) + V0 / w * std::sin(w * T);
            errors.push_back((s.position - X).norm());
            CHECK_THAT(Vector3d(s.position.cross(s.velocity)),
                       IsClose(Vector3d(X0.cross(V0)), Rounding(20. * steps, 5)));
        }
        CAPTURE(V0, errors);
        check_order(errors, 4);
    }
}
