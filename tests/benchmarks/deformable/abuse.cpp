// SPDX-License-Identifier: MIT
// Fracture under bad conditions. One part splits a block into many fragments and compares mass,
// volume and momenta before and after. The other deforms blocks violently for ten simulated
// minutes, with each fracture method and integrator, and counts inverted elements and states that
// are not finite.
#include "deformable/elasticity/totals.hpp"
#include "deformable/fracture/remesh.hpp"
#include "deformable/solid/pieces.hpp"
#include "formulas/fracture.hpp"
#include "parts.hpp"
#include "rigid/bodies/mass.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

using testing::end_nodes;
using testing::Random;
using testing::soft_material;
using testing::solid_of;
using testing::world_of;

namespace {

constexpr std::array<std::pair<const char*, FractureMethod>, 3> methods = {
    {{"faces", FractureMethod::faces},
     {"elements", FractureMethod::elements},
     {"virtual nodes", FractureMethod::virtual_nodes}}};

double count_pieces(const Deformable& solid)
{
    const std::vector<int> numbers = pieces(solid);
    return 1.0 + *std::max_element(numbers.begin(), numbers.end());
}

} // namespace

void measure_fragments(Bench& bench)
{
    for (const auto& [name, method] : methods) {
        Random random(5);
        Deformable solid = solid_of(block_tetrahedra({1, 1, 1}, {6, 6, 6}), soft_material());
        for (std::size_t i = 0; i < solid.positions.size(); ++i) {
            solid.positions[i] += 0.02 * random.vector();
            solid.velocities[i] = Vector3d(1, 2, 3) + random.vector();
        }
        const DeformableTotals before = totals(solid);
        if (method == FractureMethod::faces) {
            std::vector<MeshFace> faces;
            for (int t = 0; t < static_cast<int>(solid.rest.tetrahedra.size()); ++t)
                for (int f = 0; f < 4; ++f)
                    faces.push_back({t, f});
            remesh(solid, split_along_faces(solid.rest, faces));
        }
        for (int k = 0; k < 100 && method == FractureMethod::elements; ++k) {
            const auto n = static_cast<double>(solid.positions.size());
            const int vertex = static_cast<int>(random.uniform(0, n));
            remesh(solid, split_element(solid.rest, vertex, random.unit_vector()));
        }
        if (method == FractureMethod::virtual_nodes) {
            solid.uncracked = solid.rest;
            for (int t = 0; t < static_cast<int>(solid.rest.tetrahedra.size()); ++t) {
                Vector3d middle = Vector3d::Zero();
                for (const int v : solid.rest.tetrahedra[t])
                    middle += solid.rest.vertices[v] / 4;
                for (int k = 0; k < 3; ++k)
                    solid.cracks.push_back({t, middle, random.unit_vector()});
            }
            remesh(solid, virtual_nodes(solid.uncracked, solid.cracks));
        }
        const DeformableTotals after = totals(solid);
        const double P = before.mass * before.momentum.norm() / before.mass;
        const double mass = std::abs(after.mass / before.mass - 1),
                     volume = std::abs(after.volume / before.volume - 1),
                     momentum = (after.momentum - before.momentum).norm() / P,
                     spin = (after.angular_momentum - before.angular_momentum).norm() / P;
        bench.row({{"fragments by", name},
                   {"tetrahedra", static_cast<double>(solid.rest.tetrahedra.size())},
                   {"pieces", count_pieces(solid)},
                   {"mass", mass},
                   {"volume", volume},
                   {"momentum", momentum},
                   {"angular momentum", spin}});
        bench.reach({std::string("fragments by ") + name + ": mass", mass, 1e-12});
        bench.reach({std::string("fragments by ") + name + ": volume", volume, 1e-12});
        bench.reach({std::string("fragments by ") + name + ": momentum", momentum, 1e-12});
        bench.reach({std::string("fragments by ") + name + ": angular momentum", spin, 1e-11});
    }
}

namespace {

// A block that is twisted and pulled at both ends, then released, and hit by a ball.
DeformableWorld victim(FractureMethod method, NodeIntegrator integrator, Random& random)
{
    SolidMaterial material = soft_material();
    material.damping = 1e-3;
    material.yield_stress = 5e3;
    material.strength = 3e4;
    Deformable block = make_deformable("victim", block_tetrahedra({0.8, 0.2, 0.2}, {8, 2, 2}),
                                       material, Matrix3d::Identity(), Vector3d(0, 0.5, 0));
    block.integrator = integrator;
    block.fracture_method = method;
    for (const int side : {-1, 1}) {
        Handle handle;
        handle.nodes = end_nodes(block, side);
        handle.pivot = {0.4 * side, 0.5, 0};
        handle.path = {
            {0, Vector3d::Zero(), Vector3d::Zero()},
            {0.5, Vector3d(0.3 * side, 0, 0) + 0.2 * random.vector(), 2 * random.vector()},
            {1, -0.3 * random.vector(), 2 * random.vector()}};
        handle.release = 1;
        block.handles.push_back(handle);
    }
    DeformableWorld world = world_of(block);
    world.rigid.settings.gravity = {0, -9.81, 0};
    testing::add_floor(world);
    RigidBody ball;
    ball.name = "ball";
    ball.parts = {Part{Sphere{0.15}, Vector3d::Zero(), Quaternion{}, 3000}};
    set_mass_from_parts(ball);
    ball.state.position = Vector3d(0, 2, 0) + 0.1 * random.vector();
    ball.state.velocity = {0, -3, 0};
    world.rigid.bodies.push_back(ball);
    return world;
}

// The number of elements that are inverted if the nodes are at x.
int inverted(const Deformable& solid, const std::vector<Vector3d>& x)
{
    int count = 0;
    for (const auto& [a, b, c, d] : solid.rest.tetrahedra)
        count += !(tetrahedron_volume(x[a], x[b], x[c], x[d]) > 0);
    return count;
}

bool is_finite(const Deformable& solid)
{
    return std::all_of(solid.positions.begin(), solid.positions.end(),
                       [](const Vector3d& x) { return x.allFinite(); });
}

} // namespace

void measure_abuse(Bench& bench)
{
    constexpr double seconds_each = 5;
    constexpr int rounds = 20; // 3 methods × 2 integrators × 20 × 5 s
    double simulated = 0, left = 0, remeshed = 0, not_finite = 0;
    for (const auto& [name, method] : methods)
        for (const auto integrator :
             {NodeIntegrator::explicit_step, NodeIntegrator::implicit_step}) {
            double cracks = 0, most_pieces = 0, inside_out = 0, fastest = 0,
                   used = thread_seconds();
            for (int round = 0; round < rounds; ++round) {
                Random random(round);
                DeformableWorld world = victim(method, integrator, random);
                const Deformable& solid = world.solids[0];
                try {
                    for (double t = 0; t < seconds_each; t += 1.0 / 60) {
                        const int topology = solid.topology;
                        step(world, 1.0 / 60);
                        if (solid.topology != topology)
                            remeshed += inverted(solid, solid.rest.vertices);
                    }
                } catch (const std::exception&) {
                    ++not_finite;
                }
                if (!is_finite(solid)) ++not_finite;
                cracks += static_cast<double>(world.rigid.counters.cracks);
                most_pieces = std::max(most_pieces, count_pieces(solid));
                inside_out += inverted(solid, solid.positions);
                for (const Vector3d& v : solid.velocities)
                    fastest = std::max(fastest, v.norm());
                simulated += world.rigid.time;
            }
            used = thread_seconds() - used;
            left += inside_out;
            bench.row({{"ill-treated", name},
                       {"integrator",
                        integrator == NodeIntegrator::explicit_step ? "explicit" : "implicit"},
                       {"cracks", cracks},
                       {"most pieces", most_pieces},
                       {"inverted at the end", inside_out},
                       {"fastest [m/s]", fastest},
                       {"run time [s]", used}});
        }
    bench.reach({"ill-treatment: simulated minutes", simulated / 60, 9.99, "higher"});
    bench.reach({"ill-treatment: states that are no numbers", not_finite, 0});
    bench.reach({"ill-treatment: elements that a remesh left inside out at rest", remeshed, 0});
    bench.reach({"ill-treatment: inverted elements left", left, 0});
}

} // namespace rigor
