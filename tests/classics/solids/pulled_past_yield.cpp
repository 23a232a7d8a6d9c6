// SPDX-License-Identifier: MIT
// A weight at the end of a neck is pulled with λ F_Y, where F_Y makes the neck yield. The neck is a
// spring of stiffness k until it yields (an oscillator, x = λ F_Y/k (1 - cos ωt), ω = √(k/m)); from
// then on it holds back with F_Y alone, so that the weight speeds up by (λ - 1) F_Y/m. Let go, it
// stops after m v²/(2 F_Y), springs back by F_Y/k and keeps the rest (Newmark 1959, "A method of
// computation for structural dynamics"; Hill 1950, "The mathematical theory of plasticity").
#include "classics/problems.hpp"
#include "deformable/elasticity/element.hpp"
#include "deformable/elasticity/elements.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace pulled_past_yield {

namespace {

struct Neck {
    bool is_sheared = true; // or pulled along its length
    double lambda = 1.2, sigma_Y = 1, E = 1e7, nu = 0.3;
    int cells = 2; // across
    double length = 0.25, width = 0.25;
    double weight = 16;    // the mass at its end [kg]
    double let_go = never; // [s]
    NodeIntegrator integrator = NodeIntegrator::implicit_step;

    int axis() const { return is_sheared ? 1 : 0; }
    double area() const { return width * width; }
    double F_Y() const { return area() * (is_sheared ? sigma_Y / std::sqrt(3) : sigma_Y); }
    double k() const { return area() * (is_sheared ? E / (2 * (1 + nu)) : E) / length; }
    double omega() const { return std::sqrt(k() / weight); }
    double yields_at() const { return std::acos(1 - 1 / lambda) / omega(); } // [s]
    double velocity(double t) const                                          // while it is pulled
    {
        const double t_Y = std::min(t, yields_at());
        return lambda * F_Y() / k() * omega() * std::sin(omega() * t_Y) +
               (lambda - 1) * F_Y() / weight * (t - t_Y);
    }
    double place(double t) const
    {
        const double t_Y = std::min(t, yields_at());
        return lambda * F_Y() / k() * (1 - std::cos(omega() * t_Y)) + velocity(t_Y) * (t - t_Y) +
               (lambda - 1) * F_Y() / (2 * weight) * (t - t_Y) * (t - t_Y);
    }
};

// The weight and the pull are shared among the nodes at the end as an even stress is, so that the
// neck is strained evenly on any mesh.
DeformableWorld world_of_neck(const Neck& neck)
{
    SolidMaterial material;
    material.youngs_modulus = neck.E;
    material.poisson_ratio = neck.nu;
    material.yield_stress = neck.sigma_Y;
    const double a = neck.width;
    Deformable solid =
        solid_of(block_tetrahedra({neck.length, a, a}, {1, neck.cells, neck.cells}), material);
    solid.integrator = neck.integrator;
    Handle wall, guide;
    wall.nodes = end_nodes(solid, -1);
    wall.axes = {true, neck.is_sheared, neck.is_sheared};
    guide.nodes = neck.is_sheared ? end_nodes(solid, 1) : std::vector<int>{};
    guide.axes = {true, false, true}; // sheared, it stays as long and as wide
    for (const int i : wall.nodes)
        if (!neck.is_sheared && solid.rest.vertices[i].tail<2>().isZero(1e-9))
            guide.nodes.push_back(i); // pulled, it gets thinner about its center line
    if (!neck.is_sheared) guide.axes = {true, true, true};
    solid.handles = {wall, guide};
    std::vector<double> shares(solid.positions.size(), 0.0); // Σ V ∂N/∂x over the area
    const Elements elements(solid);
    for (int e = 0; e < elements.size(); ++e)
        for (int i = 0; i < 4; ++i)
            shares[elements.nodes(e)[i]] +=
                elements.volume(e) * elements.gradients(e)[i].x() / neck.area();
    for (const int i : end_nodes(solid, 1)) {
        solid.masses[i] = shares[i] * neck.weight;
        Vector3d force = Vector3d::Zero();
        force[neck.axis()] = shares[i] * neck.lambda * neck.F_Y();
        solid.loads.push_back({{i}, force, 0, neck.let_go});
    }
    return world_of(std::move(solid));
}

double mean_at_end(const Deformable& solid, const std::vector<Vector3d>& values, int axis)
{
    double sum = 0;
    const std::vector<int> end = end_nodes(solid, 1);
    for (const int i : end)
        sum += values[i][axis];
    return sum / static_cast<double>(end.size());
}

double speed(const DeformableWorld& world, const Neck& neck)
{
    return mean_at_end(world.solids[0], world.solids[0].velocities, neck.axis());
}

double moved(const DeformableWorld& world, const Neck& neck)
{
    const Deformable& solid = world.solids[0];
    return mean_at_end(solid, solid.positions, neck.axis()) -
           mean_at_end(solid, solid.rest.vertices, neck.axis());
}

// Σ V σ : Δε_p with the stress at the end of the step [J]
double work_of_flow(const Deformable& before, const Deformable& after)
{
    double sum = 0;
    for (int e = 0; e < static_cast<int>(after.plastic_strains.size()); ++e)
        sum += tetrahedron_volume(after.rest, e) *
               stress_of(after, e)
                   .cwiseProduct(after.plastic_strains[e] - before.plastic_strains[e])
                   .sum();
    return sum;
}

void run_for(DeformableWorld& world, double time, double h)
{
    run(world, h, static_cast<int>(std::lround(time / h)));
}

constexpr std::array integrators = {NodeIntegrator::implicit_step, NodeIntegrator::explicit_step};

} // namespace

TEST_CASE("classics: what is pulled harder than its neck bears speeds up by the rest", "[classics]")
{
    for (const NodeIntegrator integrator : integrators)
        for (const bool is_sheared : {true, false})
            for (const double lambda : {1.05, 1.2, 2.0, 3.0})
                for (const double h : {0.01, 0.001}) {
                    CAPTURE(static_cast<int>(integrator), is_sheared, lambda, h);
                    Neck neck;
                    neck.is_sheared = is_sheared;
                    neck.lambda = lambda;
                    neck.integrator = integrator;
                    if (!is_sheared) neck.weight = 250, neck.length = 4;
                    DeformableWorld world = world_of_neck(neck);
                    run_for(world, 0.08, h); // it has yielded
                    const double before = speed(world, neck);
                    run_for(world, 0.02, h);
                    const double exact = (lambda - 1) * neck.F_Y() / neck.weight;
                    CHECK_THAT((speed(world, neck) - before) / 0.02,
                               IsClose(exact, Order(is_sheared ? 1e-5 * exact : 1e-2 * exact)));
                }
}

TEST_CASE("classics: flow under a pull converges with the first power of the step", "[classics]")
{
    for (const NodeIntegrator integrator : integrators) {
        CAPTURE(static_cast<int>(integrator));
        Neck neck;
        neck.integrator = integrator;
        const double t_Y = neck.yields_at(), T = 4 * t_Y;
        std::vector<double> speeds, places;
        for (const int n : {200, 400, 800}) {
            DeformableWorld world = world_of_neck(neck);
            run_for(world, T, T / n);
            speeds.push_back(std::abs(speed(world, neck) / neck.velocity(T) - 1));
            places.push_back(std::abs(moved(world, neck) / neck.place(T) - 1));
        }
        CAPTURE(speeds, places);
        check_order(places, 1);
        check_at_most(places[2], 0.003, "error of the place");
        check_order(speeds, integrator == NodeIntegrator::implicit_step ? 1 : 2);
        check_at_most(speeds[2], 0.003, "error of the speed");
    }
}

TEST_CASE("classics: a neck keeps what it flowed while its weight was pulled and stopped",
          "[classics]")
{
    for (const NodeIntegrator integrator : integrators) {
        CAPTURE(static_cast<int>(integrator));
        Neck neck;
        neck.integrator = integrator;
        neck.let_go = 2 * neck.yields_at();
        const double v = neck.velocity(neck.let_go), x = neck.place(neck.let_go), F_Y = neck.F_Y(),
                     stops = v * neck.weight / F_Y, T = neck.let_go + 2 * stops;
        const double keeps = x + neck.weight * v * v / (2 * F_Y) - F_Y / neck.k();
        std::vector<double> kept, heat;
        for (const int n : {100, 200, 400}) {
            const double h = neck.let_go / n;
            DeformableWorld world = world_of_neck(neck);
            for (NodeLoad& load : world.solids[0].loads)
                load.end -= h / 2; // so that rounding does not decide whether it acts a step longer
            double work = 0, flow_work = 0;
            for (int i = 0; i * h < T; ++i) {
                const Deformable before = world.solids[0];
                step(world, h);
                const Deformable& after = world.solids[0];
                if (i < n)
                    work += neck.lambda * F_Y *
                            (mean_at_end(after, after.positions, 1) -
                             mean_at_end(before, before.positions, 1));
                flow_work += work_of_flow(before, after);
                if (integrator != NodeIntegrator::implicit_step) continue;
                const DeformableTotals sum = totals(after); // what is left is heat, or lost
                REQUIRE(sum.kinetic_energy + sum.elastic_energy + flow_work <=
                        work + 1e-6 * F_Y * keeps);
            }
            double strain = 0; // the mean ε_p of all elements, which are equally large
            for (const Matrix3d& e : world.solids[0].plastic_strains)
                strain += e(0, 1) / static_cast<double>(world.solids[0].plastic_strains.size());
            kept.push_back(std::abs(2 * strain * neck.length / keeps - 1));
            heat.push_back(std::abs(flow_work / (F_Y * keeps) - 1));
        }
        CAPTURE(kept, heat);
        check_order(kept, integrator == NodeIntegrator::implicit_step ? 1 : 2);
        check_at_most(kept[2], 0.01, "error of what it keeps");
        check_at_most(heat[2], 0.01, "error of the work of the flow");
    }
}

TEST_CASE("classics: the loop of a neck sheared to and fro is the same in any number of steps",
          "[classics]")
{
    for (const NodeIntegrator integrator : integrators)
        for (const int n : {1, 7, 100}) {
            CAPTURE(static_cast<int>(integrator), n);
            Neck neck;
            neck.integrator = integrator;
            DeformableWorld world = world_of_neck(neck);
            Deformable& solid = world.solids[0];
            solid.loads.clear();
            const double x_Y = neck.F_Y() / neck.k(), x = 5 * x_Y;
            Handle lead;
            lead.nodes = end_nodes(solid, 1);
            for (int i = 0; i <= 5; ++i) // to x, and twice to -x and back
                lead.path.push_back({1.0 * i,
                                     Vector3d(0,
                                              i == 0       ? 0
                                              : i % 2 == 1 ? x
                                                           : -x,
                                              0),
                                     Vector3d::Zero()});
            solid.handles[1] = lead;
            double work = 0;
            for (int i = 0; i < 5 * n; ++i) {
                const Deformable before = world.solids[0];
                step(world, 1.0 / n);
                if (i >= n) work += work_of_flow(before, world.solids[0]);
            }
            // two rounds of a parallelogram of height 2 F_Y and length 2 (x - x_Y)
            const double exact = 2 * 4 * neck.F_Y() * (x - x_Y);
            CHECK_THAT(work, IsClose(exact, Order(1e-5 * exact)));
            for (const Matrix3d& e : world.solids[0].plastic_strains)
                CHECK_THAT(2 * e(0, 1) * neck.length, IsClose(x - x_Y, Order(1e-5 * x)));
        }
}

} // namespace pulled_past_yield
