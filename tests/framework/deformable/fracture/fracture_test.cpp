// SPDX-License-Identifier: MIT
#include "deformable/fracture/remesh.hpp"
#include "deformable/solid/pieces.hpp"
#include "formulas/fracture.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"

#include <algorithm>

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr std::array methods = {FractureMethod::faces, FractureMethod::elements,
                                FractureMethod::virtual_nodes};

Deformable moving_block(Random& random)
{
    Deformable solid = solid_of(random_mesh(random), soft_material());
    for (std::size_t i = 0; i < solid.positions.size(); ++i) {
        solid.positions[i] += 0.1 * random.vector() + Vector3d(1, 2, 3);
        solid.velocities[i] = random.vector();
    }
    for (Matrix3d& strain : solid.plastic_strains)
        strain = 0.01 * random.positive_definite();
    Handle handle;
    handle.nodes = {0, 1, 2, 3};
    handle.first_places = {solid.positions[0], solid.positions[1], solid.positions[2],
                           solid.positions[3]};
    solid.handles.push_back(handle);
    return solid;
}

void require_same_sums(const Deformable& before, const Deformable& after)
{
    const DeformableTotals a = totals(before), b = totals(after);
    REQUIRE_THAT(b.mass, IsClose(a.mass, Rounding(200)));
    REQUIRE_THAT(b.volume, IsClose(a.volume, Rounding(200)));
    REQUIRE_THAT(b.momentum, IsClose(a.momentum, Rounding(500, a.mass)));
    REQUIRE_THAT(b.center_of_mass, IsClose(a.center_of_mass, Rounding(500, 1)));
    REQUIRE_THAT(b.angular_momentum, IsClose(a.angular_momentum, Rounding(2000, 5 * a.mass)));
    REQUIRE_THAT(b.elastic_energy, IsClose(a.elastic_energy, Rounding(2000)));
    REQUIRE(b.kinetic_energy < a.kinetic_energy * 1.05); // restoring the spin adds some
}

int count_pieces(const Deformable& solid)
{
    const std::vector<int> numbers = pieces(solid);
    return 1 + *std::max_element(numbers.begin(), numbers.end());
}

// A bar whose ends are pulled apart.
DeformableWorld pulled_bar(FractureMethod method, NodeIntegrator integrator)
{
    SolidMaterial material = soft_material();
    material.strength = 4000;
    material.damping = 1e-3;
    Deformable bar = solid_of(notched_tetrahedra({1, 0.3, 0.1}, {10, 3, 1}, {2, 1}), material);
    bar.integrator = integrator;
    bar.fracture_method = method;
    pull_apart(bar, 0.1, 1);
    return world_of(bar);
}

} // namespace

TEST_CASE("fracture: a mesh that comes apart keeps mass and momenta", "[deformable]")
{
    for (unsigned seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Deformable before = moving_block(random);

        Deformable faces = before;
        std::vector<MeshFace> all;
        for (int t = 0; t < static_cast<int>(before.rest.tetrahedra.size()); ++t)
            for (int f = 0; f < 4; ++f)
                if (random.uniform(0, 1) < 0.5) all.push_back({t, f});
        remesh(faces, split_along_faces(faces.rest, all));
        REQUIRE(faces.positions.size() > before.positions.size());
        require_same_sums(before, faces);

        Deformable cut = before;
        for (int k = 0; k < 3; ++k) {
            const int vertex =
                static_cast<int>(random.uniform(0, static_cast<double>(cut.positions.size())));
            remesh(cut, split_element(cut.rest, vertex, random.unit_vector()));
            require_same_sums(before, cut);
        }
        REQUIRE(cut.rest.tetrahedra.size() > before.rest.tetrahedra.size());

        Deformable copied = before;
        copied.uncracked = before.rest;
        for (int k = 0; k < 12; ++k) {
            const int t = static_cast<int>(
                random.uniform(0, static_cast<double>(before.rest.tetrahedra.size())));
            Vector3d middle = Vector3d::Zero();
            for (const int v : before.rest.tetrahedra[t])
                middle += before.rest.vertices[v] / 4;
            copied.cracks.push_back({t, middle, random.unit_vector()});
            remesh(copied, virtual_nodes(copied.uncracked, copied.cracks));
            require_same_sums(before, copied);
        }
        REQUIRE(copied.rest.tetrahedra.size() >= before.rest.tetrahedra.size() + 6);
    }
}

TEST_CASE("fracture: a bar that is pulled breaks in every way", "[deformable]")
{
    for (const FractureMethod method : methods)
        for (const NodeIntegrator integrator :
             {NodeIntegrator::explicit_step, NodeIntegrator::implicit_step}) {
            CAPTURE(static_cast<int>(method), static_cast<int>(integrator));
            DeformableWorld world = pulled_bar(method, integrator);
            const double mass = totals(world.solids[0]).mass;
            run(world, 0.01, 100);
            const Deformable& bar = world.solids[0];
            CHECK(world.rigid.counters.cracks > 0);
            CHECK(count_pieces(bar) >= 2);
            CHECK_THAT(totals(bar).mass, IsClose(mass, Rounding(2000)));
            CHECK(bar.handles[0].nodes.size() >= 8);
        }
}

TEST_CASE("fracture: skipping eigenvalues changes no crack", "[deformable]")
{
    for (const FractureMethod method : methods) {
        DeformableWorld with = pulled_bar(method, NodeIntegrator::implicit_step);
        DeformableWorld without = with;
        without.rigid.settings.optimisations.stress_bound = false;
        run(with, 0.01, 60);
        run(without, 0.01, 60);
        CHECK(with.solids[0].positions == without.solids[0].positions);
        CHECK(with.rigid.counters.cracks == without.rigid.counters.cracks);
        CHECK(with.rigid.counters.eigenvalues < without.rigid.counters.eigenvalues / 2);
    }
}

TEST_CASE("fracture: a thousand fragments have the mass and momenta of the whole", "[deformable]")
{
    Random random(5);
    Deformable solid = solid_of(block_tetrahedra({1, 1, 1}, {6, 6, 6}), soft_material());
    for (Vector3d& v : solid.velocities)
        v = random.vector();
    const Deformable whole = solid;
    std::vector<MeshFace> faces;
    for (int t = 0; t < static_cast<int>(solid.rest.tetrahedra.size()); ++t)
        for (int f = 0; f < 4; ++f)
            faces.push_back({t, f});
    remesh(solid, split_along_faces(solid.rest, faces));
    CHECK(count_pieces(solid) == 1080);
    require_same_sums(whole, solid);
    DeformableWorld world = world_of(solid);
    run(world, 0.01, 3);
    CHECK_THAT(totals(world.solids[0]).momentum,
               IsClose(totals(whole).momentum, Rounding(2000, totals(whole).mass)));
}
