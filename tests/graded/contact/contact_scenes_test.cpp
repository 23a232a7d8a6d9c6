// SPDX-License-Identifier: MIT
// A5.6: bodies that must stay, bodies that must fall, and the loads that they carry.
#include "support/in_words.hpp"
#include "support/scene_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double g = 9.81;

bool is_called(const Trajectory& run, std::size_t body, const std::string& prefix)
{
    return run.scene.bodies[body].name.starts_with(prefix);
}

// The largest distance from its start [m] that any body has whose name begins with `prefix`, up to
// the time `until` [s].
double farthest(const Trajectory& run, const std::string& prefix, double until)
{
    double distance = 0;
    std::size_t bodies = 0;
    for (std::size_t i = 0; i < run.bodies.size(); ++i) {
        if (run.bodies[i].is_static || !is_called(run, i, prefix)) continue;
        ++bodies;
        const Vector3d& start = run.frames.front().bodies[i].position;
        for (const Frame& frame : run.frames)
            if (frame.time <= until)
                distance = std::max(distance, (frame.bodies[i].position - start).norm());
    }
    check_that(bodies > 0, "the scene has bodies called " + prefix);
    return distance;
}

double end_of(const Trajectory& run)
{
    return run.frames.back().time;
}

// The first 0.3 s of a scene under another gravity.
Trajectory with_gravity(const std::string& scene, const Vector3d& gravity)
{
    return run_scene(scene, {},
                     fmt::format(R"({{"end": 0.3, "gravity": [{}, {}, {}]}})", gravity.x(),
                                 gravity.y(), gravity.z()));
}

// The mean displacement of the bodies that are not static, from the start to the end [m].
Vector3d mean_way(const Trajectory& run)
{
    Vector3d sum = Vector3d::Zero();
    int count = 0;
    for (std::size_t i = 0; i < run.bodies.size(); ++i) {
        if (run.bodies[i].is_static) continue;
        sum += run.frames.back().bodies[i].position - run.frames.front().bodies[i].position;
        ++count;
    }
    return sum / count;
}

// The largest kinetic energy after the first second [J].
double rattle(const Trajectory& run)
{
    const Statistics statistics(run.scene, run.bodies);
    double largest = 0;
    for (const Frame& frame : run.frames)
        if (frame.time > 1) largest = std::max(largest, statistics.of(frame).kinetic_energy);
    return largest;
}

// Checks in each step that the momentum of each body changes by its weight and by the impulses of
// its contacts.
void check_every_contact_is_recorded(const Trajectory& run)
{
    const Vector3d gravity(0, -g, 0);
    const double h = run.scene.time_step;
    for (std::size_t n = 1; n < run.frames.size(); ++n) {
        const Frame &before = run.frames[n - 1], &after = run.frames[n];
        std::vector<Vector3d> sums(run.bodies.size(), Vector3d::Zero());
        std::vector<double> sizes(run.bodies.size(), 0.0);
        for (const ContactRecord& c : after.contacts) {
            sums[c.body1] += c.impulse;
            sums[c.body2] -= c.impulse;
            for (int i : {c.body1, c.body2})
                sizes[i] += c.impulse.norm();
        }
        for (std::size_t i = 0; i < run.bodies.size(); ++i) {
            if (run.bodies[i].is_static) continue;
            const double M = run.bodies[i].mass;
            const Vector3d V0 = before.bodies[i].velocity, V = after.bodies[i].velocity;
            const double scale = M * (V0.norm() + V.norm() + h * g) + sizes[i];
            CAPTURE(n, run.scene.bodies[i].name);
            // hundreds of sweeps add rounding errors
            REQUIRE_THAT(Vector3d(M * (V - V0)),
                         IsClose(Vector3d(sums[i] + M * h * gravity), Rounding(4096, scale)));
        }
    }
}

// The load that the floor, body 0, carries in the last step, divided by the weight of all bodies.
double share_of_the_floor(const Trajectory& run)
{
    double carried = 0, weight = 0;
    for (const ContactRecord& c : run.frames.back().contacts) {
        if (c.body1 == 0) carried -= c.impulse.y();
        if (c.body2 == 0) carried += c.impulse.y();
    }
    for (const RecordedBody& body : run.bodies)
        weight += body.is_static ? 0 : body.mass * g * run.scene.time_step;
    return carried / weight;
}

// Cosine of the angle between a body's y-axis and the vertical.
double uprightness(const Frame& frame, int body)
{
    const Quaternion& q = frame.bodies[static_cast<std::size_t>(body)].orientation;
    return 1 - 2 * (q.v.x() * q.v.x() + q.v.z() * q.v.z());
}

} // namespace

TEST_CASE("contact: a stack of ten cubes stands", "[A5.6][contact][scene]")
{
    const Trajectory run = run_scene("a5-contact/stack");
    check_at_most(farthest(run, "cube", end_of(run)), 0.01, "way of a cube of 0.5 m [m]");

    // The stack stands by its weight, and not because bodies that touch stop: where gravity points
    // upwards it flies. In n steps a body falls by ½ g t² (1 - 1/n) at least, also by Euler's
    // method.
    const Trajectory flight = with_gravity("a5-contact/stack", {0, g, 0});
    const double t = end_of(flight), n = steps_of(flight.frames.back());
    check_at_least(mean_way(flight).y(), g * t * t / 2 * (1 - 1 / n),
                   "mean way of the cubes while gravity points upwards [m]", 64);
    // Where gravity leans by 45° the cubes slide, since μ = 0.6. Friction takes 0.6 of their weight
    // as long as they do not rise. While they tumble it may take somewhat more, at most 0.8.
    const double lean = g / std::sqrt(2.0);
    const Trajectory slide = with_gravity("a5-contact/stack", {lean, -lean, 0});
    check_at_least(mean_way(slide).x(), lean * t * t / 2 * (1 - 0.8),
                   "mean way of the cubes while gravity leans by 45° [m]");
}

TEST_CASE("contact: one at a time the cubes rattle until they fall", "[A5.6][contact][scene]")
{
    const Trajectory calm = run_scene("a5-contact/stack", {}, R"({"end": 2})");
    const Trajectory rattling = run_scene("a5-contact/rattling_stack");
    check_at_most(100 * rattle(calm), rattle(rattling),
                  "a hundred times the kinetic energy of the calm stack [J]");
    check_at_most(last_state(rattling, "cube 10").position.y(), 4, "height of the topmost [m]");
}

TEST_CASE("contact: a tower stands just short of its overhang limit and falls beyond it",
          "[A5.6][contact][scene]")
{
    const Trajectory run = run_scene("a5-contact/leaning_tower");
    check_at_most(farthest(run, "bold", end_of(run)), 1e-3, "way of a block that stands [m]");
    check_at_most(last_state(run, "too bold 9").position.y(), 1, "height of the topmost [m]");
}

TEST_CASE("contact: a dry wall stands until it is hit", "[A5.6][contact][scene]")
{
    const Trajectory run = run_scene("a5-contact/wall");
    check_at_most(farthest(run, "brick", 1), 0.01, "way of a brick before the ball comes [m]");
    check_at_least(farthest(run, "brick", end_of(run)), 1, "way of the farthest brick [m]");
}

TEST_CASE("contact: an arch carries a load and the floor carries both", "[A5.6][contact][scene]")
{
    const Trajectory run = run_scene("a5-contact/arch");
    check_at_most(farthest(run, "stone", end_of(run)), 1e-3, "way of a stone [m]");
    const Trajectory awake =
        run_scene("a5-contact/arch", {}, R"({"end": 0.5, "optimisations": {"sleep": false}})");
    check_every_contact_is_recorded(awake);
    check_at_most(std::abs(share_of_the_floor(awake) - 1), 1e-3, "what the floor carries, less 1");
}

TEST_CASE("contact: a pyramid stands", "[A5.6][contact][scene]")
{
    const Trajectory run = run_scene("a5-contact/pyramid");
    check_at_most(farthest(run, "block", end_of(run)), 1e-3, "way of a block [m]");
}

TEST_CASE("contact: dominoes fall one after the other", "[A5.6][contact][scene]")
{
    const Trajectory run = run_scene("a5-contact/dominoes");
    double before = 0;
    for (int k = 2; k <= 36; ++k) {
        const int body = body_index(run, "domino " + std::to_string(k));
        const auto fallen = std::find_if(run.frames.begin(), run.frames.end(), [&](const Frame& f) {
            return uprightness(f, body) < std::cos(std::acos(-1.0) / 6); // leans by 30°
        });
        CAPTURE(k, before);
        check_that(fallen != run.frames.end(), "domino k falls");
        check_that(fallen->time > before, "domino k falls later than the one before it");
        before = fallen->time;
    }
}

TEST_CASE("contact: a house of cards stands", "[A5.6][contact][scene]")
{
    const Trajectory run = run_scene("a5-contact/card_house");
    for (const char* cards : {"left", "right", "roof"})
        check_at_most(farthest(run, cards, end_of(run)), 2e-3, "way of a card of 1 m [m]");
    check_at_most(rattle(run), 1e-3, "kinetic energy after the first second [J]");
}

TEST_CASE("contact: a seesaw tilts as its whole weight lets it", "[A5.6][contact][scene]")
{
    // As one rigid body the seesaw turns about the left edge of the ridge, at (-0.03, 0.5):
    // α = g Σ m (-0.03 - x) / Σ (I + m d²) over plank, small block and big block.
    const double m[] = {192, 62.5, 400}, x[] = {0, 1.7, -1.45}, y[] = {0.55, 0.85, 1.1};
    const double square[] = {16.01, 0.5, 2}; // w² + h²
    double torque = 0, I = 0;
    for (int i = 0; i < 3; ++i) {
        torque += g * m[i] * (-0.03 - x[i]);
        I += m[i] * (square[i] / 12 + std::pow(x[i] + 0.03, 2) + std::pow(y[i] - 0.5, 2));
    }
    const double alpha = torque / I;
    const auto first_step = [](const std::string& contact) {
        const Trajectory run =
            run_scene("a5-contact/seesaw", {}, "{\"end\": 0.02, \"contact\": \"" + contact + "\"}");
        const auto plank = static_cast<std::size_t>(body_index(run, "plank"));
        const Statistics statistics(run.scene, run.bodies);
        return statistics.angular_velocity(plank, run.frames[1].bodies[plank]).z() /
               run.scene.time_step;
    };
    // there are few contacts, and the engine sweeps until only rounding changes
    REQUIRE_THAT(first_step("simultaneous"), IsClose(alpha, Rounding(16384)));
    // shock propagation is not exact, but the weight above must not be lost
    check_at_most(std::abs(first_step("shock_propagation") / alpha - 1), 0.2,
                  "relative error of the angular acceleration by shock propagation");
}

TEST_CASE("contact: rings on a peg come to rest one upon the other", "[A5.6][contact][scene]")
{
    const Trajectory run = run_scene("a5-contact/rings_on_a_peg");
    double below = 0;
    for (int k = 1; k <= 6; ++k) {
        const RigidState ring = last_state(run, "ring " + std::to_string(k));
        CAPTURE(k);
        // The hole of the largest ring is 1.08 m wide and the peg 0.16 m thick. So the center of a
        // ring on the peg is less than 0.5 m from the axis.
        check_at_most(std::hypot(ring.position.x(), ring.position.z()), 0.5, "from the axis [m]");
        check_at_most(below + 0.05, ring.position.y(), "a ring's height [m]");
        check_at_most(ring.velocity.norm(), 0.01, "speed [m/s]");
        below = ring.position.y();
    }
}

TEST_CASE("contact: a pile of nonconvex bodies comes to rest and gains no energy",
          "[A5.6][contact][scene]")
{
    const Trajectory run = run_scene("a5-contact/nonconvex_pile");
    const Statistics statistics(run.scene, run.bodies);
    const double start = statistics.of(run.frames.front()).total_energy();
    double deepest = 0;
    for (const Frame& frame : run.frames) {
        const FrameStatistics now = statistics.of(frame);
        CAPTURE(frame.step);
        check_at_most(now.total_energy(), start, "total energy [J]", start * (1 + steps_of(frame)));
        deepest = std::max(deepest, now.deepest_penetration);
    }
    check_at_most(deepest, 0.03, "penetration of beams 0.2 m thick [m]");
    check_at_most(statistics.of(run.frames.back()).kinetic_energy, start / 1000,
                  "kinetic energy at the end [J]");
}
