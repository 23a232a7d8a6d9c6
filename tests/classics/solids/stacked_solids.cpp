// SPDX-License-Identifier: MIT
// Two soft blocks with a plate between them and a plate on top: each block is compressed by the
// weight that it bears, whatever order the blocks are listed in (Hooke 1678).
#include "classics/problems.hpp"
#include "support/deformables.hpp"

#include <algorithm>

namespace stacked_solids {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double side = 0.3, thickness = 0.06, density = 400; // [m], [m], [kg/m³]

Deformable block(double bottom, double youngs_modulus)
{
    SolidMaterial material;
    material.density = density;
    material.youngs_modulus = youngs_modulus;
    material.poisson_ratio = 0;
    material.damping = 0.01;
    material.drag = 3;
    material.surface = {0, 0.5};
    return make_deformable("block", block_tetrahedra({side, side, side}, {3, 4, 3}), material,
                           Matrix3d::Identity(), Vector3d(0, bottom + side / 2, 0));
}

RigidBody plate(double bottom, double M)
{
    RigidBody body = body_of(Box{{0.5, thickness, 0.5}}, {0, bottom + thickness / 2, 0}, {0, 0.5});
    set_mass(body, M, body.inertia * (M / body.mass));
    return body;
}

} // namespace

TEST_CASE("classics: a soft block bears the blocks and plates above it in any order of the list",
          "[classics][unsanitized]")
{
    const double E = 5e5, top = 30;
    Sweep sweep;
    for (const double M : {2., 10., 100.})
        for (const bool is_lower_first : {true, false})
            for (const double h : {0.01, 0.005}) {
                if (!sweep.takes_next()) continue;
                CAPTURE(M, is_lower_first, h);
                DeformableWorld world = world_of(block(0, E));
                world.solids.push_back(block(side + thickness, 2e5));
                if (!is_lower_first) std::reverse(world.solids.begin(), world.solids.end());
                world.rigid.settings.gravity = {0, -g, 0};
                world.rigid.bodies = {fixed(Plane{}, {0, 0.5}), plate(side, M),
                                      plate(2 * side + thickness, top)};
                run(world, h, static_cast<int>(std::lround(3 / h)));
                const double block_mass = density * side * side * side;
                const double load =
                    (M + top + 1.5 * block_mass) * g;   // a block bears half of itself
                const double exact = load / (E * side); // F L/(E A)
                const double sinks =
                    side + thickness / 2 - world.rigid.bodies[1].state.position.y();
                check_at_most(std::abs(sinks / exact - 1), 0.01, "error of the compression");
            }
}

} // namespace stacked_solids
