// SPDX-License-Identifier: MIT
// A ball that bounces: the error of its heights, and its energy gain if restitution is 1.
#include "parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

constexpr double fine_step = 1e-3; // [s]
constexpr int hundred = 100;

// The heights of the first n bounces; fewer if `end` comes first [m].
std::vector<double> heights_by(const Contestant& contestant, double restitution, double h,
                               double end, int n)
{
    const std::unique_ptr<TrialEngine> engine = contestant.start(dropped_ball(restitution));
    std::vector<TrialMotion> path;
    for (double t = 0; t < end; t += h) {
        engine->step(h);
        path.push_back(engine->motion(0));
    }
    return bounce_heights(path, n);
}

// The largest relative error of the first four heights, ε²ᵏ; infinite if one is missing.
double height_error(const Contestant& contestant, double restitution, double h)
{
    const std::vector<double> heights = heights_by(contestant, restitution, h, 4, 4);
    if (heights.size() < 4) return std::numeric_limits<double>::infinity();
    double worst = 0, exact = 1;
    for (double height : heights) {
        exact *= restitution * restitution;
        worst = std::max(worst, std::abs(height / exact - 1));
    }
    return worst;
}

} // namespace

void measure_bounces(Bench& bench, const std::vector<Contestant>& all)
{
    const auto percent = [](double error) -> Bench::Value {
        if (std::isfinite(error)) return 100 * error;
        return std::string("too few bounces");
    };
    for (const Contestant& contestant : all) {
        for (double restitution : {0.5, 0.8}) {
            const double fine = height_error(contestant, restitution, fine_step);
            bench.row({{"bounces", contestant.name()},
                       {"restitution", restitution},
                       {"off at h = 1/1000 s [%]", percent(fine)},
                       {"off at h = 1/60 s [%]",
                        percent(height_error(contestant, restitution, contact_step))}});
            if (contestant.is_ours())
                bench.reach({contestant.method + ": height of four bounces, restitution " +
                                 (restitution == 0.5 ? "0.5" : "0.8") + ", h = 1e-3 s, off by [%]",
                             100 * fine, 0.2, "lower"});
        }
    }
    bench.note(
        "Bounces: a ball from 1 m; the largest relative error of the first four heights ε²ᵏ.");
}

void measure_elastic_bounces(Bench& bench, const std::vector<Contestant>& all)
{
    const double end = (2 * hundred + 3) * std::sqrt(2 / standard_gravity);
    for (const Contestant& contestant : all) {
        double worst = 0;
        for (double h : {contact_step, fine_step}) {
            const std::vector<double> heights = heights_by(contestant, 1, h, end, hundred);
            const bool all_there = std::ssize(heights) == hundred;
            const double gain = heights.empty()
                                    ? std::numeric_limits<double>::infinity()
                                    : *std::max_element(heights.begin(), heights.end()) - 1;
            bench.row(
                {{"hundred elastic bounces", contestant.name()},
                 {"step [s]", h},
                 {"bounces", static_cast<double>(heights.size())},
                 {"largest gain", std::isfinite(gain) ? Bench::Value(gain) : "none"},
                 {"last height [m]", heights.empty() ? Bench::Value("none") : heights.back()}});
            worst = std::max(worst, all_there ? gain : std::numeric_limits<double>::infinity());
        }
        if (contestant.is_ours())
            bench.reach({contestant.method + ": relative energy gain over 100 elastic bounces",
                         worst, 1e-12, "lower"});
    }
    bench.note(
        "Hundred elastic bounces: the largest energy at a top, over that of the start, less 1.");
}

} // namespace rigor
