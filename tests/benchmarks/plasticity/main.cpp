// SPDX-License-Identifier: MIT
// A piece of steel under cyclic strain: the error against exact solutions for different numbers of
// steps, the time of a step, and the plot of the hysteresis loops.
#include "formulas/plasticity.hpp"
#include "support/bench/bench.hpp"
#include "support/bench/plot.hpp"

#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>

using namespace rigor;

namespace {

// Young's modulus, Poisson's ratio and yield stress of a steel [Pa, 1, Pa].
constexpr double E = 200e9, nu = 0.3, sigma_Y = 250e6;
constexpr double G = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));

Matrix3d diagonal(double x, double y, double z)
{
    return Vector3d(x, y, z).asDiagonal();
}

Matrix3d shear(double e)
{
    Matrix3d strain = Matrix3d::Zero();
    strain(0, 1) = strain(1, 0) = e;
    return strain;
}

struct MaterialPoint {
    Matrix3d strain = Matrix3d::Zero(), plastic_strain = Matrix3d::Zero(),
             stress = Matrix3d::Zero();
    double dissipation = 0; // [J/m³]

    void step(const Matrix3d& new_strain)
    {
        strain = new_strain;
        const Matrix3d trial = isotropic_stress(strain - plastic_strain, lambda, G);
        const Matrix3d flown = plastic_flow(plastic_strain, trial, sigma_Y, G);
        stress = isotropic_stress(strain - flown, lambda, G);
        dissipation += stress.cwiseProduct(flown - plastic_strain).sum();
        plastic_strain = flown;
    }

    void strain_to(const Matrix3d& target, int n)
    {
        const Matrix3d start = strain;
        for (int i = 1; i <= n; ++i)
            step(start + (target - start) * i / n);
    }
};

// A bar that is stretched to the strain e and may become thinner. Bisection finds the transverse
// strain that leaves no transverse stress.
MaterialPoint stretched(const MaterialPoint& bar, double e)
{
    double low = bar.strain(1, 1) - 0.01, high = bar.strain(1, 1) + 0.01;
    MaterialPoint result = bar;
    for (int i = 0; i < 60; ++i) {
        const double across = (low + high) / 2;
        result = bar;
        result.step(diagonal(e, across, across));
        (result.stress(1, 1) > 0 ? high : low) = across;
    }
    return result;
}

// Stretches the steel to 0.5 % and back, with its width held.
void measure(Bench& bench)
{
    double worst = 0;
    for (const int n : {1, 10, 100, 1000, 10000}) {
        MaterialPoint point;
        const double time = seconds([&] {
            point.strain_to(diagonal(0.005, 0, 0), n);
            point.strain_to(Matrix3d::Zero(), n);
        });
        const Matrix3d exact = diagonal(-500e6 / 3, 250e6 / 3, 250e6 / 3);
        const double error = (point.stress - exact).norm() / exact.norm(),
                     heat = std::abs(point.dissipation / (2562500 / 3.0) - 1);
        worst = std::max({worst, error, heat});
        bench.row({{"steps each way", static_cast<double>(n)},
                   {"error of the stress", error},
                   {"error of the heat", heat},
                   {"time of a step [ns]", time / (2.0 * n) * 1e9}});
    }
    bench.reach({"worst error after any number of steps", worst, 1e-10, "lower"});
    bench.note("A steel stretched by 0.5 % with its width held, and back: −166.67 and 83.33 MPa "
               "and 854166.67 J/m³ remain.");
    bench.note("Errors are relative to these. A step is two stresses and one flow.");
}

Series loop(const std::string& name, bool is_dashed, double last, double scale,
            const std::function<double(double)>& stress_at)
{
    Series series = {name, {{0, 0}}, is_dashed};
    double start = 0;
    for (const double target : {last, -last, last}) {
        constexpr int n = 200;
        for (int i = 1; i <= n; ++i) {
            const double e = start + (target - start) * i / n;
            series.points.emplace_back(e * scale * 100, stress_at(e) / 1e6);
        }
        start = target;
    }
    return series;
}

Plot loops()
{
    Plot plot;
    plot.title = "Steel, strained back and forth";
    plot.x_label = "strain [%]: stretch, or angle of shear";
    plot.y_label = "stress [MPa]";
    plot.is_linear = true;
    MaterialPoint held, bar, sheared;
    plot.series = {loop("stretched, width held", false, 0.005, 1,
                        [&](double e) {
                            held.step(diagonal(e, 0, 0));
                            return held.stress(0, 0);
                        }),
                   loop("stretched, width free", false, 0.005, 1,
                        [&](double e) {
                            bar = stretched(bar, e);
                            return bar.stress(0, 0);
                        }),
                   loop("sheared", true, 0.0025, 2, [&](double e) {
                       sheared.step(shear(e));
                       return sheared.stress(0, 1);
                   })};
    return plot;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        Bench bench("plasticity");
        measure(bench);
        const std::string folder = plot_folder(argc, argv);
        if (!folder.empty()) {
            write_plot(loops(), folder + "/hysteresis.svg");
            bench.note(folder + "/hysteresis.svg: the loops.");
        }
        return bench.finish(wants_json(argc, argv));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_plasticity: %s\n", error.what());
        return 2;
    }
}
