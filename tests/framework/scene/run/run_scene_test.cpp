// SPDX-License-Identifier: MIT
#include "scene/keys/scene_keys.hpp"
#include "scene/run/run_scene.hpp"
#include "scene/trajectory/reader.hpp"
#include "scene/trajectory/statistics.hpp"
#include "support/close.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

Trajectory run(const Scene& scene, Record record)
{
    Trajectory trajectory;
    TrajectoryReader reader(trajectory);
    run_scene(scene, record, [&](std::span<const std::byte> bytes) { reader.feed(bytes); });
    return trajectory;
}

Scene dumbbell()
{
    return parse_scene(R"({"gravity": [0, -10, 0], "time_step": 0.01, "end": 0.5,
        "bodies": [{"name": "dumbbell", "parts": [
            {"shape": {"box": {"size": [1, 1, 1]}}, "density": 1},
            {"shape": {"box": {"size": [1, 1, 1]}}, "position": [4, 0, 0], "density": 3}],
            "position": [10, 20, 30], "orientation": {"axis": [0, 0, 1], "degrees": 90},
            "velocity": [1, 2, 3], "angular_velocity": [0, 0, 2]}],
        "forces": [{"body": "dumbbell", "force": [0, 40, 0], "point": [3, 0, 0]}]})",
                       "dumbbell");
}

} // namespace

TEST_CASE("make_world: object space has its origin at the center of mass")
{
    const World world = make_world(dumbbell());
    const RigidBody& body = world.bodies.at(0);
    CHECK_THAT(body.mass, IsClose(4.0, Rounding(4)));
    // Cubes of mass 1 and 3 are 3 m and 1 m from the center: I = Σ m/6 along the axis, plus Σ m d²
    // perpendicular to it.
    CHECK_THAT(body.inertia,
               IsClose(Matrix3d(Vector3d(4 / 6.0, 4 / 6.0 + 12, 4 / 6.0 + 12).asDiagonal()),
                       Rounding(16)));
    CHECK_THAT(body.parts.at(0).position, IsClose(Vector3d(-3, 0, 0), Rounding(8)));
    CHECK_THAT(body.parts.at(1).position, IsClose(Vector3d(1, 0, 0), Rounding(8)));
    CHECK_THAT(body.state.position, IsClose(Vector3d(10, 23, 30), Rounding(8)));
    CHECK_THAT(body.state.velocity, IsExactly(Vector3d(1, 2, 3)));
    CHECK_THAT(body.state.angular_momentum,
               IsClose(Vector3d(0, 0, 2 * (4 / 6.0 + 12)), Rounding(16)));
    CHECK_THAT(world.forces.at(0).point, IsClose(Vector3d::Zero(), Rounding(16, 3)));
}

TEST_CASE("make_world: a mass and inertia as given is taken as it is")
{
    const World world = make_world(parse_scene(R"({"bodies": [
        {"name": "a", "shape": {"sphere": {"radius": 1}}, "mass": 2, "inertia": [3, 3, 3]},
        {"name": "b", "shape": {"plane": {}}, "static": true, "position": [0, 1, 0]}]})",
                                               "given"));
    CHECK(world.bodies.at(0).mass == 2);
    CHECK_THAT(world.bodies[0].inertia, IsExactly(Matrix3d(3 * Matrix3d::Identity())));
    CHECK(world.bodies.at(1).mass == 0);
    CHECK(world.bodies[1].inverse.inverse_mass == 0);
    CHECK(world.bodies[1].state.position == Vector3d(0, 1, 0));
}

TEST_CASE("run: the force at the center of mass balances the weight")
{
    const Trajectory trajectory = run(dumbbell(), Record::every_step);
    CHECK(trajectory.complete);
    REQUIRE(trajectory.frames.size() == 51);
    const Frame& last = trajectory.frames.back();
    CHECK(last.step == 50);
    CHECK_THAT(last.bodies.at(0).position, IsClose(Vector3d(10.5, 24, 31.5), Rounding(200)));
    CHECK_THAT(last.bodies[0].velocity, IsClose(Vector3d(1, 2, 3), Rounding(200, 50)));
    CHECK(trajectory.counters.steps == 50);
}

TEST_CASE("run: frames are the same states as the steps they lie at")
{
    const Scene scene = dumbbell();
    const Trajectory all = run(scene, Record::every_step), frames = run(scene, Record::frames);
    REQUIRE(frames.frames.size() == static_cast<std::size_t>(frame_count(scene)));
    for (std::size_t k = 0; k < frames.frames.size(); ++k) {
        const Frame& frame = frames.frames[k];
        REQUIRE(frame.step == frame_step(scene, static_cast<std::int64_t>(k)));
        REQUIRE(encode_frame(frame) ==
                encode_frame(all.frames.at(static_cast<std::size_t>(frame.step))));
    }
}

TEST_CASE("run: advance continues a recorded state as the run did")
{
    const Scene scene = dumbbell();
    const Trajectory all = run(scene, Record::every_step);
    std::vector<Moment> starts;
    for (const Frame& frame : all.frames)
        if (frame.step <= 47) starts.emplace_back(frame.time, frame.bodies);
    const auto results = advance(scene, starts, 3);
    REQUIRE(results.size() == starts.size());
    for (std::size_t i = 0; i < results.size(); ++i)
        REQUIRE_THAT(results[i], IsExactly(all.frames.at(i + 3).bodies));
    CHECK_THROWS_AS(advance(scene, {{0.0, {}}}, 1), std::invalid_argument);
}

TEST_CASE("run: what advance returns for a state does not depend on the states before it")
{
    const Scene scene = parse_scene(R"({"gravity": [0, -10, 0], "time_step": 0.01, "end": 2,
        "bodies": [{"name": "floor", "static": true, "shape": {"plane": {}}},
                   {"name": "low", "shape": {"box": {"size": [1, 1, 1]}}, "density": 1,
                    "position": [0, 0.5, 0]},
                   {"name": "high", "shape": {"box": {"size": [1, 1, 1]}}, "density": 1,
                    "position": [0.2, 1.5, 0], "angular_velocity": [0, 0.5, 0]}]})",
                                    "two boxes");
    const Trajectory all = run(scene, Record::every_step);
    const Moment early(all.frames.front().time, all.frames.front().bodies),
        late(all.frames.back().time - 1, all.frames[all.frames.size() - 101].bodies);
    const auto alone = advance(scene, {early}, 80);
    CHECK_THAT(advance(scene, {late, early}, 80).back(), IsExactly(alone.front()));
    CHECK_THAT(advance(scene, {early, early}, 80).back(), IsExactly(alone.front()));
}

TEST_CASE("run: a spring keeps its energy")
{
    const Scene scene = parse_scene(R"({"gravity": [0, -10, 0], "time_step": 0.001, "end": 2,
        "bodies": [{"name": "bob", "shape": {"box": {"size": [1, 2, 3]}}, "density": 2,
                    "position": [1, 0, 0]}],
        "springs": [{"body1": "bob", "point1": [0, 1, 0.5], "point2": [0, 4, 0], "stiffness": 100,
                     "rest_length": 1}]})",
                                    "spring");
    const Trajectory trajectory = run(scene, Record::frames);
    const Statistics statistics(trajectory.scene, trajectory.bodies);
    const double before = statistics.of(trajectory.frames.front()).total_energy();
    for (const Frame& frame : trajectory.frames)
        CHECK_THAT(statistics.of(frame).total_energy(), IsClose(before, Order(1e-8 * 300)));
}
