// SPDX-License-Identifier: MIT
// Accuracy of deformable solids. Stresses are compared with the patch test and with perfect
// plasticity, displacements with a bar that hangs under its weight, for the order of convergence in
// space. A bar that vibrates gives error against run time, for both integrators.
#include "deformable/elasticity/element.hpp"
#include "deformable/elasticity/elements.hpp"
#include "parts.hpp"
#include "support/bench/plot.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

using testing::end_nodes;
using testing::Random;
using testing::soft_material;
using testing::solid_of;
using testing::world_of;

namespace {

// The patch test: an affine deformation has the same stress in all elements. The largest relative
// difference of any element's stress from that of the first.
double patch_error()
{
    double error = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        Random random(seed);
        Deformable solid = solid_of(testing::random_mesh(random), soft_material());
        Matrix3d F;
        F << random.vector(), random.vector(), random.vector();
        F = random.rotation() * (Matrix3d::Identity() + 0.2 * F);
        for (std::size_t i = 0; i < solid.positions.size(); ++i)
            solid.positions[i] = F * solid.rest.vertices[i];
        const auto stresses = element_stresses(solid);
        for (const Matrix3d& stress : stresses)
            error = std::max(error, (stress - stresses[0]).norm() / stresses[0].norm());
    }
    return error;
}

// One cell of a solid that yields at 1 % is stretched to `strain` between two handles, with the
// same strain everywhere. The error of its axial stress against perfect plasticity, over the yield
// stress.
double material_point_error(double strain)
{
    SolidMaterial material = soft_material();
    material.yield_stress = 0.01 * material.youngs_modulus;
    Deformable cell = solid_of(block_tetrahedra({1, 1, 1}, {1, 1, 1}), material);
    Handle handle;
    handle.nodes = end_nodes(cell, -1);
    cell.handles.push_back(handle);
    handle.nodes = end_nodes(cell, 1);
    handle.path = {{0, Vector3d::Zero(), Vector3d::Zero()},
                   {1, Vector3d(strain, 0, 0), Vector3d::Zero()}};
    cell.handles.push_back(handle);
    DeformableWorld world = world_of(cell);
    for (int i = 0; i < 50; ++i)
        step(world, 0.02);
    // σ_x = (K + 4/3 G) ε before it yields, K ε + ⅔ σ_Y afterwards
    const double G = material.shear_modulus(), K = material.lame_lambda() + 2 * G / 3;
    const double expected =
        K * strain + std::min(4.0 / 3 * G * strain, 2.0 / 3 * material.yield_stress);
    double error = 0;
    for (const Matrix3d& stress : element_stresses(world.solids[0]))
        error = std::max(error, std::abs(stress(0, 0) - expected) / material.yield_stress);
    return error;
}

Deformable held_bar(int cells)
{
    SolidMaterial material = soft_material();
    material.poisson_ratio = 0;
    Deformable bar =
        solid_of(block_tetrahedra({1, 0.25, 0.25}, {4 * cells, cells, cells}), material);
    Handle handle;
    handle.nodes = end_nodes(bar, -1);
    bar.handles.push_back(handle);
    return bar;
}

// The root mean square error over the volume of a bar that hangs, against u = ρ g (L s - ½ s²)/E,
// over the elongation of the whole bar.
double hanging_error(int cells)
{
    DeformableWorld world = world_of(held_bar(cells));
    world.rigid.settings.gravity = {1e-3, 0, 0};
    for (int i = 0; i < 12; ++i)
        step(world, 100);
    const Deformable& bar = world.solids[0];
    const double c = bar.material.density * 1e-3 / bar.material.youngs_modulus;
    double sum = 0, volume = 0;
    for (int t = 0; t < static_cast<int>(bar.rest.tetrahedra.size()); ++t) {
        double u = 0, s = 0.5; // at the center of the element
        for (const int v : bar.rest.tetrahedra[t]) {
            u += (bar.positions[v].x() - bar.rest.vertices[v].x()) / 4;
            s += bar.rest.vertices[v].x() / 4;
        }
        const double V = tetrahedron_volume(bar.rest, t);
        sum += V * std::pow(u - c * (s - s * s / 2), 2);
        volume += V;
    }
    return std::sqrt(sum / volume) / (c / 2);
}

// A bar that vibrates along its length in its first mode, u = A sin(½π s) sin(ω t), for 1¼ periods.
struct Ringing {
    double seconds = 0, error = 0; // run time [s]; error at the free end, over A
    std::uint64_t substeps = 0;
};

Ringing ring(NodeIntegrator integrator, int steps)
{
    constexpr double A = 1e-4;
    SolidMaterial material = soft_material();
    material.poisson_ratio = 0;
    Deformable bar = solid_of(block_tetrahedra({1, 0.03125, 0.03125}, {32, 1, 1}), material);
    bar.integrator = integrator;
    Handle handle;
    handle.nodes = end_nodes(bar, -1);
    bar.handles.push_back(handle);
    const double omega =
        0.5 * std::numbers::pi * std::sqrt(material.youngs_modulus / material.density);
    for (std::size_t i = 0; i < bar.positions.size(); ++i)
        bar.velocities[i].x() =
            A * omega * std::sin(0.5 * std::numbers::pi * (bar.positions[i].x() + 0.5));
    const int tip = end_nodes(bar, 1)[0];
    const double T = 1.25 * 2 * std::numbers::pi / omega; // the elongation at the tip is largest
    DeformableWorld world = world_of(bar);
    const double start = thread_seconds();
    for (int i = 0; i < steps; ++i)
        step(world, T / steps);
    const double u = world.solids[0].positions[tip].x() - 0.5;
    return {thread_seconds() - start, std::abs(u - A) / A,
            world.rigid.counters.deformable_substeps};
}

} // namespace

void measure_accuracy(Bench& bench, const std::string& folder)
{
    bench.reach({"patch test: difference of stresses", patch_error(), 1e-12});
    bench.reach({"material point, elastic: error", material_point_error(0.005), 1e-12});
    bench.reach({"material point, yielding: error", material_point_error(0.5), 1e-12});

    double coarse = 0;
    for (const int cells : {1, 2, 4}) {
        const double error = hanging_error(cells);
        bench.row({{"bar that hangs, cells", cells * 4.0},
                   {"error", error},
                   {"order", coarse > 0 ? std::log2(coarse / error) : 0.0}});
        if (cells == 4)
            bench.reach(
                {"bar that hangs: order of the error", std::log2(coarse / error), 1.8, "higher"});
        coarse = error;
    }

    Plot plot{
        "A bar that rings", "run time [s]", "error at the tip, over the amplitude", {}, 1e-17};
    for (const auto& [name, integrator] : {std::pair("explicit", NodeIntegrator::explicit_step),
                                           std::pair("implicit", NodeIntegrator::implicit_step)}) {
        Series series{name, {}, false};
        for (const int steps : {20, 40, 80, 160, 320, 640, 1280}) {
            const Ringing r = ring(integrator, steps);
            series.points.emplace_back(r.seconds, r.error);
            bench.row({{"bar that rings", name},
                       {"steps", static_cast<double>(steps)},
                       {"substeps", static_cast<double>(r.substeps)},
                       {"run time [ms]", 1e3 * r.seconds},
                       {"error", r.error}});
        }
        plot.series.push_back(series);
    }
    if (!folder.empty()) write_plot(plot, folder + "/deformable_ringing.svg");
}

} // namespace rigor
