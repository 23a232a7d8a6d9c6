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
    const Vector3d V(2, 4, 1), w(1, 3, -2);
    const double T = 0.5;
    for (const NodeIntegrator integrator :
         {NodeIntegrator::explicit_step, NodeIntegrator::implicit_step})
        for (const double damping : {0.0, 0.005})
            for (const double h : {0.02, 0.01, 0.001}) {
                CAPTURE(static_cast<int>(integrator), damping, h);
                SolidMaterial material = soft_material();
                material.damping = damping;
                Deformable solid = solid_of(block_tetrahedra({1, 0.5, 0.5}, {4, 2, 2}), material);
                solid.integrator = integrator;
                for (std::size_t i = 0; i < solid.positions.size(); ++i)
                    solid.velocities[i] = V + w.cross(solid.positions[i]);
                const DeformableTotals before = totals(solid);
                DeformableWorld flies = world_of(std::move(solid));
                flies.rigid.settings.gravity = {0, -g, 0};
                run(flies, h, static_cast<int>(std::lround(T / h)));
                const DeformableTotals after = totals(flies.solids[0]);
                const Vector3d X = before.center_of_mass + V * T - Vector3d(0, g * T * T / 2, 0);
                CHECK_THAT(after.center_of_mass, IsClose(X, Rounding(1e5, 10)));
                const auto about_center = [](const DeformableTotals& of) -> Vector3d {
                    return of.angular_momentum - of.center_of_mass.cross(of.momentum);
                };
                CHECK_THAT(about_center(after),
                           IsClose(about_center(before), Rounding(1e5, before.mass * 10)));
            }
}
