// SPDX-License-Identifier: MIT
// Elements that stay inverted are separated, and mass and momenta stay the same.
#include "deformable/elasticity/element.hpp"
#include "deformable/fracture/inverted_elements.hpp"
#include "deformable/fracture/remesh.hpp"
#include "formulas/fracture.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"

#include <algorithm>

namespace inverted_elements_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr std::array methods = {FractureMethod::faces, FractureMethod::elements,
                                FractureMethod::virtual_nodes};
constexpr std::array integrators = {NodeIntegrator::explicit_step, NodeIntegrator::implicit_step};
constexpr double no_pull_breaks_it = 1e12; // [Pa]

bool is_inverted(const Deformable& solid, int element)
{
    return !(deformation_gradient(solid, element).determinant() > 0);
}

int inverted(const Deformable& solid)
{
    int count = 0;
    for (int e = 0; e < static_cast<int>(solid.rest.tetrahedra.size()); ++e)
        count += is_inverted(solid, e);
    return count;
}

// A block whose nodes are moved so far at random that elements are inverted and flow plastically.
Deformable crumpled_block(unsigned seed, double strength)
{
    Random random(seed);
    SolidMaterial material = soft_material();
    material.damping = 1e-2;
    material.yield_stress = 2e4;
    material.strength = strength;
    Deformable solid = solid_of(block_tetrahedra({0.4, 0.4, 0.4}, {2, 2, 2}), material);
    for (Vector3d& x : solid.positions)
        x += 0.3 * random.vector();
    return solid;
}

// The same block in motion, with some cracks, and with a record that all its elements have been
// inverted for longer than they may be.
Deformable inverted_block(unsigned seed, FractureMethod method)
{
    Deformable solid = crumpled_block(seed, no_pull_breaks_it);
    solid.fracture_method = method;
    Random random(seed);
    for (Vector3d& v : solid.velocities)
        v = Vector3d(1, 2, 3) + 5 * random.vector();
    for (Matrix3d& strain : solid.plastic_strains) {
        const Matrix3d A = random.positive_definite();
        strain = 0.3 * (A - A.trace() / 3 * Matrix3d::Identity()) / A.norm();
    }
    if (method == FractureMethod::virtual_nodes) {
        solid.uncracked = solid.rest;
        for (int t = 0; t < 40; t += 3)
            solid.cracks.push_back(
                {t, solid.rest.vertices[solid.rest.tetrahedra[t][0]] * 0.9, random.unit_vector()});
        remesh(solid, virtual_nodes(solid.uncracked, solid.cracks));
    } else {
        remesh(solid, split_along_faces(solid.rest, {{0, 0}, {1, 0}, {1, 1}, {1, 2}, {1, 3}}));
    }
    solid.inverted_times.assign(solid.rest.tetrahedra.size(), 1e9);
    return solid;
}

bool separate(Deformable& solid, World& world)
{
    ElementWorkspace work(solid);
    work.elements.strains(solid.positions, work.strains);
    return separate_inverted_elements(solid, work, {}, world, 0.01);
}

} // namespace

TEST_CASE("inverted elements: nothing that can break stays inside out", "[deformable][unsanitized]")
{
    for (const NodeIntegrator integrator : integrators) {
        int held_for_good = 0;
        for (unsigned seed = 0; seed < 6; ++seed) {
            CAPTURE(seed, static_cast<int>(integrator));
            Deformable tough = crumpled_block(seed, never);
            tough.integrator = integrator;
            DeformableWorld world = world_of(tough);
            run(world, 0.02, 200);
            held_for_good += inverted(world.solids[0]);
            for (const FractureMethod method : methods) {
                CAPTURE(static_cast<int>(method));
                Deformable brittle = crumpled_block(seed, no_pull_breaks_it);
                brittle.integrator = integrator;
                brittle.fracture_method = method;
                DeformableWorld other = world_of(brittle);
                run(other, 0.02, 200);
                REQUIRE(inverted(other.solids[0]) == 0);
            }
        }
        CHECK(held_for_good > 0);
    }
}

TEST_CASE("inverted elements: what comes off keeps mass and momenta and makes no energy",
          "[deformable]")
{
    for (const FractureMethod method : methods)
        for (unsigned seed = 0; seed < 20; ++seed) {
            CAPTURE(static_cast<int>(method), seed);
            Deformable solid = inverted_block(seed, method);
            const DeformableTotals a = totals(solid);
            const int before = inverted(solid);
            World world;
            REQUIRE(separate(solid, world));
            const DeformableTotals b = totals(solid);
            CHECK(inverted(solid) < before);
            REQUIRE_THAT(b.mass, IsClose(a.mass, Rounding(200)));
            REQUIRE_THAT(b.volume, IsClose(a.volume, Rounding(200)));
            REQUIRE_THAT(b.momentum, IsClose(a.momentum, Rounding(500, a.mass)));
            REQUIRE_THAT(b.center_of_mass, IsClose(a.center_of_mass, Rounding(500, 1)));
            REQUIRE_THAT(b.angular_momentum,
                         IsClose(a.angular_momentum, Rounding(2000, 5 * a.mass)));
            REQUIRE(b.kinetic_energy + b.elastic_energy < a.kinetic_energy + a.elastic_energy);
        }
}

TEST_CASE("inverted elements: of what is not inside out nothing moves", "[deformable]")
{
    for (const FractureMethod method : methods) {
        CAPTURE(static_cast<int>(method));
        const Deformable before = inverted_block(1, method);
        Deformable after = before;
        World world;
        separate(after, world);
        REQUIRE(after.rest.tetrahedra.size() == before.rest.tetrahedra.size());
        for (int e = 0; e < static_cast<int>(before.rest.tetrahedra.size()); ++e) {
            if (is_inverted(before, e)) continue;
            REQUIRE(deformation_gradient(after, e) == deformation_gradient(before, e));
        }
    }
}

TEST_CASE("inverted elements: what a handle holds inside out waits", "[deformable]")
{
    for (const FractureMethod method : methods) {
        CAPTURE(static_cast<int>(method));
        Deformable solid = crumpled_block(3, no_pull_breaks_it);
        solid.fracture_method = method;
        REQUIRE(inverted(solid) > 0);
        Handle handle;
        for (int i = 0; i < static_cast<int>(solid.positions.size()); ++i)
            handle.nodes.push_back(i);
        solid.handles.push_back(handle);
        const std::vector<Vector3d> places = solid.positions;
        DeformableWorld world = world_of(solid);
        run(world, 0.02, 100);
        CHECK(world.solids[0].topology == 0);
        CHECK(world.solids[0].positions == places);
        CHECK(world.solids[0].inverted_times.empty());
    }
}

// A tetrahedron with a corner pushed through its base turns back long before it would be separated,
// which is after 1.8 s here.
TEST_CASE("inverted elements: an element that can turn back does", "[deformable]")
{
    SolidMaterial material = soft_material();
    material.damping = 1e-2;
    material.strength = no_pull_breaks_it;
    const TetrahedralMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
    for (const NodeIntegrator integrator : integrators) {
        CAPTURE(static_cast<int>(integrator));
        Deformable solid = solid_of(mesh, material);
        solid.integrator = integrator;
        solid.positions[3].z() = -0.5;
        REQUIRE(inverted(solid) == 1);
        DeformableWorld world = world_of(solid);
        double most = 0;
        for (int i = 0; i < 400; ++i) {
            step(world, 0.005);
            const auto& times = world.solids[0].inverted_times;
            most = std::max(most, times.empty() ? 0.0 : times[0]);
        }
        CHECK(inverted(world.solids[0]) == 0);
        CHECK(most > 0);
        CHECK(most < 0.3);
    }
}

TEST_CASE("inverted elements: an element that would gain energy by its shape is left as it is",
          "[deformable]")
{
    const TetrahedralMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
    Deformable slow = solid_of(mesh, soft_material());
    for (Vector3d& x : slow.positions)
        x = -3 * x; // inverted, and far from the axis of its spin
    Deformable fast = slow;
    for (Deformable* solid : {&slow, &fast})
        for (std::size_t i = 0; i < 4; ++i)
            solid->velocities[i] =
                Vector3d(0, solid == &slow ? 1 : 1000, 0).cross(solid->positions[i]);
    const std::vector<Vector3d> places = fast.positions;
    CHECK(relax_element(slow, 0));
    CHECK(inverted(slow) == 0);
    CHECK_THAT(totals(slow).elastic_energy, IsClose(0.0, Rounding(100, 1e5)));
    CHECK_FALSE(relax_element(fast, 0));
    CHECK(fast.positions == places);
}

} // namespace inverted_elements_test
