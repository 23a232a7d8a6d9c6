// SPDX-License-Identifier: MIT
// Two bodies with a spring between them swing with the reduced mass, √(k (1/M₁ + 1/M₂)), while
// their center of mass goes on evenly (Landau and Lifshitz, "Mechanics", § 13).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: two bodies on a spring swing with the reduced mass", "[classics]")
{
    const double M1 = 12, l = 1, A = 0.2, k = 300, T = 2;
    for (const double M2 : {12., 3., 1200.}) {
        const double w = std::sqrt(k * (1 / M1 + 1 / M2));
        std::vector<double> errors;
        for (const int steps : {50, 100, 200}) {
            World world = solved({free_box(), ball_of_mass(0.1, M2, {l + A, 0, 0})}, {0, 0, 0});
            world.pair_laws = {{0, 1, {}, {}, false}};
            const Vector3d V(0.3, 0.2, -1);
            for (RigidBody& body : world.bodies)
                body.state.velocity = V;
            world.springs = {{0, 1, {0, 0, 0}, {0, 0, 0}, k, 0, l}};
            run(world, steps, T / steps);
            const Vector3d X1 = world.bodies[0].state.position, X2 = world.bodies[1].state.position;
            errors.push_back((X2 - X1 - Vector3d(l + A * std::cos(w * T), 0, 0)).norm());
            const Vector3d start = M2 / (M1 + M2) * Vector3d(l + A, 0, 0);
            CHECK_THAT(Vector3d((M1 * X1 + M2 * X2) / (M1 + M2)),
                       IsClose(Vector3d(start + T * V), Rounding(20. * steps, 4)));
        }
        CAPTURE(M2, errors);
        check_order(errors, 4);
    }
}
