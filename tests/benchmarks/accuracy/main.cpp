// SPDX-License-Identifier: MIT
// Error against run time on cases with exact solutions, for our integrators and contact methods,
// Bullet and ODE. Each contestant runs each case with many step sizes, on one thread. Then the
// errors at equal run time are compared, by interpolation between the measured points.
#include "cases.hpp"
#include "support/bench/bench.hpp"
#include "support/bench/plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <limits>
#include <optional>

using namespace rigor;

namespace {

constexpr int least_rounds = 3, most_rounds = 9;
constexpr double patience = 4; // a case starts no further round after this time [s]

// The processor time of this thread [s]. Other programs do not count.
double thread_seconds()
{
    timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Point run(const AccuracyCase& c, const Contestant& contestant, int steps)
{
    const std::unique_ptr<TrialEngine> engine = contestant.start(c.trial);
    std::vector<TrialMotion> path;
    if (c.needs_path) path.reserve(steps);
    const double h = c.end / steps;
    const double start = thread_seconds();
    for (int i = 0; i < steps; ++i) {
        engine->step(h);
        if (c.needs_path) path.push_back(engine->motion(0));
    }
    const double time = thread_seconds() - start;
    return {steps, time, c.error_of(*engine, path)};
}

// Measures all contestants in each round, so that a slow phase of the machine affects all of them.
std::vector<Curve> measure(const AccuracyCase& c)
{
    std::vector<Curve> curves;
    std::vector<std::vector<std::vector<double>>> times;
    for (const Contestant& contestant : c.contestants) {
        curves.push_back({contestant, {}});
        const std::size_t n = (contestant.is_ours() ? c.steps : c.peer_steps).size();
        curves.back().points.resize(n);
        times.emplace_back(n);
    }
    double spent = 0;
    for (int round = 0; round < most_rounds && (round < least_rounds || spent < patience); ++round)
        for (std::size_t k = 0; k < curves.size(); ++k) {
            const Contestant& contestant = curves[k].contestant;
            const std::vector<int>& steps = contestant.is_ours() ? c.steps : c.peer_steps;
            run(c, contestant, steps.front()); // not counted; it warms up the caches
            for (std::size_t i = 0; i < steps.size(); ++i) {
                Point& point = curves[k].points[i];
                point = run(c, contestant, steps[i]);
                spent += point.seconds;
                times[k][i].push_back(point.seconds);
                point.seconds = median(times[k][i]);
            }
        }
    return curves;
}

// The error that a curve reaches in a given time. Between two points the interpolation is linear in
// the logarithms; before the first and after the last point, the error is that of this point.
// Errors below machine precision count as machine precision.
double error_at(const std::vector<Point>& curve, double time)
{
    constexpr double least = std::numeric_limits<double>::epsilon();
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const Point &a = curve[i - 1], &b = curve[i];
        if (time > b.seconds || b.seconds <= a.seconds) continue;
        const double x = std::max(0., std::log(time / a.seconds) / std::log(b.seconds / a.seconds));
        return std::exp((1 - x) * std::log(std::max(a.error, least)) +
                        x * std::log(std::max(b.error, least)));
    }
    return std::max(curve.back().error, least);
}

const Point& best_of(const Curve& curve)
{
    return *std::min_element(curve.points.begin(), curve.points.end(),
                             [](const Point& a, const Point& b) { return a.error < b.error; });
}

// How many times smaller our error is than another engine's in the same run time.
struct Advantage {
    double at_best = std::numeric_limits<double>::infinity(); // at the other's best
    double least = std::numeric_limits<double>::infinity();   // once both have a result
};

Advantage advantage(const Curve& ours, const Curve& theirs)
{
    const auto ratio = [&](double time) {
        return error_at(theirs.points, time) / error_at(ours.points, time);
    };
    const double start = std::max(ours.points.front().seconds, theirs.points.front().seconds);
    Advantage result;
    for (const Curve* curve : {&ours, &theirs})
        for (const Point& point : curve->points)
            if (point.seconds >= start) result.least = std::min(result.least, ratio(point.seconds));
    const double best = best_of(theirs).seconds;
    result.at_best = best >= start ? ratio(best) : 0; // 0 if we have no result yet
    return result;
}

// The smallest advantage over any method of an engine; empty if the engine is not installed.
std::optional<Advantage> advantage_over(const std::string& engine, const Curve& ours,
                                        const std::vector<Curve>& curves)
{
    std::optional<Advantage> result;
    for (const Curve& curve : curves)
        if (curve.contestant.engine == engine) {
            const Advantage one = advantage(ours, curve), so_far = result.value_or(Advantage());
            result = {std::min(so_far.at_best, one.at_best), std::min(so_far.least, one.least)};
        }
    return result;
}

std::string three_digits(double value)
{
    if (value == 0) return "none";
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g", value);
    return buffer;
}

std::string shown(const Curve& ours, const std::string& engine, const std::vector<Curve>& curves)
{
    if (!ours.contestant.is_ours()) return {};
    const std::optional<Advantage> a = advantage_over(engine, ours, curves);
    return a ? three_digits(a->at_best) + " (" + three_digits(a->least) + ")" : "not installed";
}

void report(Bench& bench, const AccuracyCase& c, const std::vector<Curve>& curves)
{
    for (const Curve& curve : curves) {
        const Point& best = best_of(curve);
        bench.row({{"case", c.name},
                   {"engine", curve.contestant.engine},
                   {"method", curve.contestant.method},
                   {"smallest error", best.error},
                   {"step [s]", c.end / best.steps},
                   {"time [ms]", best.seconds * 1e3},
                   {"× Bullet", shown(curve, "bullet", curves)},
                   {"× ODE", shown(curve, "ode", curves)}});
    }
    for (const char* peer : {"bullet", "ode"})
        if (const std::optional<Advantage> a = advantage_over(peer, curves.front(), curves))
            bench.reach({c.name + ": accuracy of " + curves.front().contestant.method + " over " +
                             peer + "'s at any equal run time",
                         a->least, 1, "higher"});
}

void add_points(Bench& bench, const AccuracyCase& c, const std::vector<Curve>& curves)
{
    for (const Curve& curve : curves)
        for (const Point& p : curve.points)
            bench.row({{"case", c.name},
                       {"engine", curve.contestant.engine},
                       {"method", curve.contestant.method},
                       {"steps", static_cast<double>(p.steps)},
                       {"step [s]", c.end / p.steps},
                       {"time [ms]", p.seconds * 1e3},
                       {"error", p.error},
                       {"error is", c.error}});
}

int measure_all(bool json, const std::string& folder)
{
    Bench bench("accuracy");
    note_missing_engines(bench, contact_contestants());
    for (const AccuracyCase& c :
         {free_body_case(), heavy_top_case(), pendulum_case(), bounce_case(0.5), bounce_case(0.8),
          bounce_case(1), sliding_case(), sticking_case(), rolling_case(), stack_case()}) {
        const std::vector<Curve> curves = measure(c);
        report(bench, c, curves);
        if (json) add_points(bench, c, curves);
        if (!folder.empty()) plot_case(c, curves, folder);
        bench.note(c.name + ": " + c.title + "; error: " + c.error + ".");
    }
    bench.note("Smallest error: over all step sizes, with the step and the time it took.");
    bench.note(
        "× Bullet, × ODE: how many times smaller our error is in the same run time, at the "
        "peer's smallest error and (where that is least); over the peer's methods, the worst. "
        "none: we have no result that soon.");
    bench.note("Times are medians of 3 to 9 rounds over all contestants, of the one thread's "
               "processor time; no body sleeps.");
    bench.note(
        "bounce: a height is y + v²/2g of the sample nearest the top; a bounce that is missing "
        "counts as an error of 1.");
    if (!folder.empty()) bench.note("Plots and their curves: " + folder + "/*.svg");
    return bench.finish(json);
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return measure_all(wants_json(argc, argv), plot_folder(argc, argv));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rigor: %s\n", error.what());
        return 2;
    }
}
