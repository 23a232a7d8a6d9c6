// SPDX-License-Identifier: MIT
// A4.12: scenes of balls that bounce and roll, blocks on inclines, a rod on ice, a pile of boxes.
#include "support/in_words.hpp"
#include "support/scene_run.hpp"

#include <algorithm>
#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace {

// The height of the lowest point of a ball above the floor, at the top of each flight [m].
std::vector<double> apexes(const Trajectory& run, int body)
{
    std::vector<double> result;
    const auto i = static_cast<std::size_t>(body);
    const double radius = std::get<Sphere>(run.scene.bodies[i].parts[0].shape).radius;
    for (std::size_t n = 0; n + 1 < run.frames.size(); ++n) {
        const RigidState& state = run.frames[n].bodies[i];
        const double v = state.velocity.y();
        const bool at_top = v > 0 && run.frames[n + 1].bodies[i].velocity.y() <= 0;
        if (at_top) result.push_back(state.position.y() - radius + v * v / (2 * 9.81));
    }
    return result;
}

} // namespace

TEST_CASE("collision: a ball bounces to restitution squared times its height",
          "[A4.12][collision][scene]")
{
    for (const double h : {0.004, 0.002, 0.001}) {
        const Trajectory run = run_scene("a4-collision/bouncing_spheres", h);
        for (const auto& [name, e] :
             {std::pair("restitution 0.5", 0.5), std::pair("restitution 0.8", 0.8),
              std::pair("restitution 1", 1.0)}) {
            CAPTURE(h, name, e);
            const std::vector<double> heights = apexes(run, body_index(run, name));
            check_that(!heights.empty(), "a ball bounces");
            // The first bounce from 2 m reaches e² 2 m. The time of an impact is known to within a
            // step, so the height is off by about the fall in one step, v h. The bound is twice
            // this, relative to the fall of 2 m.
            const double v = std::sqrt(2 * 9.81 * 2);
            check_at_most(std::abs(heights[0] / (e * e * 2) - 1), 2 * v * h / 2,
                          "relative error of the height");
        }
    }
}

TEST_CASE("collision: a ball that bounces perfectly gains no energy", "[A4.12][collision][scene]")
{
    const Trajectory run = run_scene("a4-collision/bouncing_spheres");
    const auto i = static_cast<std::size_t>(body_index(run, "restitution 1"));
    const double m = run.bodies[i].mass;
    const double start = m * 9.81 * 2.3;
    for (const Frame& frame : run.frames) {
        const RigidState& state = frame.bodies[i];
        const double energy = m * 9.81 * state.position.y() + m / 2 * state.velocity.squaredNorm();
        CAPTURE(frame.step);
        check_at_most(energy, start, "energy [J]", 2 * start * (1 + steps_of(frame)));
    }
}

TEST_CASE("collision: a block with restitution rests on an incline that holds it",
          "[A4.12][collision][scene]")
{
    const Trajectory run = run_scene("a4-collision/incline_stuck");
    for (const char* name : {"restitution 0", "restitution 0.5", "restitution 1"}) {
        CAPTURE(name);
        const auto i = static_cast<std::size_t>(body_index(run, name));
        const RigidState& start = run.frames.front().bodies[i];
        for (const Frame& frame : run.frames) {
            CAPTURE(frame.step);
            const double k = 64 * (1 + steps_of(frame));
            INFO("the block stays where it was");
            REQUIRE_THAT(frame.bodies[i].position, IsClose(start.position, Rounding(k, 5)));
            REQUIRE_THAT(frame.bodies[i].orientation, IsClose(start.orientation, Rounding(k, 1)));
        }
    }
}

TEST_CASE("collision: a block slides down an incline at g times sine minus friction times cosine",
          "[A4.12][collision][scene]")
{
    const Trajectory run = run_scene("a4-collision/incline_sliding");
    const double h = run.scene.time_step, pi = std::acos(-1.0), angle = pi / 6;
    const Vector3d down(std::cos(angle), -std::sin(angle), 0);
    for (const auto& [name, mu] :
         {std::pair("friction 0", 0.0), std::pair("friction 0.1", 0.1),
          std::pair("friction 0.2", 0.2), std::pair("friction 0.4", 0.4)}) {
        const auto i = static_cast<std::size_t>(body_index(run, name));
        const RigidState& start = run.frames.front().bodies[i];
        const double a = 9.81 * (std::sin(angle) - mu * std::cos(angle));
        for (const Frame& frame : run.frames) {
            const double n = steps_of(frame);
            if (n > 150) break; // later the fastest block reaches the edge of the incline
            CAPTURE(name, n);
            INFO("the way down the incline after n steps [m], a t²/2");
            const double x = a * h * h * n * n / 2;
            const double found = (frame.bodies[i].position - start.position).dot(down);
            REQUIRE_THAT(found, IsClose(x, Rounding(256 * (1 + n), 10)));
        }
    }
}

TEST_CASE("collision: a ball that slides ends rolling with five sevenths of its speed",
          "[A4.12][collision][scene]")
{
    const Trajectory run = run_scene("a4-collision/slip_to_roll");
    const Statistics statistics(run.scene, run.bodies);
    const double k = 64 * steps_of(run.frames.back());
    for (const char* name : {"friction 0.1", "friction 0.2", "friction 0.4"}) {
        CAPTURE(name);
        const int body = body_index(run, name);
        const RigidState end = last_state(run, name);
        const Vector3d w = statistics.angular_velocity(static_cast<std::size_t>(body), end);
        const double v = 5.0 / 7 * 3, r = 0.25;
        INFO("the ball rolls with five sevenths of its speed [m/s]");
        REQUIRE_THAT(end.velocity, IsClose(Vector3d(v, 0, 0), Rounding(k, 3)));
        INFO("its angular velocity is its speed over its radius [rad/s]");
        REQUIRE_THAT(w, IsClose(Vector3d(0, 0, -v / r), Rounding(k, 3 / r)));
    }
    const RigidState free = last_state(run, "friction 0");
    INFO("without friction the ball keeps its velocity and does not turn");
    REQUIRE_THAT(free.velocity, IsClose(Vector3d(3, 0, 0), Rounding(k, 3)));
    REQUIRE_THAT(free.angular_momentum, IsClose(Vector3d(0, 0, 0), Rounding(k, 1)));
}

TEST_CASE("collision: a rod that falls on ice drops straight down", "[A4.12][collision][scene]")
{
    const Trajectory run = run_scene("a4-collision/rod_tip");
    const auto i = static_cast<std::size_t>(body_index(run, "frictionless"));
    const RigidState& start = run.frames.front().bodies[i];
    bool turned = false;
    for (const Frame& frame : run.frames) {
        const RigidState& state = frame.bodies[i];
        CAPTURE(frame.step);
        const double k = 64 * (1 + steps_of(frame));
        INFO("the center stays above the same point of the ice [m]");
        REQUIRE_THAT(state.position.x(), IsClose(start.position.x(), Rounding(k, 1)));
        REQUIRE_THAT(state.position.z(), IsClose(start.position.z(), Rounding(k, 1)));
        turned = turned || state.angular_momentum.norm() > 0.01;
    }
    check_that(turned, "the rod on ice turns, since it has met the floor");
}

TEST_CASE("collision: colliding balls never gain energy", "[A4.12][collision][scene]")
{
    const Trajectory run = run_scene("a4-collision/billiard_break", {}, R"({"end": 2})");
    const Statistics statistics(run.scene, run.bodies);
    const double start = statistics.of(run.frames.front()).total_energy();
    double before = start;
    for (const Frame& frame : run.frames) {
        const double now = statistics.of(frame).total_energy();
        CAPTURE(frame.step);
        check_at_most(now, before, "energy [J]", start * 64);
        before = now;
    }
    check_that(before < 0.9 * start, "the balls lose a tenth of their energy at least");
}

TEST_CASE("collision: a pile of boxes settles and gains no energy", "[A4.12][collision][scene]")
{
    // 18 of the scene's hundred boxes. After 2 s they are at rest.
    const Trajectory run = run_scene("a4-collision/hundred_boxes", {}, R"({"end": 2, "bodies": [
        {"name": "floor", "shape": {"plane": {}}, "static": true, "restitution": 1,
         "friction": 0.6},
        {"name": "box", "shape": {"box": {"size": [0.5, 0.5, 0.5]}}, "density": 500,
         "position": [-1.7, 0.8, -1.7], "restitution": 0.2, "friction": 0.6,
         "grid": {"count": [3, 2, 3], "spacing": [0.85, 0.9, 0.85], "jitter": 0.04,
                  "jitter_degrees": 30, "seed": 7}}]})");
    const Statistics statistics(run.scene, run.bodies);
    const double start = statistics.of(run.frames.front()).total_energy();
    double deepest = 0;
    for (const Frame& frame : run.frames) {
        const FrameStatistics now = statistics.of(frame);
        CAPTURE(frame.step);
        check_at_most(now.total_energy(), start, "total energy [J]", start * (1 + steps_of(frame)));
        deepest = std::max(deepest, now.deepest_penetration);
    }
    check_at_most(deepest, 0.05, "penetration of boxes of 0.5 m [m]");
    check_at_most(statistics.of(run.frames.back()).kinetic_energy, start / 100,
                  "kinetic energy at the end [J]");
}
