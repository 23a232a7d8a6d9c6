// SPDX-License-Identifier: MIT
// A soft solid that flies and tumbles is moved as a whole by gravity alone: its center of mass goes
// along a parabola, and its moment of momentum about it stays, whatever it does within (Newton,
// corollary 4).
#include "classics/problems.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a soft solid flies along a parabola", "[classics]")
{
    Deformable solid = solid_of(block_tetrahedra({1, 0.5, 0.5}, {4, 2, 2}), soft_material());
    solid.integrator = NodeIntegrator::explicit_step;
    const Vector3d V(2, 4, 1), w(1, 3, -2);
    for (std::size_t i = 0; i < solid.positions.size(); ++i)
        solid.velocities[i] = V + w.cross(solid.positions[i]);
    DeformableWorld world = world_of(std::move(solid));
    world.rigid.settings.gravity = {0, -g, 0};
    const DeformableTotals before = totals(world.solids[0]);
    const Vector3d L = before.angular_momentum - before.center_of_mass.cross(before.momentum);
    for (const double h : {0.01, 0.001}) {
        CAPTURE(h);
        DeformableWorld flies = world;
        const double T = 0.5;
        run(flies, h, static_cast<int>(std::lround(T / h)));
        const DeformableTotals after = totals(flies.solids[0]);
        const Vector3d X = before.center_of_mass + V * T - Vector3d(0, g * T * T / 2, 0);
        CHECK_THAT(after.center_of_mass, IsClose(X, Order(g * T * h)));
        CHECK_THAT(Vector3d(after.angular_momentum - after.center_of_mass.cross(after.momentum)),
                   IsClose(L, Rounding(1e5, before.mass * 10)));
    }
}
