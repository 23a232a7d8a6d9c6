// SPDX-License-Identifier: MIT
// A brittle bar breaks across the pull, where the largest principal stress exceeds its strength
// (Rankine 1857): at the strain strength/E, and not before it.
#include "classics/problems.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a brittle bar breaks across its pull at its strength", "[classics]")
{
    const double E = 1e6, strength = 1e4;
    for (const double share : {0.9, 1.15}) {
        CAPTURE(share);
        SolidMaterial material;
        material.youngs_modulus = E;
        material.poisson_ratio = 0;
        material.strength = strength;
        Deformable bar = solid_of(block_tetrahedra({2, 0.5, 0.5}, {8, 2, 2}), material);
        pull_apart(bar, share * strength / E, 2); // over 2 m: the strain is the share of 0.01
        DeformableWorld world = world_of(std::move(bar));
        run(world, 0.02, 110);
        const Deformable& solid = world.solids[0];
        CHECK((solid.topology > 0) == (share > 1));
        double across = 0, area = 0; // twice the areas of the cracks, and their part across x
        for (std::size_t t = 0; t < solid.crack_faces.size(); ++t)
            for (int f = 0; f < 4; ++f) {
                if (!solid.crack_faces[t][f]) continue;
                std::vector<Vector3d> x;
                for (int i = 0; i < 4; ++i)
                    if (i != f) x.push_back(solid.rest.vertices[solid.rest.tetrahedra[t][i]]);
                const Vector3d normal = (x[1] - x[0]).cross(x[2] - x[0]);
                across += std::abs(normal.x());
                area += normal.norm();
            }
        if (share > 1) {
            check_at_least(area, 1e-3, "area of the cracks [m²]");
            check_at_least(across / area, 0.7, "mean cosine with the pull");
        }
    }
}
