// SPDX-License-Identifier: MIT
// Deformable solids in the scene language.
#include "deformable/elasticity/totals.hpp"
#include "errors/input_error.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/run/make_world.hpp"
#include "support/close.hpp"

#include <numbers>

namespace solid_keys_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

const std::string bar = R"("mesh": {"bar": {"size": [2, 1, 1], "cells": [2, 1, 1]}})";

// A scene with one solid. Its mesh is in line 2, and more of its keys are in line 3.
std::string scene_with(const std::string& keys, const std::string& mesh = bar)
{
    return "{\"solids\": [\n{\"name\": \"bar\", " + mesh + (keys.empty() ? "" : ",\n" + keys) +
           "}]}";
}

SolidDescription solid_with(const std::string& keys, const std::string& mesh = bar)
{
    return parse_scene(scene_with(keys, mesh), "s").solids.at(0);
}

template <class Read> std::string refusal_of(const Read& read)
{
    try {
        read();
    } catch (const InputError& error) {
        const std::string message = error.what();
        CHECK(message.find('\n') == std::string::npos);
        return message;
    }
    return "accepted";
}

std::string refused(const std::string& keys, const std::string& mesh = bar)
{
    return refusal_of([&] { parse_scene(scene_with(keys, mesh), "s"); });
}

} // namespace

TEST_CASE("solids: what is written is what is read")
{
    const SolidDescription solid = solid_with(R"("density": 7800, "youngs_modulus": 2e11,
        "poisson_ratio": 0.25, "damping": 0.001, "drag": 0.1, "yield_stress": 2.5e8,
        "strength": 4e8, "restitution": 0.2, "friction": 0.7, "integrator": "explicit",
        "fracture": "virtual_nodes", "position": [1, 2, 3], "velocity": [4, 5, 6],
        "angular_velocity": [7, 8, 9], "color": [0, 0.5, 1],
        "orientation": {"axis": [0, 0, 1], "degrees": 90})");
    CHECK(solid.name == "bar");
    CHECK(solid.mesh->tetrahedra.size() == 10);
    const SolidMaterial& material = solid.material;
    CHECK(material.density == 7800);
    CHECK(material.youngs_modulus == 2e11);
    CHECK(material.poisson_ratio == 0.25);
    CHECK(material.damping == 0.001);
    CHECK(material.drag == 0.1);
    CHECK(material.yield_stress == 2.5e8);
    CHECK(material.strength == 4e8);
    CHECK(material.surface.restitution == 0.2);
    CHECK(material.surface.friction == 0.7);
    CHECK(solid.integrator == NodeIntegrator::explicit_step);
    CHECK(solid.fracture_method == FractureMethod::virtual_nodes);
    CHECK(solid.position == Vector3d(1, 2, 3));
    CHECK(solid.velocity == Vector3d(4, 5, 6));
    CHECK(solid.angular_velocity == Vector3d(7, 8, 9));
    CHECK(solid.color.value() == Vector3d(0, 0.5, 1));
    CHECK(solid.handles.empty());

    const SolidDescription plain = solid_with("");
    CHECK(plain.material.yield_stress == never);
    CHECK(plain.material.strength == never);
    CHECK(plain.integrator == NodeIntegrator::implicit_step);
    CHECK(plain.fracture_method == FractureMethod::faces);
}

TEST_CASE("solids: handles and loads take the nodes of a box in the solid's frame")
{
    const std::string keys =
        R"("position": [0, 5, 0], "orientation": {"axis": [0, 0, 1], "degrees": 90},
        "handles": [{"region": {"from": [-1, -9, -9], "to": [-1, 9, 9]}, "axes": ["x", "z"],
                     "path": [{"time": 1, "displacement": [0, 1, 0]},
                              {"time": 3, "rotation": {"axis": [0, 2, 0], "degrees": 540}}],
                     "release": 4}],
        "loads": [{"region": {"from": [1, -9, -9], "to": [9, 9, 9]}, "force": [1, 2, 3],
                   "start": 1, "end": 2}])";
    const SolidDescription solid = solid_with(keys);
    const Handle& handle = solid.handles.at(0);
    REQUIRE(handle.nodes.size() == 4); // the nodes of an end face
    for (const int node : handle.nodes)
        CHECK(solid.mesh->vertices[node].x() == -1);
    CHECK(handle.axes == std::array<bool, 3>{true, false, true});
    CHECK(handle.release == 4);
    // The pivot is the middle of the end, (-1, 0, 0), rotated and moved.
    CHECK_THAT(handle.pivot, IsClose(Vector3d(0, 4, 0), Rounding(8, 5)));
    REQUIRE(handle.path.size() == 3); // the first is the start
    CHECK(handle.path[0].time == 0);
    CHECK(handle.path[0].displacement.isZero(0));
    CHECK(handle.path[1].displacement == Vector3d(0, 1, 0));
    CHECK(handle.path[2].time == 3);
    CHECK_THAT(handle.path[2].rotation, IsClose(Vector3d(0, 3 * std::numbers::pi, 0), Rounding(8)));
    const NodeLoad& load = solid.loads.at(0);
    CHECK(load.nodes.size() == 4);
    CHECK(load.force == Vector3d(1, 2, 3));
    CHECK(load.start == 1);
    CHECK(load.end == 2);

    const Scene scene = parse_scene(scene_with(keys), "s");
    const Vector3d moved = make_deformable_world(scene).solids.at(0).positions.at(handle.nodes[0]);
    CHECK_THAT(moved.y(), IsClose(4.0, Rounding(8, 5))); // x = -1 in the solid's frame
}

TEST_CASE("solids: a solid starts as a rigid body would move")
{
    const Scene scene = parse_scene(
        scene_with(
            R"("position": [1, 0, 0], "velocity": [0, 0, 3], "angular_velocity": [0, 2, 0])"),
        "s");
    const Deformable solid = make_deformable_world(scene).solids.at(0);
    for (std::size_t i = 0; i < solid.positions.size(); ++i) {
        const Vector3d r = solid.positions[i] - Vector3d(1, 0, 0);
        CHECK_THAT(solid.velocities[i],
                   IsClose(Vector3d(2 * r.z(), 0, 3 - 2 * r.x()), Rounding(32, 5)));
    }
    CHECK_THAT(totals(solid).momentum, IsClose(Vector3d(0, 0, 6000), Rounding(64, 6000)));
}

TEST_CASE("solids: a material that cannot be is refused")
{
    CHECK(refused("\"youngs_modulus\": -1") == "s:3: expected a Young's modulus > 0, found -1");
    CHECK(refused("\"youngs_modulus\": 0") == "s:3: expected a Young's modulus > 0, found 0");
    for (const char* ratio : {"0.5", "0.7", "-1", "-3"})
        CHECK(refused(std::string("\"poisson_ratio\": ") + ratio) ==
              std::string("s:3: expected a Poisson's ratio between -1 and 0.5, both excluded, "
                          "found ") +
                  ratio);
    CHECK(refused("\"poisson_ratio\": 0.499") == "accepted");
    CHECK(refused("\"strength\": 0") == "s:3: expected a strength > 0, found 0");
    CHECK(refused("\"yield_stress\": 0") == "s:3: expected a yield stress > 0, found 0");
    CHECK(refused("\"density\": -2") == "s:3: expected a density > 0, found -2");
    CHECK(refused("\"damping\": -2") == "s:3: expected a damping ≥ 0, found -2");
    CHECK(refused("\"drag\": -2") == "s:3: expected a drag ≥ 0, found -2");
    CHECK(refused("\"youngs_modulos\": 1") ==
          "s:3: unknown key \"youngs_modulos\"; did you mean \"youngs_modulus\"?");
    CHECK(
        refused("\"fracture\": \"face\"") ==
        "s:3: expected one of \"faces\", \"elements\", \"virtual_nodes\", found \"face\"; did you "
        "mean \"faces\"?");
    CHECK(refused("\"integrator\": \"euler\"") ==
          "s:3: expected one of \"explicit\", \"implicit\", \"velocity_modes\", \"matrix\", found "
          "\"euler\"");
}

TEST_CASE("solids: a handle or load that acts on nothing is refused")
{
    const auto handle = [](const std::string& keys) {
        return refused("\"handles\": [{" + keys + "}]");
    };
    const std::string region = R"("region": {"from": [-1, -1, -1], "to": [-1, 1, 1]})";
    CHECK(handle(region) == "accepted");
    CHECK(handle(R"("region": {"from": [5, -1, -1], "to": [6, 1, 1]})") ==
          "s:3: expected a region that holds a node of \"bar\" (from (-1, -0.5, -0.5) to (1, 0.5, "
          "0.5)), found none in it");
    CHECK(
        handle(R"("region": {"from": [1, -1, -1], "to": [-1, 1, 1]})") ==
        "s:3: expected a region whose \"to\" is nowhere below its \"from\", found (1, -1, -1) and "
        "(-1, 1, 1)");
    CHECK(handle(R"("region": {"from": [1, -1, -1]})") ==
          "s:3: expected a \"to\" in the region, found {\"from\": …}");
    CHECK(handle("") == "s:3: expected a \"region\" in the handle, found {}");
    CHECK(handle(region + R"(, "axes": [])") == "s:3: expected at least one axis, found []");
    CHECK(handle(region + R"(, "axes": ["w"])") ==
          "s:3: expected one of \"x\", \"y\", \"z\", found \"w\"");
    CHECK(handle(region + R"(, "path": [{"time": 1}, {"time": 1}])") ==
          "s:3: expected a time > 1, found 1");
    CHECK(handle(region + R"(, "path": [{"time": 0}])") == "s:3: expected a time > 0, found 0");
    CHECK(handle(region + R"(, "path": [])") == "s:3: expected at least one moment, found []");
    CHECK(handle(region +
                 R"(, "path": [{"time": 1, "rotation": {"axis": [0, 0, 0], "degrees": 1}}])") ==
          "s:3: expected an axis of length > 0, found [0, 0, 0]");
    CHECK(handle(region + R"(, "release": 0)") == "s:3: expected a time > 0, found 0");
    CHECK(refused("\"loads\": [{" + region + "}]") ==
          "s:3: expected a \"force\" in the load, found {\"region\": …}");
    CHECK(refused("\"loads\": [{" + region + R"(, "force": [1, 0, 0], "start": 2, "end": 1}])") ==
          "s:3: expected an end > 2, found 1");
}

TEST_CASE("solids: a scene needs a body or a solid and each its own name")
{
    const auto refused_scene = [](const std::string& text) {
        return refusal_of([&] { parse_scene(text, "s"); });
    };
    CHECK(refused_scene("{}") == "s:1: expected \"bodies\" or \"solids\" in the scene, found none");
    CHECK(refused_scene("{\n\"solids\": []}") ==
          "s:2: expected at least one body or solid, found []");
    CHECK(refused_scene("{\"bodies\": [],\n\"solids\": [{\"name\": \"a\", " + bar + "}]}") ==
          "accepted");
    CHECK(refused_scene("{\"solids\": [{\"name\": \"a\", " + bar + "},\n{\"name\": \"a\", " + bar +
                        "}]}") ==
          "s:2: expected a name of its own for each body and solid, found \"a\" twice");
    CHECK(
        refused_scene("{\"bodies\": [{\"name\": \"a\", \"shape\": {\"sphere\": {\"radius\": 1}}}],"
                      "\n\"solids\": [{\"name\": \"a\", " +
                      bar + "}]}") ==
        "s:2: expected a name of its own for each body and solid, found \"a\" twice");
    CHECK(refused_scene("{\"solids\": [{\"name\": \"a\"}]}") ==
          "s:1: expected a \"mesh\" in the solid \"a\", found none");
    CHECK(refused_scene("{\"solids\": [{" + bar + "}]}") ==
          "s:1: expected a \"name\" in the solid, found none");
}

TEST_CASE("solids: a mesh that is too large or not one kind is refused")
{
    const auto mesh = [](const std::string& text) { return refused("", "\"mesh\": " + text); };
    CHECK(mesh(R"({"ball": {"radius": 1, "layers": 2}})") == "accepted");
    CHECK(mesh(R"({"notched_plate": {"size": [2, 1, 1], "cells": [5, 2, 1], "notch": [1, 1]}})") ==
          "accepted");
    CHECK(mesh(R"({"notched_plate": {"size": [2, 1, 1], "cells": [5, 2, 1], "notch": [1, 2]}})") ==
          "s:2: expected a notch of fewer cells than 2 along y, found 2");
    CHECK(mesh(R"({"bar": {"size": [2, 1, 1], "cells": [100, 100, 100]}})") ==
          "s:2: expected cells of at most 200000 tetrahedra, found 5000000");
    CHECK(mesh(R"({"bar": {"size": [2, 1, 1], "cells": [2, 0, 1]}})") ==
          "s:2: expected a number of cells, a whole number from 1 to 1000, found 0");
    CHECK(mesh(R"({"bar": {"size": [2, 1, 1]}})") ==
          "s:2: expected a \"cells\" in the bar, found {\"size\": …}");
    CHECK(mesh(R"({"ball": {"radius": 1, "layers": 30}})") ==
          "s:2: expected a number of layers, a whole number from 1 to 29, found 30");
    CHECK(mesh(R"({"plaet": {}})") == "s:2: unknown key \"plaet\"; did you mean \"plate\"?");
    CHECK(mesh("{}") ==
          "s:2: expected a mesh {\"bar\": …}, {\"ball\": …} or {\"file\": \"x.msh\"}, found {}");
    const std::string big = R"({"bar": {"size": [2, 1, 1], "cells": [30, 30, 30]}})";
    CHECK(refusal_of([&] {
              parse_scene("{\"solids\": [{\"name\": \"a\", \"mesh\": " + big +
                              "},\n{\"name\": \"b\", \"mesh\": " + big + "}]}",
                          "s");
          }) == "s:2: expected solids of at most 200000 tetrahedra, found 270000");
}

} // namespace solid_keys_test
