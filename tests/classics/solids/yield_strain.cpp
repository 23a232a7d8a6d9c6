// SPDX-License-Identifier: MIT
// A block that is held at its sides and pulled yields at the strain σ_Y/(2 G), and flows from there
// by (ε - σ_Y/(2 G)) (2/3, -1/3, -1/3) (Hill 1950, "The mathematical theory of plasticity").
#include "classics/problems.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace yield_strain {

namespace {

// A block whose sides are held, after its ends were pulled to a strain.
Deformable pulled(double strain, double yield_stress)
{
    SolidMaterial material;
    material.youngs_modulus = 1e6;
    material.poisson_ratio = 0.3;
    material.yield_stress = yield_stress;
    Deformable block = solid_of(block_tetrahedra({1, 1, 1}, {2, 2, 2}), material);
    for (const double side : {-0.5, 0., 0.5}) { // every node goes as an even strain says
        Handle layer;
        for (int i = 0; i < static_cast<int>(block.rest.vertices.size()); ++i)
            if (std::abs(block.rest.vertices[i].x() - side) < 1e-9) layer.nodes.push_back(i);
        layer.path = {{0, Vector3d::Zero(), Vector3d::Zero()},
                      {1, Vector3d(side * strain, 0, 0), Vector3d::Zero()}};
        block.handles.push_back(layer);
    }
    DeformableWorld world = world_of(std::move(block));
    run(world, 0.02, 60);
    return world.solids[0];
}

} // namespace

TEST_CASE("classics: a block yields at its yield strain and flows from there", "[classics]")
{
    const double G = 1e6 / 2.6, yield_stress = 2 * G * 0.001;
    for (const Matrix3d& flowed : pulled(0.00098, yield_stress).plastic_strains)
        CHECK(flowed.isZero(0));
    for (const double strain : {0.00102, 0.003}) {
        CAPTURE(strain);
        const double flow = strain - 0.001;
        const Vector3d expected(2. / 3 * flow, -flow / 3, -flow / 3);
        for (const Matrix3d& flowed : pulled(strain, yield_stress).plastic_strains)
            REQUIRE_THAT(flowed, IsClose(Matrix3d(expected.asDiagonal()), Rounding(1e5, 1e-3)));
    }
}

} // namespace yield_strain
