// SPDX-License-Identifier: MIT
// Plastic flow within a step: at the end of the step, the stress is not beyond the yield surface.
// The result is better than with flow after the step, no energy is added, and where nothing flows,
// the step costs no more.
#include "deformable/elasticity/element.hpp"
#include "deformable/elasticity/elements.hpp"
#include "formulas/plasticity.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr std::array both_integrators = {NodeIntegrator::explicit_step,
                                         NodeIntegrator::implicit_step};

// A bar of a random material, held at one end and pulled, pressed, sheared or bent at the other by
// 1.05 to 3 times what it bears, until its load ends. c is the speed of sound.
struct Loaded {
    Deformable bar;
    double load_ends = 0, c = 0; // [s], [m/s]
};

Loaded loaded_bar(Random& random, int kind)
{
    SolidMaterial m;
    m.youngs_modulus = std::pow(10, random.uniform(4, 8));
    m.poisson_ratio = random.uniform(-0.4, 0.49);
    m.yield_stress = m.youngs_modulus * std::pow(10, random.uniform(-4, -1.5));
    if (random.uniform(0, 1) < 0.5) m.drag = random.uniform(0, 4);
    const double c = std::sqrt(m.youngs_modulus / m.density);
    if (random.uniform(0, 1) < 0.5) m.damping = random.uniform(0, 0.1) / c;
    TetrahedralMesh mesh = block_tetrahedra({3, 1, 1}, {6, 2, 2});
    for (Vector3d& x : mesh.vertices)
        if (std::abs(x.x()) < 1.4) x += 0.1 * random.vector();
    Deformable bar = solid_of(std::move(mesh), m);
    Handle held;
    held.nodes = end_nodes(bar, -1);
    bar.handles = {held};
    const double F = random.uniform(1.05, 3) * m.yield_stress, ends = random.uniform(1, 5) / c;
    const Vector3d forces[] = {{F, 0, 0}, {-F, 0, 0}, {0, F / std::sqrt(3), 0}, {0, F / 12, 0}};
    bar.loads = {{end_nodes(bar, 1), forces[kind], 0, ends}};
    return {bar, ends, c};
}

double energy_of(const Deformable& solid)
{
    const DeformableTotals sum = totals(solid);
    return sum.kinetic_energy + sum.elastic_energy;
}

double largest_flow(const Deformable& solid)
{
    double most = 0;
    for (const Matrix3d& strain : solid.plastic_strains)
        most = std::max(most, strain.norm());
    return most;
}

} // namespace

TEST_CASE("flow: solids under any load end each step within the yield surface", "[deformable]")
{
    int flowed = 0;
    for (unsigned seed = 0; seed < 24; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Loaded loaded = loaded_bar(random, static_cast<int>(seed % 4));
        const double h = std::pow(10, random.uniform(-1.5, 0)) / loaded.c;
        DeformableWorld world = world_of(loaded.bar);
        const Deformable& bar = world.solids[0];
        double last = -1; // the energy, once the load has ended
        for (double time = 0; time < 2 * loaded.load_ends; time += h) {
            step(world, h);
            const std::vector<Matrix3d> stresses = element_stresses(bar);
            for (std::size_t e = 0; e < stresses.size(); ++e) {
                REQUIRE(stresses[e].allFinite());
                const Matrix3d& strain = bar.plastic_strains[e];
                // The engine lets no plastic strain grow beyond 0.8, and no inverted element flow.
                if (strain.norm() > 0.8 - 1e-9 ||
                    is_inverted(strain, elastic_strain(bar, static_cast<int>(e))))
                    continue;
                REQUIRE(von_mises(stresses[e]) <= bar.material.yield_stress * (1 + 1e-9));
            }
            if (last >= 0) REQUIRE(energy_of(bar) <= last * (1 + 1e-9));
            if (time > loaded.load_ends) last = energy_of(bar);
        }
        flowed += largest_flow(bar) > 0;
    }
    CHECK(flowed > 12);
}

// Newton's method converges: it takes an elastic solve, and a few more that correct the result.
TEST_CASE("flow: a step takes a few solves", "[deformable]")
{
    std::uint64_t most = 0, solves = 0, steps = 0;
    for (unsigned seed = 0; seed < 8; ++seed) {
        Random random(seed);
        const Loaded loaded = loaded_bar(random, static_cast<int>(seed % 4));
        DeformableWorld world = world_of(loaded.bar);
        for (int i = 0; i < 60; ++i) {
            const std::uint64_t before = world.rigid.counters.system_solves;
            step(world, 0.1 / loaded.c);
            most = std::max(most, world.rigid.counters.system_solves - before);
        }
        solves += world.rigid.counters.system_solves;
        steps += world.rigid.counters.steps;
    }
    check_at_most(static_cast<double>(most), 20, "solves in one step");
    check_at_most(static_cast<double>(solves) / static_cast<double>(steps), 5, "solves a step");
}

TEST_CASE("flow: within the step it converges as the step falls and after it far more slowly",
          "[deformable]")
{
    Random random(3);
    const Loaded loaded = loaded_bar(random, 0);
    const double T = loaded.load_ends;
    const auto stretch = [&](FlowTime time, NodeIntegrator integrator, int steps) {
        DeformableWorld world = world_of(loaded.bar);
        world.solids[0].integrator = integrator;
        world.solids[0].flow_time = time;
        run(world, T / steps, steps);
        double sum = 0;
        for (const int i : end_nodes(world.solids[0], 1))
            sum += world.solids[0].positions[i].x() - world.solids[0].rest.vertices[i].x();
        return sum / 9;
    };
    const double exact = stretch(FlowTime::in_step, NodeIntegrator::explicit_step, 12800);
    std::vector<double> within, after;
    for (const int steps : {100, 200, 400}) {
        within.push_back(
            std::abs(stretch(FlowTime::in_step, NodeIntegrator::implicit_step, steps) - exact));
        after.push_back(
            std::abs(stretch(FlowTime::after_step, NodeIntegrator::implicit_step, steps) - exact));
    }
    CAPTURE(exact, within, after);
    check_order(within, 1);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(within[i] < 0.5 * after[i]);
    // There are 10 steps, each with as many substeps as stability needs.
    const double coarse = stretch(FlowTime::in_step, NodeIntegrator::explicit_step, 10);
    CHECK_THAT(coarse, IsClose(exact, Order(0.03 * exact)));
}

TEST_CASE("flow: where nothing yields it costs no solve and changes no bit", "[deformable]")
{
    for (const NodeIntegrator integrator : both_integrators) {
        Random random(5);
        Deformable bar = loaded_bar(random, 3).bar;
        bar.integrator = integrator;
        bar.material.yield_stress = 1e12;
        DeformableWorld plastic = world_of(bar);
        bar.material.yield_stress = never;
        DeformableWorld elastic = world_of(bar);
        run(plastic, 0.01, 5);
        run(elastic, 0.01, 5);
        CHECK(plastic.solids[0].positions == elastic.solids[0].positions);
        CHECK(plastic.solids[0].velocities == elastic.solids[0].velocities);
        CHECK(plastic.rigid.counters.system_solves == elastic.rigid.counters.system_solves);
    }
}

TEST_CASE("flow: a free solid keeps its momentum while it flows", "[deformable]")
{
    for (const NodeIntegrator integrator : both_integrators) {
        CAPTURE(static_cast<int>(integrator));
        Random random(2);
        Deformable bar = loaded_bar(random, 0).bar;
        bar.handles.clear();
        bar.loads.clear();
        bar.material.drag = 0;
        bar.integrator = integrator;
        const double c = std::sqrt(bar.material.youngs_modulus / bar.material.density);
        const double v = 10 * c * bar.material.yield_stress / bar.material.youngs_modulus;
        for (std::size_t i = 0; i < bar.positions.size(); ++i)
            bar.velocities[i] = v * (Vector3d(0.3, 0.2, 0.1) + 0.5 * random.vector());
        DeformableWorld world = world_of(bar);
        const DeformableTotals before = totals(bar);
        run(world, 0.2 / c, 20);
        const DeformableTotals after = totals(world.solids[0]);
        CHECK(largest_flow(world.solids[0]) > 0);
        CHECK_THAT(after.momentum, IsClose(before.momentum, Rounding(1e4, before.mass * v)));
        CHECK(energy_of(world.solids[0]) < energy_of(bar));
    }
}

TEST_CASE("flow: the same solid in another frame flows alike", "[deformable]")
{
    Random random(11);
    const Loaded loaded = loaded_bar(random, 0);
    const Matrix3d R = random.rotation();
    Deformable turned = loaded.bar;
    for (std::size_t i = 0; i < turned.positions.size(); ++i)
        turned.positions[i] = R * turned.positions[i];
    turned.loads[0].force = R * turned.loads[0].force;
    DeformableWorld one = world_of(loaded.bar), two = world_of(turned);
    const double h = 0.2 / loaded.c;
    run(one, h, 20);
    run(two, h, 20);
    CHECK(largest_flow(one.solids[0]) > 0);
    for (std::size_t i = 0; i < turned.positions.size(); ++i)
        CHECK_THAT(two.solids[0].positions[i],
                   IsClose((R * one.solids[0].positions[i]).eval(), Order(1e-6)));
}
