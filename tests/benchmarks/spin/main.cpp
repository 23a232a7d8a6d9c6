// SPDX-License-Identifier: MIT
// Orientation error against run time for a free rigid body, with each of our integrators and, if
// they are installed, with Bullet and ODE. The errors at equal run time are compared, by
// interpolation between the measured points.
#include "rigid/bodies/mass.hpp"
#include "rigid/bodies/world.hpp"
#include "rigid/step/step.hpp"
#include "run.hpp"
#include "support/bench/bench.hpp"
#include "support/free_rotor.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

using namespace rigor;

namespace {

// One point of a curve of error against run time.
struct Point {
    int steps = 0;
    double seconds = 0, error = 0; // [rad]
};

struct Contestant {
    std::string engine, integrator;
    std::vector<int> steps;
    std::function<SpinRun(int)> run;
    std::vector<Point> curve;
};

SpinRun spin(Integrator integrator, int steps)
{
    World world;
    world.settings.integrator = integrator;
    RigidBody& body = world.bodies.emplace_back();
    body.name = "box";
    set_mass(body, spin_mass, spin_inertia.asDiagonal().toDenseMatrix());
    body.state.angular_momentum = spin_inertia.cwiseProduct(spin_velocity);

    SpinRun result;
    result.seconds = seconds([&] {
        for (int i = 0; i < steps; ++i)
            step(world, spin_end / steps);
    });
    const Quaternion& q = world.bodies[0].state.orientation;
    result.orientation = Eigen::Quaterniond(q.s, q.v.x(), q.v.y(), q.v.z());
    return result;
}

std::vector<Contestant> contestants()
{
    const std::vector<int> coarse = {25, 50, 100, 200, 400, 800, 1600, 3200, 6400, 12800, 25600};
    const std::vector<int> peers = {300, 600, 1200, 2400, 4800, 9600, 19200, 38400, 76800, 153600};
    std::vector<Contestant> all;
    for (const auto& [name, integrator] :
         {std::pair("runge_kutta", Integrator::runge_kutta),
          std::pair("matrix", Integrator::matrix), std::pair("buss", Integrator::buss),
          std::pair("exponential", Integrator::exponential),
          std::pair("linear", Integrator::linear), std::pair("exact", Integrator::exact)})
        all.push_back({"rigor",
                       name,
                       coarse,
                       [kind = integrator](int steps) { return spin(kind, steps); },
                       {}});
#ifdef RIGOR_BULLET
    all.push_back({"bullet", "default", peers, spin_bullet, {}});
#endif
#ifdef RIGOR_ODE
    all.push_back({"ode", "default", peers, spin_ode, {}});
#endif
    return all;
}

// Measures all contestants in each round, so that a slow phase of the machine affects all of them.
// The time of each point is the median over the rounds.
void measure(std::vector<Contestant>& all, int rounds)
{
    const FreeRotor exact(spin_inertia, spin_velocity);
    const Eigen::Quaterniond end = exact.orientation(spin_end);
    std::vector<std::vector<std::vector<double>>> times(all.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t c = 0; c < all.size(); ++c) {
            all[c].curve.resize(all[c].steps.size());
            times[c].resize(all[c].steps.size());
            for (std::size_t i = 0; i < all[c].steps.size(); ++i) {
                const SpinRun run = all[c].run(all[c].steps[i]);
                times[c][i].push_back(run.seconds);
                all[c].curve[i] = {all[c].steps[i], median(times[c][i]),
                                   rotation_angle(run.orientation, end)};
            }
        }
}

// The error that a curve reaches in a given time. Between two points the interpolation is linear in
// the logarithms; beyond the ends the error of the end is taken.
double error_at(const std::vector<Point>& curve, double time)
{
    if (time <= curve.front().seconds) return curve.front().error;
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const Point &a = curve[i - 1], &b = curve[i];
        if (time > b.seconds || b.seconds <= a.seconds) continue;
        const double x = std::log(time / a.seconds) / std::log(b.seconds / a.seconds);
        return std::exp((1 - x) * std::log(a.error) + x * std::log(b.error));
    }
    return curve.back().error;
}

// The smallest ratio, over all points of `theirs`, of the error of `theirs` to that of `ours` after
// the same computing time.
double advantage(const std::vector<Point>& ours, const std::vector<Point>& theirs)
{
    double least = std::numeric_limits<double>::infinity();
    for (const Point& point : theirs)
        least = std::min(least, point.error / error_at(ours, point.seconds));
    return least;
}

} // namespace

int main(int argc, char** argv)
{
    Bench bench("spin");
    std::vector<Contestant> all = contestants();
    measure(all, 9);
    for (const Contestant& c : all)
        for (const Point& p : c.curve)
            bench.row({{"engine", c.engine},
                       {"integrator", c.integrator},
                       {"steps", static_cast<double>(p.steps)},
                       {"step [s]", spin_end / p.steps},
                       {"time [ms]", p.seconds * 1e3},
                       {"error [rad]", p.error}});
    bench.note(
        "Free box 1 x 2 x 3 m, 12 kg, 10 s from ω = (1, 2, 3) rad/s; error: the angle to the exact "
        "orientation at the end.");
    bench.note("Times are medians of 9 rounds over all contestants. At equal run time: for each "
               "point of the peer, our error");
    bench.note("at its time, read between our points in the logarithms; the least of these ratios "
               "counts.");
    const std::vector<Point>& ours = all.front().curve;
    for (const Contestant& c : all) {
        if (c.integrator == "exact")
            bench.reach({"error of the default integrator in " + std::to_string(c.steps.front()) +
                             " steps [rad]",
                         c.curve.front().error, 1e-13, "lower"});
        if (c.engine == "rigor") continue;
        bench.reach({"accuracy of runge_kutta over " + c.engine + "'s at equal run time",
                     advantage(ours, c.curve), 1000, "higher"});
    }
    note_missing_engines(bench, all);
    return bench.finish(wants_json(argc, argv));
}
