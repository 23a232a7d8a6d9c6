// SPDX-License-Identifier: MIT
// Runs of scenes with the formulas of the worker under test, and their comparison with the oracle,
// a worker with the formulas of the reference, which runs scenes itself. `check_every_step` lets
// the oracle take each step from the recorded state before it, and compares the two results. If
// they differ, the oracle also starts from neighboring states, to see whether rounding alone
// decides the step.
#include "support/scene_run.hpp"

#include "scene/keys/scene_keys.hpp"
#include "scene/trajectory/reader.hpp"
#include "support/in_words.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"
#include "worker/client.hpp"
#include "worker/proxy/proxy.hpp"
#include "worker/proxy/scenes.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace rigor::testing {

namespace {

Eigen::Quaterniond to_eigen(const Quaternion& q)
{
    return {q.s, q.v.x(), q.v.y(), q.v.z()};
}

Scene shipped_scene(const std::string& name)
{
    const std::size_t slash = name.find('/');
    return load_scene(std::filesystem::path(RIGOR_SOURCE_DIR) / "assignments" /
                      name.substr(0, slash) / "scenes" / (name.substr(slash + 1) + ".json"));
}

Scene shipped_scene(const std::string& name, std::optional<double> time_step,
                    const std::string& changes)
{
    const Scene scene = shipped_scene(name);
    if (!time_step && changes == "{}") return scene;
    nlohmann::json text = nlohmann::json::parse(scene.text);
    if (time_step) text["time_step"] = *time_step;
    text.merge_patch(nlohmann::json::parse(changes));
    return parse_scene(text.dump(), scene.name);
}

// The one of q and -q, which are the same rotation, that is nearer to `other`.
Quaternion same_sign(const Quaternion& q, const Quaternion& other)
{
    const double dot = q.s * other.s + q.v.dot(other.v);
    return dot < 0 ? Quaternion{-q.s, -q.v} : q;
}

// A step adds and multiplies some hundred numbers of the size of the state. 1e4 eps of that size
// bounds the rounding of any way to write the formulas, and no wrong formula is that close.
constexpr double k = 1e4, eps = std::numeric_limits<double>::epsilon();

// The magnitudes of the numbers that a step adds up: positions, velocities and angular momenta.
struct Scales {
    double X, V, L;
};

Scales scales_of(const RigidState& before, const RigidState& after, double h, double mass)
{
    const double V = after.velocity.norm() + before.velocity.norm();
    const double L = after.angular_momentum.norm() + before.angular_momentum.norm();
    return {after.position.norm() + h * V + 1, V + 1, L + mass};
}

// The largest difference between the numbers of two states, as a share of their magnitudes.
double difference(const RigidState& a, const RigidState& b, const Scales& scales)
{
    const Quaternion q = same_sign(a.orientation, b.orientation);
    Eigen::Matrix<double, 13, 1> all;
    all << (a.position - b.position) / scales.X, (a.velocity - b.velocity) / scales.V,
        (a.angular_momentum - b.angular_momentum) / scales.L, q.v - b.orientation.v,
        q.s - b.orientation.s;
    return all.allFinite() ? all.lpNorm<Eigen::Infinity>() : INFINITY;
}

// A neighboring state, some eps away.
RigidState nudged(const RigidState& state, double mass, Random& random)
{
    const auto nudge = [&](double scale) -> Vector3d { return 16 * eps * scale * random.vector(); };
    RigidState next = state;
    next.position += nudge(state.position.norm() + 1);
    next.orientation.v += nudge(1);
    next.velocity += nudge(state.velocity.norm() + 1);
    next.angular_momentum += nudge(state.angular_momentum.norm() + mass);
    return next;
}

// The largest difference between the bodies of two results of a step from `start`.
double difference(const Trajectory& run, const Worker::Start& start,
                  const std::vector<RigidState>& a, const std::vector<RigidState>& b)
{
    double largest = 0;
    for (std::size_t i = 0; i < run.bodies.size(); ++i) {
        const RecordedBody& body = run.bodies[i];
        if (body.is_static) continue;
        const Scales scales = scales_of(start.second[i], b[i], run.scene.time_step, body.mass);
        largest = std::max(largest, difference(a[i], b[i], scales));
    }
    return largest;
}

std::vector<Worker::Start> neighbours_of(const Trajectory& run, const Worker::Start& start,
                                         std::size_t count, Random& random)
{
    std::vector<Worker::Start> neighbours(count, start);
    for (auto& [time, states] : neighbours)
        for (std::size_t i = 0; i < states.size(); ++i)
            if (!run.bodies[i].is_static) states[i] = nudged(states[i], run.bodies[i].mass, random);
    return neighbours;
}

// Whether rounding alone decides a step: whether the reference gets another result from one of the
// neighboring states, and `found` is no farther from the reference's result than such others are.
// Then no result of this step is the right one. An example is a scene where points are equally
// deep, so that rounding decides which of them comes first. The other result may come from only one
// in a hundred neighboring states, so up to 400 of them are tried. The worker under test is not
// asked: a formula that is wrong in single states would be right in their neighbors.
bool hangs_on_rounding(const Trajectory& run, const Worker::Start& start,
                       const std::vector<RigidState>& found,
                       const std::vector<RigidState>& expected)
{
    // Several choices may add up in one result, and single ones in those of the neighbors.
    constexpr double choices = 10;
    const double distance = difference(run, start, found, expected);
    Random random(1);
    for (std::size_t count : {8, 56, 336}) {
        const auto neighbours = neighbours_of(run, start, count, random);
        const auto results = oracle()->advance(run.scene.text, run.scene.name, neighbours, 1);
        for (const std::vector<RigidState>& result : results) {
            const double other = difference(run, start, result, expected);
            if (other > k * eps && distance <= choices * other) return true;
        }
    }
    return false;
}

} // namespace

namespace {

// @param run  runs the scene and passes its trajectory to the sink
template <class Run> Trajectory trajectory_of(const Scene& scene, const Run& run)
{
    Trajectory trajectory;
    TrajectoryReader reader(trajectory);
    run([&](std::span<const std::byte> bytes) { reader.feed(bytes); });
    trajectory.scene = scene;
    INFO("the run of scene " + scene.name + " ended early");
    REQUIRE(trajectory.complete);
    REQUIRE(trajectory.frames.size() >= 2);
    return trajectory;
}

Trajectory run_under_test(const Scene& scene)
{
    return trajectory_of(scene, [&](const ByteSink& sink) {
        run_scene_with_worker(scene, Record::every_step, sink);
    });
}

Trajectory run_by_oracle(const Scene& scene)
{
    return trajectory_of(scene, [&](const ByteSink& sink) {
        oracle()->run_scene(scene.text, scene.name, Record::every_step, sink);
    });
}

} // namespace

std::string other_boxes(const std::string& scene_name)
{
    Random random(*seeds(1).begin()); // a failure names the seed
    nlohmann::json bodies = nlohmann::json::parse(shipped_scene(scene_name).text)["bodies"];
    const auto change = [&](nlohmann::json& box) {
        for (nlohmann::json& edge : box["shape"]["box"]["size"])
            edge = edge.get<double>() * random.uniform(0.9, 1.1);
        box["density"] = box["density"].get<double>() * random.uniform(0.5, 2);
    };
    for (nlohmann::json& body : bodies) {
        if (body.contains("shape")) change(body);
        if (body.contains("parts"))
            for (nlohmann::json& part : body["parts"])
                change(part);
    }
    return nlohmann::json{{"bodies", bodies}}.dump();
}

Trajectory run_scene(const std::string& name, std::optional<double> time_step,
                     const std::string& changes)
{
    return run_under_test(shipped_scene(name, time_step, changes));
}

int body_index(const Trajectory& trajectory, const std::string& name)
{
    const auto& bodies = trajectory.scene.bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (bodies[i].name == name) return static_cast<int>(i);
    throw std::out_of_range("scene " + trajectory.scene.name + " has no body " + name);
}

RigidState last_state(const Trajectory& trajectory, const std::string& name)
{
    const auto i = static_cast<std::size_t>(body_index(trajectory, name));
    return trajectory.frames.back().bodies[i];
}

double angle_between(const Quaternion& a, const Quaternion& b)
{
    const Eigen::Quaterniond difference = to_eigen(a) * to_eigen(b).conjugate();
    return 2 * std::atan2(difference.vec().norm(), std::abs(difference.w()));
}

namespace {

// @return whether the step could be judged
bool check_step(const Trajectory& run, std::size_t n, const Worker::Start& start,
                const std::vector<RigidState>& expected)
{
    const std::vector<RigidState>& bodies = run.frames[n + 1].bodies;
    if (difference(run, start, bodies, expected) > k * eps &&
        hangs_on_rounding(run, start, bodies, expected))
        return false;
    for (std::size_t i = 0; i < run.bodies.size(); ++i) {
        if (run.bodies[i].is_static) continue;
        const RigidState& found = bodies[i];
        const RigidState& wanted = expected[i];
        const Scales scales =
            scales_of(start.second[i], wanted, run.scene.time_step, run.bodies[i].mass);
        const auto judge = [&](const char* quantity, const auto& actual, const auto& exact,
                               double scale) {
            INFO(fmt::format("{} of body '{}' after step {} of scene {} (t = {:.6g} s)", quantity,
                             run.scene.bodies[i].name, n + 1, run.scene.name,
                             run.frames[n + 1].time));
            REQUIRE_THAT(actual, IsClose(exact, Rounding(k, scale)));
        };
        judge("X", found.position, wanted.position, scales.X);
        judge("q", same_sign(found.orientation, wanted.orientation), wanted.orientation, 1);
        judge("V", found.velocity, wanted.velocity, scales.V);
        judge("L", found.angular_momentum, wanted.angular_momentum, scales.L);
    }
    return true;
}

} // namespace

void check_every_step(const std::string& scene_name, const std::string& changes)
{
    REQUIRE(oracle() != nullptr);
    nlohmann::json all = nlohmann::json::parse(without_memory);
    all.merge_patch(nlohmann::json::parse(changes));
    const Trajectory run = run_scene(scene_name, {}, all.dump());
    std::vector<Worker::Start> starts;
    for (std::size_t n = 0; n + 1 < run.frames.size(); ++n)
        starts.emplace_back(run.frames[n].time, run.frames[n].bodies);

    // The reference goes on from the first states, then from as many again, and so forth. A wrong
    // solution fails early, and the states that it goes on to may take the reference long: bodies
    // that are deep in each other.
    constexpr std::size_t fewest = 4;
    std::vector<std::vector<RigidState>> expected;
    std::size_t left_out = 0;
    for (std::size_t n = 0; n < starts.size(); ++n) {
        if (n == expected.size()) {
            const auto first = starts.begin() + static_cast<long>(n);
            const std::size_t count = std::min(std::max(fewest, n), starts.size() - n);
            const auto more = oracle()->advance(run.scene.text, run.scene.name,
                                                {first, first + static_cast<long>(count)}, 1);
            REQUIRE(more.size() == count);
            expected.insert(expected.end(), more.begin(), more.end());
        }
        if (check_step(run, n, starts[n], expected[n])) continue;
        ++left_out;
        check_that(2 * left_out < starts.size(),
                   fmt::format("rounding alone decides less than half of the steps of scene {}",
                               run.scene.name));
    }
}

void check_solids(const std::string& scene_name, double multiple, const std::string& changes)
{
    REQUIRE(oracle() != nullptr);
    const Trajectory run = run_scene(scene_name, {}, changes);
    const Trajectory wanted = run_by_oracle(run.scene);
    REQUIRE(run.frames.size() == wanted.frames.size());
    for (std::size_t n = 0; n < run.frames.size(); ++n)
        for (std::size_t i = 0; i < run.frames[n].solids.size(); ++i) {
            const SolidFrame &found = run.frames[n].solids[i], &exact = wanted.frames[n].solids[i];
            double scale = 0;
            for (const Vector3d& x : exact.positions)
                scale = std::max(scale, x.norm());
            INFO(fmt::format("nodes of '{}' after step {} of scene {} (t = {:.6g} s)",
                             run.scene.solids[i].name, n, scene_name, run.frames[n].time));
            REQUIRE_THAT(found.positions, IsClose(exact.positions, Rounding(multiple, scale)));
        }
}

} // namespace rigor::testing
