// SPDX-License-Identifier: MIT
// Conservation in a step: energy, angular momentum, and no inverted elements.
#include "deformable/fracture/remesh.hpp"
#include "formulas/fracture.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"

#include <algorithm>

using namespace rigor;
using namespace rigor::testing;

namespace {

double energy(const DeformableWorld& world)
{
    double sum = 0;
    for (const Deformable& solid : world.solids) {
        const DeformableTotals of = totals(solid);
        sum += of.kinetic_energy + of.elastic_energy -
               of.mass * world.rigid.settings.gravity.dot(of.center_of_mass);
    }
    return sum;
}

int inverted(const TetrahedralMesh& mesh, const std::vector<Vector3d>& x)
{
    return static_cast<int>(
        std::count_if(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), [&](const auto& t) {
            return !(tetrahedron_volume(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) > 0);
        }));
}

// A block of stiff splinters, each of one element, that falls on a rough floor. Each node has in
// addition the velocity of a rotation about a random axis of its own.
DeformableWorld falling_splinters(unsigned seed)
{
    Random random(seed);
    SolidMaterial material = soft_material();
    material.youngs_modulus = 2e7;
    material.damping = 2e-3;
    material.surface = {0, 0.6};
    Deformable block = make_deformable("splinters", block_tetrahedra({0.4, 0.4, 0.4}, {2, 2, 2}),
                                       material, random.rotation(), Vector3d(0, 0.5, 0));
    for (std::size_t i = 0; i < block.positions.size(); ++i)
        block.velocities[i] =
            Vector3d(1, -2, 0) +
            3 * random.unit_vector().cross(block.positions[i] - Vector3d(0, 0.5, 0));
    std::vector<MeshFace> faces;
    for (int t = 0; t < static_cast<int>(block.rest.tetrahedra.size()); ++t)
        for (int f = 0; f < 4; ++f)
            faces.push_back({t, f});
    remesh(block, split_along_faces(block.rest, faces));
    DeformableWorld world = world_of(block);
    world.rigid.settings.gravity = {0, -9.81, 0};
    add_floor(world);
    world.rigid.bodies[0].material = {0, 0.6};
    return world;
}

// A bar with a notch. Its ends are bent down above a floor and then released.
DeformableWorld bent_bar(FractureMethod method)
{
    SolidMaterial material = soft_material();
    material.youngs_modulus = 2e7;
    material.strength = 6e5;
    material.damping = 2e-3;
    Deformable bar = make_deformable("bar", notched_tetrahedra({2, 0.2, 0.2}, {15, 3, 1}, {1, 1}),
                                     material, Matrix3d::Identity(), Vector3d(0, 0.5, 0));
    bar.fracture_method = method;
    for (const int side : {-1, 1}) {
        Handle handle;
        for (int i = 0; i < static_cast<int>(bar.positions.size()); ++i)
            if (side * bar.positions[i].x() > 0.8) handle.nodes.push_back(i);
        handle.pivot = {0.9 * side, 0.5, 0};
        handle.path = {{0, Vector3d::Zero(), Vector3d::Zero()},
                       {0.6, Vector3d::Zero(), Vector3d(0, 0, -0.7 * side)}};
        handle.release = 0.7;
        bar.handles.push_back(handle);
    }
    DeformableWorld world = world_of(bar);
    world.rigid.settings.gravity = {0, -9.81, 0};
    add_floor(world);
    world.rigid.bodies[0].material = {0, 0.6};
    return world;
}

} // namespace

// A step that turns an element by ω h stretches it by the fraction ½ (ω h)². These steps are short
// enough for tumbling splinters.
TEST_CASE("conservation: splinters on a floor gain no energy", "[deformable]")
{
    for (const double time_step : {0.0025, 0.005, 0.01})
        for (unsigned seed = 0; seed < 3; ++seed) {
            CAPTURE(time_step, seed);
            DeformableWorld world = falling_splinters(seed);
            const double first = energy(world);
            for (double time = 0; time < 1; time += time_step) {
                step(world, time_step);
                REQUIRE(energy(world) <= first * (1 + 1e-12));
            }
            CHECK(energy(world) < 0.5 * first);
        }
}

TEST_CASE("conservation: a bar that snaps gains no energy once it is let go",
          "[deformable][unsanitized]")
{
    for (const FractureMethod method :
         {FractureMethod::faces, FractureMethod::elements, FractureMethod::virtual_nodes})
        for (const double time_step : {0.005, 0.01, 0.02}) {
            // With virtual nodes, the longest of these steps is too long.
            if (method == FractureMethod::virtual_nodes && time_step > 0.01) continue;
            CAPTURE(static_cast<int>(method), time_step);
            DeformableWorld world = bent_bar(method);
            for (double time = 0; time < 0.75; time += time_step)
                step(world, time_step);
            CHECK(world.rigid.counters.cracks > 0);
            const double let_go = energy(world);
            for (double time = 0; time < 1; time += time_step) {
                step(world, time_step);
                REQUIRE(energy(world) <= let_go * (1 + 1e-12));
            }
        }
}

// Backward Euler uses the rotations of the elements at the start of a step, and its damping acts on
// the rotation of a stretched solid. The angular momentum that this takes is given back.
TEST_CASE("conservation: implicit steps keep the angular momentum", "[deformable]")
{
    Random random(7);
    SolidMaterial material = soft_material();
    material.damping = GENERATE(0.0, 0.01);
    Deformable solid = solid_of(random_mesh(random), material);
    for (std::size_t i = 0; i < solid.positions.size(); ++i)
        solid.velocities[i] = Vector3d(1, -1, 2).cross(solid.positions[i]) + 0.5 * random.vector();
    const Vector3d L = totals(solid).angular_momentum;
    for (const double time_step : {0.02, 0.004, 0.001}) {
        CAPTURE(material.damping, time_step);
        DeformableWorld world = world_of(solid);
        run(world, time_step, static_cast<int>(std::lround(0.2 / time_step)));
        CHECK_THAT(totals(world.solids[0]).angular_momentum, IsClose(L, Rounding(1e5, L.norm())));
    }
}

TEST_CASE("conservation: a cut turns no element inside out", "[deformable]")
{
    for (unsigned seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Deformable solid = solid_of(random_mesh(random), soft_material());
        const Matrix3d F = random.rotation() * (Matrix3d::Identity() + 0.3 * random.rotation());
        for (Vector3d& x : solid.positions)
            x = F * x + 0.03 * random.vector();
        REQUIRE(inverted(solid.rest, solid.positions) == 0);
        for (int k = 0; k < 6; ++k) {
            const auto n = static_cast<double>(solid.positions.size());
            remesh(solid, split_element(solid.rest, static_cast<int>(random.uniform(0, n)),
                                        random.unit_vector()));
            REQUIRE(inverted(solid.rest, solid.rest.vertices) == 0);
            REQUIRE(inverted(solid.rest, solid.positions) == 0);
        }
    }
}

TEST_CASE("conservation: a bar that snaps has no element inside out", "[deformable]")
{
    for (const FractureMethod method :
         {FractureMethod::faces, FractureMethod::elements, FractureMethod::virtual_nodes}) {
        CAPTURE(static_cast<int>(method));
        DeformableWorld world = bent_bar(method);
        const Deformable& bar = world.solids[0];
        for (int topology = 0, i = 0; i < 170; ++i) {
            step(world, 0.01);
            if (bar.topology == topology) continue;
            topology = bar.topology;
            REQUIRE(inverted(bar.rest, bar.rest.vertices) == 0);
        }
        CHECK(bar.topology > 0);
        CHECK(inverted(bar.rest, bar.positions) == 0);
    }
}
