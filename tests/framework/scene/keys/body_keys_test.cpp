// SPDX-License-Identifier: MIT
// Keys of a body that brake it, keep it from turning, or let it pass through others.
#include "errors/input_error.hpp"
#include "rigid/step/step.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/run/run_scene.hpp"
#include "support/catch.hpp"

#include <cmath>

namespace body_keys_test {

using namespace rigor;

namespace {

// A scene of 2 s with a ball of 1 kg, which has these keys in line 2, and with further bodies.
std::string scene_with(const std::string& keys, const std::string& bodies = "",
                       const std::string& gravity = "[0, 0, 0]")
{
    return R"({"gravity": )" + gravity + R"(, "end": 2, "bodies": [
{"name": "ball", "shape": {"sphere": {"radius": 0.5}}, "mass": 1, )" +
           keys + "}" + (bodies.empty() ? "" : ",\n" + bodies) + "]}";
}

std::string refusal(const std::string& keys)
{
    try {
        parse_scene(scene_with(keys), "s");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

std::string refusal_of_static(const std::string& key)
{
    try {
        parse_scene(R"({"bodies": [
{"name": "a", "shape": {"sphere": {"radius": 1}}, "static": true, )" +
                        key + "}]}",
                    "s");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

World run(const std::string& text, double time_step = 0.01, double end = 2)
{
    World world = make_world(parse_scene(text, "s"));
    for (int i = 0; i < std::lround(end / time_step); ++i)
        step(world, time_step);
    return world;
}

} // namespace

TEST_CASE("drag: a body slows as its keys say")
{
    const World linear = run(scene_with(R"("velocity": [3, 0, 0], "drag": {"linear": 0.7})"));
    CHECK(std::abs(linear.bodies[0].state.velocity.x() - 3 * std::exp(-1.4)) < 1e-7);
    const World quadratic = run(scene_with(R"("velocity": [3, 0, 0], "drag": {"quadratic": 0.7})"));
    CHECK(std::abs(quadratic.bodies[0].state.velocity.x() - 3 / (1 + 0.7 * 3 * 2)) < 1e-7);
    const World turning =
        run(scene_with(R"("angular_velocity": [0, 4, 0], "drag": {"turning": 0.05})"));
    CHECK(std::abs(turning.bodies[0].state.angular_momentum.y() - 0.4 * std::exp(-1)) < 1e-7);
}

TEST_CASE("drag: a body that rests in a medium sleeps and wakes")
{
    const std::string floor = R"({"name": "floor", "shape": {"plane": {}}, "static": true})";
    const std::string ball =
        R"("position": [0, 0.5, 0], "velocity": [0.3, 0, 0], "angular_velocity": [0, 0, -0.6],
           "restitution": 0, "drag": {"linear": 5, "turning": 5})";
    const World world = run(scene_with(ball, floor, "[0, -9.81, 0]"), 0.01, 6);
    CHECK(world.bodies[0].rest.is_asleep());
    // A rolling ball with M V̇ = -c V - F and I V̇/R = -d V/R + F R slows with
    // (c + d/R²)/(M + I/R²).
    CHECK(std::abs(world.bodies[0].state.position.x() - 0.3 * 1.4 / (5 + 5 / 0.25)) < 1e-3);
}

TEST_CASE("turning: a body that may not turn does not, and one with an axis only about it")
{
    const std::string bar = R"("orientation": {"axis": [1, 2, 3], "degrees": 40})";
    const std::string hit = R"({"name": "shot", "shape": {"sphere": {"radius": 0.1}}, "mass": 1,
        "position": [-1, 0.3, 0.2], "velocity": [5, 0, 0], "friction": 1})";
    const World never = run(scene_with(bar + R"(, "turns": false)", hit));
    const World free = run(scene_with(bar, hit));
    const World hinged = run(scene_with(bar + R"(, "turns_about": [0, 0, 2])", hit));
    const Quaternion start = never.bodies[0].state.orientation;
    const Quaternion first =
        make_world(parse_scene(scene_with(bar), "s")).bodies[0].state.orientation;
    CHECK((start.v - first.v).norm() < 1e-15);
    CHECK(never.bodies[0].state.angular_momentum.norm() == 0);
    CHECK(never.bodies[0].state.velocity.x() > 0.1);
    CHECK(free.bodies[0].state.angular_momentum.head<2>().norm() > 1e-3);
    const Vector3d L = hinged.bodies[0].state.angular_momentum;
    CHECK(std::abs(L.z()) > 1e-3);
    CHECK(L.head<2>().norm() < 1e-12);
}

TEST_CASE("turning: about its axis a body turns by its moment about it")
{
    // A beam that turns about an axis between its own axes. Only the part of the torque along this
    // axis turns it.
    const std::string text = R"({"gravity": [0, 0, 0], "bodies": [
        {"name": "beam", "shape": {"box": {"size": [1, 2, 0.5]}}, "density": 12,
         "turns_about": [1, 1, 0]}],
        "forces": [{"body": "beam", "torque": [3, 1, 7]}]})";
    const World world = run(text);
    // I = (4.25, 1.25, 5) about x, y, z for 12 kg; a = (1, 1, 0)/√2: aᵀ I a = 2.75
    const RigidBody& beam = world.bodies[0];
    const double angle = 2 * std::atan2(beam.state.orientation.v.norm(), beam.state.orientation.s);
    CHECK(std::abs(angle - 4 / std::sqrt(2.) / 2.75 * 2 * 2 / 2) < 1e-6);
    const Vector3d axis = beam.state.orientation.v.normalized();
    CHECK((axis - Vector3d(1, 1, 0) / std::sqrt(2.)).norm() < 1e-12);
}

TEST_CASE("group: bodies of one group pass through each other and no others")
{
    const std::string keys = R"("velocity": [2, 0, 0], "restitution": 1, "friction": 0)";
    const std::string other = R"({"name": "other", "shape": {"sphere": {"radius": 0.5}}, "mass": 1,
        "position": [2, 0, 0], "restitution": 1, "friction": 0)";
    const auto speed = [&](const std::string& one, const std::string& two) {
        return run(scene_with(keys + one, other + two + "}")).bodies[0].state.velocity.x();
    };
    CHECK(speed("", "") == 0);
    CHECK(speed(R"(, "group": "a")", "") == 0);
    CHECK(speed(R"(, "group": "a")", R"(, "group": "b")") == 0);
    CHECK(speed(R"(, "group": "a")", R"(, "group": "a")") == 2);
}

TEST_CASE("body: what makes no sense of drag and turning is refused")
{
    CHECK(refusal(R"("drag": {})") ==
          "s:2: expected a \"linear\", \"quadratic\" or \"turning\" drag > 0, found {}");
    CHECK(refusal(R"("drag": {"linear": -1})") == "s:2: expected a drag ≥ 0, found -1");
    CHECK(refusal(R"("drag": {"linaer": 1})") ==
          "s:2: unknown key \"linaer\"; did you mean \"linear\"?");
    CHECK(refusal(R"("turns": 0)") == "s:2: expected true or false, found 0");
    CHECK(
        refusal(R"("turns_about": [0, 0, 0])").rfind("s:2: expected an axis that is not zero", 0) ==
        0);
    CHECK(refusal(R"("turns": false, "turns_about": [1, 0, 0])") ==
          "s:2: expected either \"turns\": false or \"turns_about\", found both");
    CHECK(refusal(R"("turns": false, "angular_velocity": [1, 0, 0])") ==
          "s:2: expected no angular velocity of a body that never turns, found one");
    CHECK(refusal(R"("turns_about": [0, 1, 0], "angular_velocity": [1, 1, 0])") ==
          "s:2: expected an angular velocity about \"turns_about\", found another axis");
    CHECK(refusal(R"("turns_about": [0, 2, 0], "angular_velocity": [0, -1, 0])") == "accepted");
    CHECK(refusal(R"("turns": true)") == "accepted");
    CHECK(refusal_of_static(R"("drag": {"linear": 1})") ==
          "s:2: expected no \"drag\" of a body that is static or driven, found one");
    CHECK(refusal_of_static(R"("turns": false)") ==
          "s:2: expected no \"turns\" of a body that is static or driven, found one");
    CHECK(refusal(R"("group": "")").find("s:2: expected the name of a group") == 0);
}

} // namespace body_keys_test
