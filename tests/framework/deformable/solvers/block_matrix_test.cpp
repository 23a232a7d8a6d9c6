// SPDX-License-Identifier: MIT
#include "deformable/elasticity/element.hpp"
#include "deformable/elasticity/elements.hpp"
#include "deformable/solvers/block_matrix.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

// A block with vertices that no element uses, before, between and after the others.
TetrahedralMesh with_unused_vertices()
{
    TetrahedralMesh mesh = block_tetrahedra({1, 1, 1}, {1, 1, 1});
    for (const int at : {0, 4, static_cast<int>(mesh.vertices.size()) + 2}) {
        mesh.vertices.insert(mesh.vertices.begin() + at, Vector3d(5, 5, 5));
        for (auto& corners : mesh.tetrahedra)
            for (int& corner : corners)
                corner += corner >= at ? 1 : 0;
    }
    return mesh;
}

} // namespace

TEST_CASE("block matrix: a node of no element has a block of its own", "[deformable]")
{
    const Deformable solid = solid_of(with_unused_vertices(), soft_material());
    const int nodes = static_cast<int>(solid.rest.vertices.size());
    const Elements elements(solid);
    BlockMatrix matrix;
    matrix.analyse(elements, nodes);
    std::vector<ElementStrain> strains(solid.rest.tetrahedra.size());
    for (ElementStrain& strain : strains)
        strain.R = Matrix3d::Identity();
    std::vector<double> masses(nodes);
    for (int i = 0; i < nodes; ++i)
        masses[i] = i + 1;
    matrix.assemble(elements, strains, masses, solid.material, 0.0); // step 0: only masses are left
    for (int i = 0; i < nodes; ++i)
        REQUIRE_THAT(matrix.diagonal(i),
                     IsClose(Matrix3d((i + 1) * Matrix3d::Identity()), Exactly()));
}

TEST_CASE("block matrix: the step of a solid with nodes of no element says what is not finite",
          "[deformable]")
{
    for (const NodeIntegrator integrator :
         {NodeIntegrator::explicit_step, NodeIntegrator::implicit_step}) {
        Deformable solid = solid_of(with_unused_vertices(), soft_material());
        solid.integrator = integrator;
        DeformableWorld world = world_of(solid);
        REQUIRE_THROWS_AS(step(world, 0.01), NonFiniteState); // such nodes have no mass
    }
}
