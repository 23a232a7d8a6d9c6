// SPDX-License-Identifier: MIT
#include "deformable/elasticity/element.hpp"
#include "deformable/motion/stable_step.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr std::array integrators = {NodeIntegrator::explicit_step, NodeIntegrator::implicit_step};

Deformable tumbling(NodeIntegrator integrator)
{
    Random random(7);
    Deformable solid = solid_of(random_mesh(random), soft_material());
    solid.integrator = integrator;
    for (std::size_t i = 0; i < solid.positions.size(); ++i)
        solid.velocities[i] = Vector3d(1, 2, 3) + Vector3d(1, -1, 2).cross(solid.positions[i]) +
                              0.5 * random.vector();
    return solid;
}

double energy(const Deformable& solid)
{
    const DeformableTotals sum = totals(solid);
    return sum.kinetic_energy + sum.elastic_energy;
}

// A bar along x, held at the end with the lower x.
Deformable held_bar(int cells, double poisson_ratio, int length = 4)
{
    SolidMaterial material = soft_material();
    material.poisson_ratio = poisson_ratio;
    Deformable bar =
        solid_of(block_tetrahedra({1, 0.25, 0.25}, {length * cells, cells, cells}), material);
    Handle handle;
    handle.nodes = end_nodes(bar, -1);
    bar.handles.push_back(handle);
    return bar;
}

double least_volume(const Deformable& solid)
{
    double least = never;
    for (const auto& [a, b, c, d] : solid.rest.tetrahedra) {
        const auto& x = solid.positions;
        least = std::min(least, tetrahedron_volume(x[a], x[b], x[c], x[d]));
    }
    return least;
}

} // namespace

TEST_CASE("motion: explicit steps keep both momenta to rounding and the energy nearly",
          "[deformable]")
{
    DeformableWorld world = world_of(tumbling(NodeIntegrator::explicit_step));
    const DeformableTotals before = totals(world.solids[0]);
    const double E = energy(world.solids[0]);
    run(world, 0.1, 10);
    const DeformableTotals after = totals(world.solids[0]);
    CHECK_THAT(after.momentum, IsClose(before.momentum, Rounding(1000)));
    CHECK_THAT(after.angular_momentum,
               IsClose(before.angular_momentum, Rounding(2000, before.mass * 10)));
    CHECK_THAT(energy(world.solids[0]), IsClose(E, Order(0.01 * E)));
    CHECK(world.rigid.counters.deformable_substeps > 10);
}

TEST_CASE("motion: implicit steps keep the momentum to rounding and add no energy", "[deformable]")
{
    for (const double time_step : {0.01, 0.1, 10.0}) {
        CAPTURE(time_step);
        DeformableWorld world = world_of(tumbling(NodeIntegrator::implicit_step));
        const DeformableTotals before = totals(world.solids[0]);
        const double E = energy(world.solids[0]);
        run(world, time_step, 20);
        const DeformableTotals after = totals(world.solids[0]);
        // Forces between nodes add up to zero except for rounding. Its scale is an impulse: Young's
        // modulus times an area times the step.
        CHECK_THAT(after.momentum, IsClose(before.momentum, Rounding(200, 1e5 + time_step * 1e6)));
        if (time_step < 0.05) check_at_most(energy(world.solids[0]), E, "energy");
        for (const Vector3d& v : world.solids[0].velocities)
            REQUIRE(v.norm() < 100);
    }
}

// The solid starts without stress. Then there is no force in the first half step, and the method is
// that of Störmer and Verlet.
TEST_CASE("motion: the error of explicit steps falls with the square of the step", "[deformable]")
{
    std::vector<double> errors;
    for (const double time_step : {0.002, 0.001, 0.0005}) { // each is one substep
        DeformableWorld world = world_of(tumbling(NodeIntegrator::explicit_step));
        DeformableWorld fine = world;
        run(world, time_step, static_cast<int>(std::lround(0.04 / time_step)));
        run(fine, 0.00002, 2000);
        CHECK(world.rigid.counters.deformable_substeps ==
              static_cast<std::uint64_t>(std::lround(0.04 / time_step)));
        double error = 0;
        for (std::size_t i = 0; i < world.solids[0].positions.size(); ++i)
            error = std::max(error,
                             (world.solids[0].positions[i] - fine.solids[0].positions[i]).norm());
        errors.push_back(error);
    }
    check_order(errors, 2);
}

TEST_CASE("motion: a bar that hangs by its end stretches as it should, to second order",
          "[deformable]")
{
    std::vector<double> errors;
    for (const int cells : {1, 2, 4}) {
        DeformableWorld world = world_of(held_bar(cells, 0));
        world.rigid.settings.gravity = {1e-3, 0, 0};
        run(world, 100, 12);
        const Deformable& bar = world.solids[0];
        const double c = bar.material.density * 1e-3 / bar.material.youngs_modulus, L = 1;
        double sum = 0, volume = 0;
        for (int t = 0; t < static_cast<int>(bar.rest.tetrahedra.size()); ++t) {
            double u = 0, s = 0.5; // at the middle of the element, s from the held end
            for (const int v : bar.rest.tetrahedra[t]) {
                u += (bar.positions[v].x() - bar.rest.vertices[v].x()) / 4;
                s += bar.rest.vertices[v].x() / 4;
            }
            const double V = tetrahedron_volume(bar.rest, t);
            sum += V * std::pow(u - c * (L * s - s * s / 2), 2); // u = ρ g (L s - ½ s²) / E
            volume += V;
        }
        errors.push_back(std::sqrt(sum / volume) / (c * L * L / 2));
    }
    CHECK(errors[0] < 0.05);
    check_order(errors, 2);
}

TEST_CASE("motion: explicit steps are stable up to their limit and not far beyond", "[deformable]")
{
    for (unsigned seed = 0; seed < 3; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Deformable solid = solid_of(random_mesh(random), soft_material());
        const Elements elements(solid);
        const double limit = stable_step(solid, elements);
        const auto growth = [&](double h) {
            Deformable s = solid;
            for (Vector3d& v : s.velocities)
                v = 1e-6 * random.vector();
            const double E = energy(s);
            for (int k = 0; k < 2000 && energy(s) < 1e6 * E; ++k) {
                std::vector<Vector3d> f(s.positions.size(), Vector3d::Zero());
                elements.add_forces(s.positions, s.velocities, f);
                for (std::size_t i = 0; i < f.size(); ++i) {
                    s.velocities[i] += h / s.masses[i] * f[i];
                    s.positions[i] += h * s.velocities[i];
                }
            }
            return energy(s) / E;
        };
        CHECK(growth(limit) < 100);
        CHECK(!(growth(1.5 * limit) < 1e4));
    }
}

TEST_CASE("motion: a step that would take explicit substeps without end is refused", "[deformable]")
{
    DeformableWorld world = world_of(tumbling(NodeIntegrator::explicit_step));
    for (const double time_step : {1e6, 1e12}) { // too many substeps, and more than an int holds
        CAPTURE(time_step);
        REQUIRE_THROWS_AS(step(world, time_step), std::domain_error);
    }
}

TEST_CASE("motion: implicit steps of any length come to rest", "[deformable]")
{
    for (const double time_step : {0.2, 1.0, 1000.0}) {
        CAPTURE(time_step);
        DeformableWorld world = world_of(held_bar(2, 0.3));
        Random random(3);
        for (Vector3d& v : world.solids[0].velocities)
            v = 10 * random.vector();
        world.rigid.settings.gravity = {0, -1, 0};
        run(world, time_step, 400);
        const DeformableTotals sum = totals(world.solids[0]);
        check_at_most(sum.kinetic_energy, 1e-6, "kinetic energy");
        CHECK(sum.elastic_energy > 0);
        check_at_most(0, least_volume(world.solids[0]), "least volume");
    }
}

TEST_CASE("motion: a tetrahedron that is inside out turns back", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators)
        for (unsigned seed = 0; seed < 10; ++seed) {
            CAPTURE(seed);
            Random random(seed);
            TetrahedralMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
            Deformable solid = solid_of(mesh, soft_material());
            solid.integrator = integrator;
            solid.material.damping = 0.01;
            for (Vector3d& x : solid.positions)
                x += 0.05 * random.vector();
            solid.positions[3].z() = -random.uniform(0.2, 2);
            DeformableWorld world = world_of(solid);
            run(world, 0.02, 500);
            CHECK(least_volume(world.solids[0]) > 0.15);
            // A little elastic energy may be left, since a spin stretches the tetrahedron.
            check_at_most(totals(world.solids[0]).elastic_energy,
                          0.01 * totals(solid).elastic_energy, "elastic energy");
        }
}

TEST_CASE("motion: what can hardly be compressed keeps its volume", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators) {
        DeformableWorld world = world_of(held_bar(2, 0.499));
        world.solids[0].integrator = integrator;
        world.solids[0].material.damping = 1e-3;
        world.rigid.settings.gravity = {2, 0, 0};
        run(world, 0.01, 100);
        const Deformable& bar = world.solids[0];
        double volume = 0;
        for (const auto& [a, b, c, d] : bar.rest.tetrahedra)
            volume += tetrahedron_volume(bar.positions[a], bar.positions[b], bar.positions[c],
                                         bar.positions[d]);
        CHECK_THAT(volume, IsClose(totals(bar).volume, Order(1e-3 * totals(bar).volume)));
        CHECK(least_volume(bar) > 0);
    }
}

TEST_CASE("motion: no element bears more than it yields at, however fast it is pulled",
          "[deformable]")
{
    for (const NodeIntegrator integrator : integrators) {
        DeformableWorld world = world_of(held_bar(1, 0.3, 1));
        Deformable& bar = world.solids[0];
        bar.integrator = integrator;
        bar.material.yield_stress = 500; // at a strain of ½ %
        Handle pull;
        for (int i = 0; i < static_cast<int>(bar.positions.size()); ++i)
            if (bar.positions[i].x() > 0.5 - 1e-9) pull.nodes.push_back(i);
        // This is a hundred times that strain in one step.
        pull.path = {{0, Vector3d::Zero(), Vector3d::Zero()},
                     {0.02, Vector3d(0.5, 0, 0), Vector3d::Zero()}};
        bar.handles.push_back(pull);
        step(world, 0.02);
        for (const Matrix3d& stress : element_stresses(bar)) {
            Matrix3d dev = stress;
            dev.diagonal().array() -= stress.trace() / 3;
            check_at_most(std::sqrt(1.5) * dev.norm(), 500 * (1 + 1e-9), "von Mises stress");
        }
        CHECK(world.rigid.counters.elements_flowed > 0);
        double most = 0;
        for (const Matrix3d& strain : bar.plastic_strains) {
            CHECK_THAT(strain.trace(), IsClose(0.0, Rounding(100, 1)));
            most = std::max(most, strain.norm());
        }
        CHECK(most > 0.3);
        run(world, 0.02, 100);
        CHECK(energy(bar) < 1e4);
    }
}

TEST_CASE("motion: the same world gives the same bits", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators) {
        DeformableWorld one = world_of(tumbling(integrator));
        run(one, 0.01, 3);
        DeformableWorld two = one; // it starts without a workspace
        run(one, 0.01, 3);
        run(two, 0.01, 3);
        CHECK(one.solids[0].positions == two.solids[0].positions);
        CHECK(one.solids[0].velocities == two.solids[0].velocities);
    }
}

TEST_CASE("motion: where handles overlap the last one counts, axis by axis", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators) {
        DeformableWorld world = world_of(held_bar(1, 0.3));
        Deformable& bar = world.solids[0];
        bar.integrator = integrator;
        const std::vector<Vector3d> first = bar.positions;
        const auto path_to = [](const Vector3d& end) -> std::vector<HandleMoment> {
            return {{0, Vector3d::Zero(), Vector3d::Zero()}, {0.1, end, Vector3d::Zero()}};
        };
        Handle second = bar.handles[0], third = second;
        bar.handles[0].path = path_to({0.01, 0.02, 0.03});
        second.axes = {true, true, false};
        second.path = path_to({-0.02, 0.04, 1});
        third.axes = {false, true, false};
        third.path = path_to({1, -0.03, 1});
        bar.handles.push_back(second);
        bar.handles.push_back(third);
        run(world, 0.01, 5);
        for (const int node : second.nodes)
            CHECK_THAT(bar.positions[node],
                       IsClose(first[node] + Vector3d(-0.01, -0.015, 0.015), Rounding(100, 1)));
    }
}

TEST_CASE("motion: handles lead their nodes and let go", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators) {
        DeformableWorld world = world_of(held_bar(1, 0.3));
        Deformable& bar = world.solids[0];
        bar.integrator = integrator;
        bar.handles[0].path = {{0, Vector3d::Zero(), Vector3d::Zero()},
                               {1, Vector3d(0, 2, 0), Vector3d(0, 0, 1)}};
        bar.handles[0].release = 1.5;
        const int node = bar.handles[0].nodes[0];
        const Vector3d first = bar.positions[node];
        run(world, 0.025, 20);
        const Eigen::AngleAxisd half(0.5, Vector3d::UnitZ());
        CHECK_THAT(bar.positions[node],
                   IsClose((half * first + Vector3d(0, 1, 0)).eval(), Rounding(64)));
        run(world, 0.025, 40);
        world.rigid.settings.gravity = {0, -10, 0};
        run(world, 0.025, 20);
        CHECK(bar.positions[node].y() < first.y() + 1.5);
    }
}
