// SPDX-License-Identifier: MIT
// The cases with contact: a ball that bounces, a block that slides or sticks, a ball that starts to
// roll, and a stack. The exact solutions are closed formulas of Coulomb friction and Newton's
// restitution.
#include "benchmarks/engines/scenes.hpp"
#include "cases.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

constexpr int bounces = 4;

AccuracyCase contact_case(const std::string& name, const Trial& trial, double end, int first, int n)
{
    AccuracyCase c;
    c.name = name;
    c.trial = trial;
    c.end = end;
    c.steps = c.peer_steps = doubled(first, n);
    c.contestants = contact_contestants();
    return c;
}

// The distance of the first body from its exact position [m].
std::function<double(const TrialEngine&, const std::vector<TrialMotion>&)>
distance_to(const Vector3d& exact)
{
    return [exact](const TrialEngine& engine, const auto&) {
        return (engine.motion(0).position - exact).norm();
    };
}

// The time when the ball of `dropped_ball` lands after the last bounce [s], with h = 1 m:
// √(2h/g) (1 + 2 (ε + ε² + ε³ + ε⁴)).
double end_of_bounces(double restitution)
{
    double falls = 1, speed = 1;
    for (int k = 0; k < bounces; ++k)
        falls += 2 * (speed *= restitution);
    return falls * std::sqrt(2 / standard_gravity);
}

} // namespace

AccuracyCase bounce_case(double restitution)
{
    const std::string percent = std::to_string(std::lround(restitution * 100));
    AccuracyCase c = contact_case("bounce_" + percent, dropped_ball(restitution),
                                  end_of_bounces(restitution), 50, 10);
    c.title = "Ball from 1 m, restitution " + percent + " %, four bounces of height ε²ᵏ";
    c.error = "largest relative error of a height";
    c.needs_path = true;
    c.error_of = [restitution](const TrialEngine&, const std::vector<TrialMotion>& path) {
        const std::vector<double> heights = bounce_heights(path, bounces);
        double worst = std::ssize(heights) < bounces ? 1 : 0, exact = 1;
        for (double height : heights) {
            exact *= restitution * restitution;
            worst = std::max(worst, std::abs(height / exact - 1));
        }
        return worst;
    };
    return c;
}

AccuracyCase sliding_case()
{
    constexpr double a = 3.20585815777493; // g (sin 30° - 0.2 cos 30°)
    const Trial trial = block_on_incline(30, 0.2);
    AccuracyCase c = contact_case("incline_slides", trial, 1, 25, 10);
    c.title = "Block on 30° with friction 0.2: it slides, 1 s";
    c.error = "distance to the exact place [m]";
    c.error_of = distance_to(trial.bodies[0].position + trial.ground * Vector3d(a / 2, 0, 0));
    return c;
}

AccuracyCase sticking_case()
{
    const Trial trial = block_on_incline(20, 0.5);
    AccuracyCase c = contact_case("incline_sticks", trial, 2, 25, 8);
    c.title = "Block on 20° with friction 0.5: it stays, 2 s";
    c.error = "distance to where it was [m]";
    c.error_of = distance_to(trial.bodies[0].position);
    return c;
}

AccuracyCase rolling_case()
{
    constexpr double rolls_at = 0.145623998835008, slid = 0.124820570430007,
                     end = 0.5; // [s], [m], [s]
    Trial trial = dropped_ball(0);
    trial.friction = 0.2;
    TrialBody& ball = trial.bodies[0];
    ball.position.y() -= 1;
    ball.velocity = Vector3d::UnitX();
    const Vector3d exact = ball.position + Vector3d(slid + 5. / 7 * (end - rolls_at), 0, 0);
    AccuracyCase c = contact_case("slip_to_roll", trial, end, 16, 11);
    c.title = "Ball at 1 m/s, friction 0.2: it slips, then rolls at 5/7 m/s, 0.5 s";
    c.error = "distance to the exact place [m]";
    c.error_of = distance_to(exact);
    return c;
}

AccuracyCase stack_case()
{
    const Trial trial = cube_stack(10);
    AccuracyCase c = contact_case("stack_10", trial, 5, 150, 4);
    c.title = "Ten unit cubes on top of each other, 5 s";
    c.error = "largest way of a cube, drift and sinking [m]";
    c.error_of = [trial](const TrialEngine& engine, const auto&) {
        return stack_figures(trial, engine).displacement;
    };
    return c;
}

} // namespace rigor
