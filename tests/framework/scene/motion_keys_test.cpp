// SPDX-License-Identifier: MIT
// Keys that say how bodies move and what pulls them: driven bodies, forces in time and in a body's
// frame, ropes, and what holds for a pair of bodies.
#include "deformable/step/step.hpp"
#include "errors/input_error.hpp"
#include "rigid/step/step.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/run/run_scene.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>

namespace motion_keys_test {

using namespace rigor;

namespace {

// Two bodies, "a" with these keys in line 2 and a ball "b"; more keys of the scene are in line 4.
std::string scene_with(const std::string& keys, const std::string& scene = "")
{
    return R"({"gravity": [0, 0, 0], "end": 2, "bodies": [
{"name": "a", "shape": {"box": {"size": [1, 1, 1]}})" +
           (keys.empty() ? "" : ", " + keys) + R"(},
{"name": "b", "shape": {"sphere": {"radius": 0.5}}, "density": 100, "position": [5, 0, 0]}])" +
           (scene.empty() ? "" : ",\n" + scene) + "}";
}

std::string refusal(const std::string& keys, const std::string& scene = "")
{
    try {
        parse_scene(scene_with(keys, scene), "s");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

World world_with(const std::string& keys, const std::string& scene = "")
{
    return make_world(parse_scene(scene_with(keys, scene), "s"));
}

// The place of body "a" after 2 s.
RigidState moved(const std::string& keys)
{
    const Scene scene = parse_scene(scene_with(keys), "s");
    World world = make_world(scene);
    for (std::int64_t i = 0; i < step_count(scene); ++i)
        step(world, scene.time_step);
    return world.bodies.at(0).state;
}

} // namespace

TEST_CASE("driven: a body moves as its keys say, from its place in the scene")
{
    const RigidState steady = moved(R"("position": [1, 2, 3],
        "driven": {"velocity": [0.5, 0, -1], "start": 0.5, "end": 1.5})");
    CHECK((steady.position - Vector3d(1.5, 2, 2)).norm() < 1e-14);
    const RigidState turned = moved(R"("driven": {"angular_velocity": [0, 3, 0]})");
    CHECK(turned.position.norm() == 0);
    CHECK(std::abs(turned.orientation.s - std::cos(3)) < 1e-12);
    CHECK(std::abs(turned.orientation.v.y() - std::sin(3)) < 1e-12);
    const RigidState swung = moved(R"("position": [0, 1, 0], "driven": {
        "amplitude": [0, 0.2, 0], "frequency": 0.3, "phase_degrees": 30})");
    const double phase = std::numbers::pi / 6;
    const double swing = std::sin(2 * std::numbers::pi * 0.3 * 2 + phase) - std::sin(phase);
    CHECK((swung.position - Vector3d(0, 1 + 0.2 * swing, 0)).norm() < 1e-13);
    const RigidState belt = moved(R"("driven": {"velocity": [1, 0, 0], "belt": true})");
    CHECK(belt.position.norm() == 0);
}

TEST_CASE("driven: each body of a grid moves from its own place")
{
    const World world = world_with(R"("driven": {"velocity": [1, 0, 0]},
        "grid": {"count": [2, 1, 1], "spacing": [0, 3, 0]})");
    const World beside = world_with(R"("driven": {"velocity": [1, 0, 0]},
        "grid": {"count": [2, 1, 1], "spacing": [2, 0, 0]})");
    CHECK((driven_state(*world.bodies.at(1).drive, 1).position - Vector3d(1, 0, 0)).norm() < 1e-15);
    CHECK((driven_state(*beside.bodies.at(1).drive, 1).position - Vector3d(3, 0, 0)).norm() <
          1e-15);
}

TEST_CASE("driven: what it cannot be is refused")
{
    const std::string motion = R"("driven": {"velocity": [1, 0, 0]})";
    CHECK(refusal(motion) == "accepted");
    CHECK(refusal("\"static\": true, " + motion) ==
          "s:2: expected either \"static\" or \"driven\", found both");
    CHECK(refusal("\"velocity\": [1, 0, 0], " + motion) ==
          "s:2: expected the motion of a driven body in \"driven\" alone, found it in the body "
          "too");
    for (const std::string key : {"mass", "density"})
        CHECK(refusal("\"" + key + "\": 2, " + motion) ==
              "s:2: expected no \"" + key +
                  "\" of the driven body \"a\", whose motion is given, found one");
    CHECK(refusal(R"("driven": {"velocity": [0, 0, 0]})")
              .rfind("s:2: expected a velocity, an angular velocity or an amplitude that is not "
                     "zero",
                     0) == 0);
    CHECK(refusal(R"("driven": {"amplitude": [1, 0, 0]})") ==
          "s:2: expected \"frequency\" beside \"amplitude\", found none");
    CHECK(refusal(R"("driven": {"velocity": [1, 0, 0], "frequency": 2})") ==
          "s:2: expected \"amplitude\" beside \"frequency\", found none");
    CHECK(refusal(R"("driven": {"velocity": [1, 0, 0], "phase_degrees": 2})") ==
          "s:2: expected \"amplitude\" beside \"phase_degrees\", found none");
    CHECK(refusal(R"("driven": {"velocity": [1, 0, 0], "start": 2, "end": 1})") ==
          "s:2: expected an end > 2, found 1");
    CHECK(refusal(R"("driven": {"speed": 1})").rfind("s:2: unknown key \"speed\"", 0) == 0);
    try {
        parse_scene(R"({"bodies": [{"name": "p", "shape": {"plane": {}},
            "driven": {"velocity": [0, 1, 0]}}]})",
                    "s");
        FAIL("a driven plane was accepted");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()) == "s:2: expected a shape of finite size for the driven "
                                           "body \"p\", found a plane");
    }
}

// A soft cube at rest, which a driven box reaches after 0.2 s and pushes along.
TEST_CASE("driven: a body pushes a deformable solid in front of it")
{
    const Scene scene = parse_scene(R"({"gravity": [0, 0, 0], "time_step": 0.005, "end": 1,
        "bodies": [{"name": "ram", "shape": {"box": {"size": [1, 2, 2]}}, "position": [-1.1, 0, 0],
                    "restitution": 0, "friction": 0, "driven": {"velocity": [0.5, 0, 0]}}],
        "solids": [{"name": "cube", "mesh": {"bar": {"size": [1, 1, 1], "cells": [2, 2, 2]}},
                    "restitution": 0, "friction": 0, "youngs_modulus": 1e5, "damping": 0.02}]})",
                                    "s");
    DeformableWorld world = make_deformable_world(scene);
    for (std::int64_t i = 0; i < step_count(scene); ++i)
        step(world, scene.time_step);
    double least = 1e9, mean = 0; // the nodes' least place [m] and mean velocity [m/s], along x
    const Deformable& cube = world.solids.at(0);
    for (std::size_t i = 0; i < cube.positions.size(); ++i) {
        least = std::min(least, cube.positions[i].x());
        mean += cube.velocities[i].x() / static_cast<double>(cube.positions.size());
    }
    const double front = world.rigid.bodies.at(0).state.position.x() + 0.5;
    CHECK(std::abs(front - -0.1) < 1e-12);
    CHECK(least > front - 0.01);
    CHECK(mean > 0.45);
}

TEST_CASE("force: a factor is an expression of the time")
{
    const Scene scene = parse_scene(
        scene_with("", R"("forces": [{"body": "b", "force": [2, 0, 0], "factor": "3*t^2"}])"), "s");
    World world = make_world(scene);
    CHECK(world.forces.at(0).factor(2) == 12);
    for (std::int64_t i = 0; i < step_count(scene); ++i)
        step(world, scene.time_step);
    const RigidBody& b = world.bodies.at(1); // V = F t³/M
    CHECK(std::abs(b.state.velocity.x() - 2 * 8 / b.mass) < 1e-9);
    CHECK(refusal("", R"("forces": [{"body": "b", "force": [1, 0, 0], "factor": 2}])") ==
          "s:4: expected an expression of t in quotes, found 2");
    CHECK(refusal("", R"("forces": [{"body": "b", "force": [1, 0, 0], "factor": "2*"}])")
              .rfind("s:4: expected a number", 0) == 0);
    CHECK(refusal("", R"("forces": [{"body": "b", "force": [1, 0, 0], "factor": "1/t"}])") ==
          "s:4: expected a factor that is finite at t = 0, found \"1/t\"");
}

TEST_CASE("force: torque, frame and frequency are read")
{
    const World world = world_with("", R"("forces": [{"body": "b", "torque": [1, 2, 3],
        "frame": "body", "frequency": 4, "phase_degrees": 90}, {"body": "b", "force": [1, 0, 0]}])");
    const AppliedForce& swings = world.forces.at(0);
    CHECK(swings.torque == Vector3d(1, 2, 3));
    CHECK(swings.force == Vector3d(0, 0, 0));
    CHECK(swings.turns_with_body);
    CHECK(swings.frequency == 4);
    CHECK(std::abs(swings.phase - std::numbers::pi / 2) < 1e-15);
    const AppliedForce& plain = world.forces.at(1);
    CHECK(plain.torque == Vector3d(0, 0, 0));
    CHECK_FALSE(plain.turns_with_body);
    CHECK(plain.frequency == 0);
    CHECK(refusal("", R"("forces": [{"body": "b"}])")
              .rfind("s:4: expected a \"force\" or a \"torque\" in it", 0) == 0);
    CHECK(refusal("", R"("forces": [{"body": "b", "force": [1, 0, 0], "frequency": 0}])") ==
          "s:4: expected a frequency > 0, found 0");
    CHECK(refusal("", R"("forces": [{"body": "b", "force": [1, 0, 0], "phase_degrees": 3}])") ==
          "s:4: expected \"frequency\" beside \"phase_degrees\", found none");
    CHECK(refusal("", R"("forces": [{"body": "b", "force": [1, 0, 0], "frame": "object"}])")
              .rfind("s:4: expected one of \"world\", \"body\", found \"object\"", 0) == 0);
}

TEST_CASE("spring: a rope only pulls")
{
    const std::string ends = R"("springs": [{"body1": "a", "body2": "b", "stiffness": 2)";
    CHECK_FALSE(world_with("", ends + "}]").springs.at(0).only_pulls);
    CHECK(world_with("", ends + R"(, "only_pulls": true}])").springs.at(0).only_pulls);
}

TEST_CASE("pairs: what holds for two bodies is read and sorted")
{
    const World world = world_with("", R"("pairs": [{"body1": "b", "body2": "a",
        "restitution": 0.25, "friction": 2}])");
    const PairLaw& law = world.pair_laws.at(0);
    CHECK(law.body1 == 0);
    CHECK(law.body2 == 1);
    CHECK(law.restitution == 0.25);
    CHECK(law.friction == 2.0);
    CHECK(law.collides);
    const auto refused = [](const std::string& pair) {
        return refusal("", "\"pairs\": [" + pair + "]");
    };
    CHECK(refused(R"({"body1": "a", "body2": "b", "collide": false})") == "accepted");
    CHECK(refused(R"({"body1": "a", "body2": "c", "collide": false})")
              .rfind("s:4: expected the name of a body, found \"c\"", 0) == 0);
    CHECK(refused(R"({"body1": "a", "body2": "a", "collide": false})") ==
          "s:4: expected two different bodies, found \"a\"");
    CHECK(refused(R"({"body1": "a", "collide": false})")
              .rfind("s:4: expected \"body1\" and \"body2\" in the pair", 0) == 0);
    CHECK(refused(R"({"body1": "a", "body2": "b"})")
              .rfind("s:4: expected \"restitution\", \"friction\" or \"collide\" in the pair", 0) ==
          0);
    CHECK(refused(R"({"body1": "a", "body2": "b", "restitution": 2})") ==
          "s:4: expected a restitution from 0 to 1, found 2");
    CHECK(refused(R"({"body1": "a", "body2": "b", "friction": 1},
                     {"body1": "b", "body2": "a", "friction": 2})") ==
          "s:5: expected each pair once, found \"b\" and \"a\" again");
}

TEST_CASE("motion: forces and springs need a body that can move")
{
    const std::string fixed = "\"static\": true",
                      refused = "s:4: expected a body that can move, found \"a\", which is static "
                                "or driven",
                      force = R"("forces": [{"body": "a", "force": [1, 0, 0]}])",
                      spring = R"("springs": [{"body1": "a", "stiffness": 1}])",
                      to_the_other = R"("springs": [{"body1": "a", "body2": "b", "stiffness": 1}])";
    CHECK(refusal("", force) == "accepted");
    CHECK(refusal(fixed, force) == refused);
    CHECK(refusal("", spring) == "accepted");
    CHECK(refusal(fixed, spring) == refused);
    CHECK(refusal(fixed, to_the_other) == "accepted");
}

} // namespace motion_keys_test
