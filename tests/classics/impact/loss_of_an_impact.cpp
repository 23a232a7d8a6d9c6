// SPDX-License-Identifier: MIT
// What an impact loses is the energy of the approach in the frame of the center of mass:
// ½ M₁ M₂/(M₁ + M₂) (1 - ε²) v² (Carnot 1803; König). The loss is the same in every frame.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: an impact loses energy of the approach alone", "[classics]")
{
    const double v = 2;
    for (const double ratio : {1., 7., 1e5})
        for (const double e : {0., 0.3, 0.8, 1.})
            for (const Vector3d& V : {Vector3d(0, 0, 0), Vector3d(3, -2, 5)}) {
                CAPTURE(ratio, e, V);
                const Material material{e, 0.5};
                World world = solved({ball_of_mass(0.1, ratio, {0, 0, 0}, material),
                                      ball_of_mass(0.1, 1, {0.5, 0, 0}, material)},
                                     {0, 0, 0});
                world.bodies[0].state.velocity = V + Vector3d(v, 0, 0);
                world.bodies[1].state.velocity = V;
                const double before = totals(world).kinetic_energy;
                run(world, 40, 0.01);
                const double loss = ratio / (ratio + 1) / 2 * (1 - e * e) * v * v;
                CHECK_THAT(before - totals(world).kinetic_energy,
                           IsClose(loss, Rounding(1e3, before)));
            }
}
