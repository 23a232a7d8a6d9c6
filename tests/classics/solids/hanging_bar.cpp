// SPDX-License-Identifier: MIT
// A bar that hangs by its upper end is stretched by its own weight by ρ g L²/(2 E), and by a weight
// W at its end by W L/(E A) (Hooke; Landau and Lifshitz, "Theory of elasticity", § 5).
#include "classics/problems.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a bar hangs down by its own weight and by another", "[classics]")
{
    const double L = 1, a = 0.25, E = 1e6, W = 100;
    for (const bool is_loaded : {false, true}) {
        CAPTURE(is_loaded);
        SolidMaterial material;
        material.youngs_modulus = E;
        material.poisson_ratio = 0;
        Deformable bar = solid_of(block_tetrahedra({L, a, a}, {8, 2, 2}), material);
        bar.handles.resize(1);
        bar.handles[0].nodes = end_nodes(bar, -1);
        const std::vector<int> end = end_nodes(bar, 1);
        if (is_loaded) bar.loads = {{end, {W, 0, 0}, 0, never}};
        DeformableWorld world = world_of(std::move(bar));
        const double weight = 0.1; // gravity [m/s²], so small that the strain is small
        world.rigid.settings.gravity = {is_loaded ? 0 : weight, 0, 0};
        run(world, 100, 12); // long steps of backward Euler: it comes to rest
        double stretch = 0;
        for (const int i : end)
            stretch += (world.solids[0].positions[i].x() - L / 2) / static_cast<double>(end.size());
        const double own = material.density * weight * L * L / (2 * E), other = W * L / (E * a * a);
        CHECK_THAT(stretch / (is_loaded ? other : own), IsClose(1.0, Order(0.03)));
    }
}
