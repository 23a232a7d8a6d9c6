// SPDX-License-Identifier: MIT
#include "deformable/fracture/crack_edges.hpp"
#include "deformable/solid/pieces.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"

#include <algorithm>
#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr std::array all_real = {1, 1, 1, 1};

// Two tetrahedra that share the face 1 2 3, one above it and one below it.
Deformable two_elements(Random& random)
{
    TetrahedralMesh mesh{{{0, 0, 1}, {1, 0, 0}, {-0.5, 0.9, 0}, {-0.5, -0.9, 0}, {0, 0, -1}},
                         {{0, 1, 2, 3}, {4, 1, 3, 2}}};
    for (Vector3d& x : mesh.vertices)
        x += 0.1 * random.vector();
    Deformable solid = solid_of(mesh, soft_material());
    solid.uncracked = solid.rest;
    return solid;
}

// A plate with a notch. The two ends of the plate are pulled apart.
DeformableWorld pulled_plate()
{
    SolidMaterial material;
    material.youngs_modulus = 1e7;
    material.strength = 3e5;
    material.damping = 0.02;
    Deformable plate = solid_of(notched_tetrahedra({1, 0.7, 0.1}, {11, 8, 1}, {1, 3}), material);
    plate.fracture_method = FractureMethod::virtual_nodes;
    pull_apart(plate, 0.06, 0.6);
    return world_of(plate);
}

} // namespace

TEST_CASE("crack edges: a crack goes on through the cuts on the face that it comes from",
          "[deformable]")
{
    int met = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Deformable solid = two_elements(random);
        const auto& x = solid.rest.vertices;
        // The plane is nearly vertical, so that it cuts the face.
        const Vector3d n =
            (Vector3d(random.unit_vector().x(), 1, 0) + 0.2 * random.vector()).normalized();
        const Vector3d p = (x[1] + x[2] + x[3]) / 3 + 0.1 * random.vector();
        solid.cracks.push_back({0, p, n});
        std::vector<Vector3d> cuts;
        for (const auto& [a, b] : {std::pair(1, 2), std::pair(2, 3), std::pair(1, 3)}) {
            const double h = n.dot(x[a] - p), g = n.dot(x[b] - p);
            if ((h >= 0) != (g >= 0)) cuts.push_back(x[a] + h / (h - g) * (x[b] - x[a]));
        }
        const CrackEdges edges(solid);
        REQUIRE(edges.meets(1, all_real) == !cuts.empty());
        if (cuts.empty()) continue;
        REQUIRE(cuts.size() == 2);
        ++met;
        const Vector3d d = (cuts[1] - cuts[0]).normalized();
        const Vector3d wanted = (n + 0.4 * random.unit_vector()).normalized();
        const ElementCrack crack = edges.continued(1, all_real, wanted);
        REQUIRE(crack.tetrahedron == 1);
        for (const Vector3d& cut : cuts)
            REQUIRE_THAT(crack.normal.dot(cut - crack.point), IsClose(0.0, Rounding(64, 2)));
        // This is the plane through both cuts whose normal is nearest to the wanted one.
        const Vector3d nearest = (wanted - wanted.dot(d) * d).normalized();
        REQUIRE_THAT(crack.normal, IsClose(nearest, Rounding(64)));
    }
    CHECK(met > 100);
}

TEST_CASE("crack edges: a crack that would turn by more than 60 degrees does not", "[deformable]")
{
    Random random(3);
    Deformable solid = two_elements(random);
    const auto& x = solid.rest.vertices;
    const Vector3d n = Vector3d::UnitY(), p = (x[1] + x[2] + x[3]) / 3;
    solid.cracks.push_back({0, p, n});
    const CrackEdges edges(solid);
    // The wanted normal is along the cut. No plane through both points of the cut has a normal near
    // to it, but a plane through one of these points has.
    const ElementCrack crack = edges.continued(1, all_real, Vector3d::UnitX());
    CHECK_THAT(crack.normal, IsClose(Vector3d::UnitX().eval(), Rounding(8)));
    CHECK(edges.has_similar(0, Vector3d(0, -1, 0)));
    CHECK(!edges.has_similar(0, Vector3d::UnitX()));
    CHECK(!edges.has_similar(1, n));
}

TEST_CASE("crack edges: a plate tears in two with hardly a splinter", "[deformable]")
{
    DeformableWorld world = pulled_plate();
    run(world, 0.002, 200);
    const Deformable& plate = world.solids[0];
    const std::vector<int> piece = pieces(plate);
    std::vector<double> shares(1 + *std::max_element(piece.begin(), piece.end()), 0.0);
    for (std::size_t e = 0; e < piece.size(); ++e)
        shares[piece[e]] += plate.embedded.fractions[e] *
                            tetrahedron_volume(plate.rest, static_cast<int>(e)) /
                            totals(plate).volume;
    std::sort(shares.rbegin(), shares.rend());
    REQUIRE(shares.size() >= 2);
    CAPTURE(shares);
    CHECK(shares.size() <= 4);
    CHECK(shares[0] + shares[1] > 0.9);
}

TEST_CASE("crack edges: no crack goes on along a corner: what it cuts off would have no matter",
          "[deformable]")
{
    int met = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Deformable solid = two_elements(random);
        const auto& x = solid.rest.vertices;
        solid.cracks.push_back({0, x[1], random.unit_vector()}); // through a shared corner
        const CrackEdges edges(solid);
        met += edges.meets(1, all_real);
        const ElementCrack crack = edges.continued(1, all_real, random.unit_vector());
        for (const int v : solid.rest.tetrahedra[1])
            REQUIRE(std::abs(crack.normal.dot(x[v] - crack.point)) > 1e-9);
    }
    CHECK(met > 50);
}
