// SPDX-License-Identifier: MIT
// An elastic block on a slope that is less steep than the friction angle, tan α < μ, settles and
// then rests (Coulomb 1785). At first, the front of the block bears more than the back, so some of
// its nodes slip until friction holds all of them.
#include "classics/problems.hpp"
#include "support/deformables.hpp"

namespace block_held_on_a_slope {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double mu = 0.3;

DeformableWorld world_on_slope(double share_of_limit, double youngs_modulus,
                               NodeIntegrator integrator)
{
    SolidMaterial material;
    material.density = 1000;
    material.youngs_modulus = youngs_modulus;
    material.poisson_ratio = 0;
    material.damping = 0.02;
    material.surface = {0, mu};
    Deformable block = make_deformable("block", block_tetrahedra({1, 0.2, 0.2}, {10, 2, 2}),
                                       material, Matrix3d::Identity(), Vector3d(0, 0.1, 0));
    block.integrator = integrator;
    DeformableWorld world = world_of(std::move(block));
    world.rigid.settings.gravity = gravity_on_slope(std::atan(share_of_limit * mu));
    world.rigid.bodies = {fixed(Plane{}, {0, mu})};
    return world;
}

double fastest(const Deformable& solid)
{
    double speed = 0;
    for (const Vector3d& v : solid.velocities)
        speed = std::max(speed, v.norm());
    return speed;
}

} // namespace

TEST_CASE("classics: an elastic block comes to rest on a slope that friction can hold",
          "[classics][.long][unsanitized]")
{
    Sweep sweep;
    for (const NodeIntegrator integrator :
         {NodeIntegrator::implicit_step, NodeIntegrator::explicit_step})
        for (const double share : {0.5, 0.9, 0.96, 0.99})
            for (const auto& [E, h] :
                 {std::pair{1e5, 0.01}, {1e6, 0.01}, {1e6, 0.0025}, {1e7, 0.01}}) {
                const bool is_implicit = integrator == NodeIntegrator::implicit_step;
                if (!is_implicit && (E > 1e6 || h < 0.01)) continue; // many substeps
                if (!sweep.takes_next()) continue;
                CAPTURE(is_implicit, share, E, h);
                DeformableWorld world = world_on_slope(share, E, integrator);
                run(world, h, static_cast<int>(std::lround(2 / h)));
                check_at_most(fastest(world.solids[0]), 1e-4, "speed after two seconds [m/s]");
            }
}

} // namespace block_held_on_a_slope
