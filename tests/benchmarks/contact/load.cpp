// SPDX-License-Identifier: MIT
// Cubes on top of each other: a heavy cube on a light one, and stacks.
#include "parts.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

constexpr double perturbation = 1e-4; // [m]

// Runs a trial of cubes to the end.
// @return the figures at the end, but the penetration is the largest of all steps
StackFigures run(const Contestant& contestant, const Trial& trial)
{
    const std::unique_ptr<TrialEngine> engine = contestant.start(trial);
    const long steps = std::lround(contact_end / contact_step);
    StackFigures figures;
    double deepest = 0;
    for (long i = 0; i < steps; ++i) {
        engine->step(contact_step);
        figures = stack_figures(trial, *engine);
        deepest = std::max(deepest, figures.penetration);
        if (!figures.standing) break; // a fallen stack is measured no further
    }
    figures.penetration = deepest;
    return figures;
}

} // namespace

void measure_heavy_on_light(Bench& bench, const std::vector<Contestant>& all)
{
    for (const Contestant& contestant : all) {
        double worst = 0;
        for (double ratio : {1., 10., 100., 1e3, 1e4}) {
            Trial trial = cube_stack(2);
            trial.bodies[1].mass *= ratio;
            trial.bodies[1].inertia *= ratio;
            const StackFigures figures = run(contestant, trial);
            bench.row({{"heavy on light", contestant.name()},
                       {"ratio", ratio},
                       {"standing", figures.standing ? "yes" : "no"},
                       {"sinking [m]", figures.sinking},
                       {"drift [m]", figures.drift}});
            worst = std::max(worst, figures.standing ? figures.sinking : INFINITY);
        }
        if (contestant.is_ours())
            bench.reach({contestant.method + ": sinking of 1 to 10 000 kg on 1 kg [m]", worst, 1e-3,
                         "lower"});
    }
}

void measure_stacks(Bench& bench, const std::vector<Contestant>& all)
{
    for (const Contestant& contestant : all) {
        StackFigures worst;
        double tallest = 0;
        bool none_fell = true;
        for (int cubes : {5, 10, 20, 30, 50, 100})
            for (double spread : {0., perturbation}) {
                if (contestant.name() == "ode step" && cubes > 30) continue; // its cost is cubic
                const Trial trial = cube_stack(cubes, spread);
                StackFigures figures;
                const double time = seconds([&] { figures = run(contestant, trial); });
                bench.row({{"stacks", contestant.name()},
                           {"cubes", static_cast<double>(cubes)},
                           {"each off by up to [m]", spread},
                           {"standing", figures.standing ? "yes" : "no"},
                           {"drift [m]", figures.drift},
                           {"deepest penetration [m]", figures.penetration},
                           {"time [s]", time}});
                none_fell &= figures.standing;
                worst.drift = std::max(worst.drift, figures.drift);
                worst.penetration = std::max(worst.penetration, figures.penetration);
                if (none_fell && spread == perturbation) tallest = cubes;
            }
        if (!contestant.is_ours()) continue;
        bench.reach(
            {contestant.method + ": cubes of the tallest stack that stands, none lower falls",
             tallest, 100, "higher"});
        bench.reach({contestant.method + ": drift of stacks of 5 to 100 cubes [m]", worst.drift,
                     1e-2, "lower"});
        bench.reach({contestant.method + ": deepest penetration in them [m]", worst.penetration,
                     1e-3, "lower"});
    }
    bench.note(
        "Stacks: standing is every cube within half an edge of its place all the time; the drift "
        "is at the end, the penetration the deepest of all steps. A stack that falls ends there.");
}

} // namespace rigor
