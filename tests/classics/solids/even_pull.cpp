// SPDX-License-Identifier: MIT
// A bar that is pulled evenly is strained evenly, however its mesh is cut: along the pull by σ/E,
// across it by -ν σ/E (Poisson 1829). Linear elements meet it exactly, the patch test of Irons
// (1966), up to terms of large strain.
#include "classics/problems.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a pulled bar becomes longer and thinner evenly", "[classics]")
{
    const double E = 1e6, strain = 1e-4;
    for (const double nu : {0., 0.3, 0.45}) {
        CAPTURE(nu);
        SolidMaterial material;
        material.youngs_modulus = E;
        material.poisson_ratio = nu;
        TetrahedralMesh mesh = block_tetrahedra({2, 1, 1}, {4, 2, 2});
        Random random(11);
        for (Vector3d& x : mesh.vertices) // only inner nodes
            if (std::abs(x.x()) < 0.9 && std::abs(x.y()) < 0.4 && std::abs(x.z()) < 0.4)
                x += 0.1 * random.vector();
        Deformable bar = solid_of(std::move(mesh), material);
        for (const int side : {-1, 1}) { // its ends move along x and are free across it
            Handle handle;
            handle.nodes = end_nodes(bar, side);
            handle.axes = {true, false, false};
            handle.path = {{0, Vector3d::Zero(), Vector3d::Zero()},
                           {1, Vector3d(strain * side, 0, 0), Vector3d::Zero()}};
            bar.handles.push_back(handle);
        }
        DeformableWorld world = world_of(std::move(bar));
        run(world, 100, 12);
        const Deformable& solid = world.solids[0];
        for (std::size_t i = 0; i < solid.positions.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) { // all distances
                const Vector3d d = solid.rest.vertices[i] - solid.rest.vertices[j];
                const Vector3d stretched(d.x() * (1 + strain), d.y() * (1 - nu * strain),
                                         d.z() * (1 - nu * strain));
                REQUIRE_THAT((solid.positions[i] - solid.positions[j]).norm(),
                             IsClose(stretched.norm(), Order(1e-3 * strain)));
            }
        // U = ½ E ε² V
        CHECK_THAT(totals(solid).elastic_energy,
                   IsClose(E * strain * strain / 2 * 2, Order(1e-3 * E * strain * strain)));
    }
}
