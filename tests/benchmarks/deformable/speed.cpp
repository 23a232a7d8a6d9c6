// SPDX-License-Identifier: MIT
// Speed of deformable solids. A bar that bends is stepped with each integrator, and the time is
// split by stage. The conjugate gradients of the implicit integrator are compared with a sparse
// Cholesky factorization, and the search for cracks with and without skipping eigenvalues.
#include "deformable/fracture/fracture.hpp"
#include "deformable/motion/workspace.hpp"
#include "parts.hpp"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <numeric>

namespace rigor {

using testing::end_nodes;
using testing::soft_material;
using testing::solid_of;
using testing::world_of;

namespace {

// A bar that is held at one end and bends under its weight.
DeformableWorld bent_bar(const std::array<int, 3>& cells, NodeIntegrator integrator)
{
    const Vector3d size = Vector3d(cells[0], cells[1], cells[2]) / cells[1];
    SolidMaterial material = soft_material();
    material.youngs_modulus = 1e7;
    material.damping = 1e-3;
    Deformable bar = solid_of(block_tetrahedra(size, cells), material);
    bar.integrator = integrator;
    Handle handle;
    handle.nodes = end_nodes(bar, -1);
    bar.handles.push_back(handle);
    DeformableWorld world = world_of(bar);
    world.rigid.settings.gravity = {0, -9.81, 0};
    return world;
}

double milliseconds(int repeats, const std::function<void()>& work)
{
    std::vector<double> times;
    for (int i = 0; i < repeats; ++i) {
        const double start = thread_seconds();
        work();
        times.push_back(1e3 * (thread_seconds() - start));
    }
    return median(times);
}

constexpr double h = 1.0 / 60;

void measure_explicit(Bench& bench, const std::array<int, 3>& cells)
{
    DeformableWorld world = bent_bar(cells, NodeIntegrator::explicit_step);
    step(world, h);
    const auto before = world.rigid.counters.deformable_substeps;
    const std::size_t allocations = heap().allocations;
    const double start = thread_seconds();
    const int steps = 3;
    for (int i = 0; i < steps; ++i)
        step(world, h);
    const double ms = 1e3 * (thread_seconds() - start) / steps;
    const auto allocated = static_cast<double>(heap().allocations - allocations);
    const double substeps =
        static_cast<double>(world.rigid.counters.deformable_substeps - before) / steps;
    Deformable& solid = world.solids[0];
    Workspace& work = workspace_of(solid);
    const double forces = milliseconds(
        9, [&] { work.elements.add_forces(solid.positions, solid.velocities, work.forces); });
    bench.row({{"explicit, tetrahedra", static_cast<double>(solid.rest.tetrahedra.size())},
               {"ms a step", ms},
               {"substeps", substeps},
               {"ms a substep", ms / substeps},
               {"of it forces", forces * substeps / ms},
               {"allocations a step", allocated / steps}});
    if (solid.rest.tetrahedra.size() > 49000) {
        bench.reach({"explicit, 50 000 tetrahedra: ms a substep", ms / substeps, 12});
        bench.reach({"explicit: allocations a step", allocated / steps, 0});
    }
}

void measure_implicit(Bench& bench, const std::array<int, 3>& cells)
{
    const std::size_t empty = heap().bytes;
    DeformableWorld world = bent_bar(cells, NodeIntegrator::implicit_step);
    step(world, h), step(world, h);
    const auto before = world.rigid.counters.solver_iterations;
    const std::size_t allocations = heap().allocations;
    const double start = thread_seconds();
    const int steps = 3;
    for (int i = 0; i < steps; ++i)
        step(world, h);
    const double ms = 1e3 * (thread_seconds() - start) / steps;
    const auto allocated = static_cast<double>(heap().allocations - allocations);
    const double megabytes = 1e-6 * static_cast<double>(heap().bytes - empty);
    const double iterations =
        static_cast<double>(world.rigid.counters.solver_iterations - before) / steps;
    Deformable& solid = world.solids[0];
    Workspace& work = workspace_of(solid);
    const double strains =
        milliseconds(5, [&] { work.elements.strains(solid.positions, work.strains); });
    const double assembly = milliseconds(5, [&] {
        work.velocity_system.system.assemble(work.elements, work.strains, solid.masses,
                                             solid.material, h);
    });
    bench.row({{"implicit, tetrahedra", static_cast<double>(solid.rest.tetrahedra.size())},
               {"ms a step", ms},
               {"iterations", iterations},
               {"of it rotations", strains / ms},
               {"assembly", assembly / ms},
               {"the rest, solving", 1 - (strains + assembly) / ms},
               {"MB", megabytes},
               {"allocations a step", allocated / steps}});
    if (solid.rest.tetrahedra.size() > 49000) {
        bench.reach({"implicit, 50 000 tetrahedra: ms a step", ms, 600});
        bench.reach({"implicit, 50 000 tetrahedra: MB", megabytes, 100});
        bench.reach({"implicit: allocations a step", allocated / steps, 0});
    }
}

// The same linear system, solved directly by Cholesky factorization. Each step has a new matrix, so
// each would pay this cost.
void measure_factorisation(Bench& bench, const std::array<int, 3>& cells)
{
    DeformableWorld world = bent_bar(cells, NodeIntegrator::implicit_step);
    step(world, h), step(world, h);
    Deformable& solid = world.solids[0];
    Workspace& work = workspace_of(solid);
    std::vector<Eigen::Triplet<double>> entries;
    work.velocity_system.system.matrix().for_each_block([&](int i, int j, const Matrix3d& A) {
        for (int k = 0; k < 9; ++k) // the lower triangle, which Cholesky reads
            entries.emplace_back(3 * j + k % 3, 3 * i + k / 3, A(k / 3, k % 3));
    });
    const int n = 3 * static_cast<int>(solid.positions.size());
    Eigen::SparseMatrix<double> A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factors;
    const double analysis = milliseconds(1, [&] { factors.analyzePattern(A); });
    const double numbers = milliseconds(1, [&] { factors.factorize(A); });
    std::vector<Vector3d> v(solid.positions.size(), Vector3d::Zero());
    std::vector<int> all(v.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<SystemBody> none;
    VelocitySystem& system = work.velocity_system;
    int iterations = 0;
    const double gradients = milliseconds(3, [&] {
        v.assign(v.size(), Vector3d::Zero());
        iterations = system.system.solve(system.momenta, all, system.ties, none, v);
    });
    bench.row({{"solver, tetrahedra", static_cast<double>(solid.rest.tetrahedra.size())},
               {"conjugate gradients [ms]", gradients},
               {"iterations", static_cast<double>(iterations)},
               {"Cholesky: analysis [ms]", analysis},
               {"numbers [ms]", numbers}});
}

// A bar that is pulled until it cracks, with and without skipping eigenvalues; the cracks must be
// the same. The times are those of the search for cracks, in steps without a crack and in the
// others.
void measure_skip(Bench& bench)
{
    const auto pulled = [](bool skips) {
        DeformableWorld world = bent_bar({32, 8, 8}, NodeIntegrator::implicit_step);
        world.rigid.settings.optimisations.stress_bound = skips;
        Deformable& bar = world.solids[0];
        bar.material.strength = 1e5;
        Handle handle;
        handle.nodes = end_nodes(bar, 1);
        handle.path = {{0, Vector3d::Zero(), Vector3d::Zero()},
                       {1, Vector3d(0.3, 0, 0), Vector3d::Zero()}};
        bar.handles.push_back(handle);
        return world;
    };
    std::array<DeformableWorld, 2> worlds = {pulled(true), pulled(false)};
    std::array<double, 2> quiet = {}, cracking = {}, computed = {};
    for (int i = 0; i < 20; ++i)
        for (int k = 0; k < 2; ++k) {
            DeformableWorld& world = worlds[k];
            const auto cracks = world.rigid.counters.cracks,
                       eigenvalues = world.rigid.counters.eigenvalues;
            step(world, h);
            computed[k] += static_cast<double>(world.rigid.counters.eigenvalues - eigenvalues);
            const bool is_quiet = world.rigid.counters.cracks == cracks;
            Deformable copy = world.solids[0]; // discarded after the measurement
            Workspace& work = workspace_of(copy);
            work.elements.strains(copy.positions, work.strains);
            Counters counters = world.rigid.counters;
            const double start = thread_seconds();
            fracture(copy, work, world.rigid);
            (is_quiet ? quiet : cracking)[k] += 1e3 * (thread_seconds() - start);
            world.rigid.counters = counters;
        }
    for (int k = 0; k < 2; ++k)
        bench.row({{"eigenvalues", k == 0 ? "skipped" : "all"},
                   {"computed", computed[k]},
                   {"steps without a crack [ms]", quiet[k]},
                   {"others [ms]", cracking[k]},
                   {"cracks", static_cast<double>(worlds[k].rigid.counters.cracks)}});
    const bool is_same = worlds[0].solids[0].positions == worlds[1].solids[0].positions;
    bench.reach({"eigenvalues skipped: same bits", is_same ? 1.0 : 0.0, 1, "higher"});
    bench.reach({"eigenvalues skipped: looking for cracks where there are none, over all",
                 quiet[0] / quiet[1], 0.5});
}

} // namespace

void measure_speed(Bench& bench)
{
    for (const std::array<int, 3>& cells : {std::array{16, 8, 8}, std::array{40, 16, 16}}) {
        measure_explicit(bench, cells);
    }
    for (const std::array<int, 3>& cells : {std::array{16, 8, 8}, std::array{40, 16, 16}})
        measure_implicit(bench, cells);
    for (const std::array<int, 3>& cells : {std::array{8, 4, 4}, std::array{16, 8, 8}})
        measure_factorisation(bench, cells);
    measure_skip(bench);
}

} // namespace rigor
