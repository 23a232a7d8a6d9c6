// SPDX-License-Identifier: MIT
#include "errors/input_error.hpp"
#include "geometry/meshes/generators.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "scene/keys/scene_keys.hpp"
#include "support/close.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>
#include <fstream>

using namespace rigor;
using namespace rigor::testing;

namespace {

std::string bodies_of(const std::vector<std::string>& shapes)
{
    std::string text;
    for (std::size_t i = 0; i < shapes.size(); ++i)
        text += std::string(i ? ",\n" : "") + "{\"name\": \"" + std::to_string(i) +
                "\", \"shape\": " + shapes[i] + "}";
    return "{\"bodies\": [\n" + text + "]}";
}

Shape shape_of(const std::string& shape)
{
    return parse_scene(bodies_of({shape}), "s").bodies.at(0).parts.at(0).shape;
}

const SolidMesh& solid(const Scene& scene, std::size_t body)
{
    return *std::get<Mesh>(scene.bodies.at(body).parts.at(0).shape).solid;
}

template <class Read> std::string refusal(const Read& read)
{
    try {
        read();
    } catch (const InputError& error) {
        const std::string message = error.what();
        CHECK(message.find('\n') == std::string::npos);
        return message.substr(message.rfind('/') == std::string::npos ? 0 : message.rfind('/') + 1);
    }
    return "accepted";
}

std::string refused(const std::string& shape)
{
    return refusal([&] { shape_of(shape); });
}

const std::string tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

} // namespace

TEST_CASE("shapes: each is what its keys say")
{
    const auto cylinder =
        std::get<Cylinder>(shape_of(R"({"cylinder": {"radius": 1, "height": 2}})"));
    CHECK((cylinder.radius == 1 && cylinder.height == 2));
    const auto cone = std::get<Cone>(shape_of(R"({"cone": {"radius": 1, "height": 2}})"));
    CHECK((cone.radius == 1 && cone.height == 2));
    const auto capsule = std::get<Capsule>(shape_of(R"({"capsule": {"radius": 1, "height": 2}})"));
    CHECK((capsule.radius == 1 && capsule.height == 2));
    const auto torus = std::get<Torus>(shape_of(R"({"torus": {"radius": 2, "tube": 1}})"));
    CHECK((torus.radius == 2 && torus.tube == 1));
    CHECK(std::get<Ellipsoid>(shape_of(R"({"ellipsoid": {"radii": [1, 2, 3]}})")).radii ==
          Vector3d(1, 2, 3));
}

TEST_CASE("shapes: a generated mesh has the volume of its keys")
{
    CHECK_THAT(volume(shape_of(R"({"cross": {"length": 3, "width": 1}})")),
               IsClose(7.0, Rounding(64)));
    CHECK_THAT(volume(shape_of(R"({"angle": {"size": [1, 2, 0.5], "width": 0.3}})")),
               IsClose(0.405, Rounding(64)));
    const Scene scene = parse_scene(
        bodies_of(
            {R"({"ring": {"inner_radius": 0.5, "outer_radius": 1, "height": 0.3, "cells": 20}})",
             R"({"bowl": {"radius": 1, "thickness": 0.1, "sides": 24}})",
             R"({"gear": {"teeth": 12, "radius": 1, "thickness": 0.2, "bore": 0.3}})",
             R"({"voussoir": {"inner_radius": 1, "outer_radius": 1.3, "degrees": 15, "thickness": 1}})"}),
        "s");
    const LevelSet& grid = solid(scene, 0).level_set([] {});
    CHECK_THAT(grid.cell_size, IsClose(2.0 / 20, Rounding(8)));
    CHECK(solid(scene, 0).name() == "ring");
    CHECK(solid(scene, 0).mesh().vertices.size() == 4 * 48);
    CHECK(solid(scene, 2).mesh().vertices.size() == 12 * 4 * 4);
    CHECK(solid(scene, 3).mesh().vertices.size() == 8);
}

TEST_CASE("shapes: bodies of one mesh share it")
{
    const std::string gear = R"({"gear": {"teeth": 12, "radius": 1, "thickness": 0.2}})";
    const std::string finer =
        R"({"gear": {"teeth": 12, "radius": 1, "thickness": 0.2, "cells": 64}})";
    const std::string larger = R"({"gear": {"teeth": 13, "radius": 1, "thickness": 0.2}})";
    const Scene scene = parse_scene(bodies_of({gear, gear, finer, larger}), "s");
    CHECK(&solid(scene, 0) == &solid(scene, 1));
    CHECK(&solid(scene, 0) != &solid(scene, 2));
    CHECK(&solid(scene, 0) != &solid(scene, 3));
}

TEST_CASE("shapes: sizes that cannot be are refused")
{
    CHECK(refused(R"({"cylinder": {"radius": -1, "height": 2}})") ==
          "s:2: expected a radius > 0, found -1");
    CHECK(refused(R"({"cylinder": {"radius": 1}})") ==
          "s:2: expected a \"height\" in the cylinder, found {\"radius\": …}");
    CHECK(refused(R"({"cone": {"radius": 1, "height": 0}})") ==
          "s:2: expected a height > 0, found 0");
    CHECK(refused(R"({"torus": {"radius": 1, "tube": 1.5}})") ==
          "s:2: expected a tube < 1, found 1.5");
    CHECK(refused(R"({"torus": {"radius": 1, "tube": 1}})") == "s:2: expected a tube < 1, found 1");
    CHECK(refused(R"({"ellipsoid": {"radii": [1, 0, 2]}})") ==
          "s:2: expected a radius > 0, found 0");
    CHECK(refused(R"({"cylnder": {}})") ==
          "s:2: unknown key \"cylnder\"; did you mean \"cylinder\"?");
    CHECK(refused(R"({"sphere": {"radius": 1}, "plane": {}})")
              .rfind("s:2: expected a shape {\"sphere\": …}", 0) == 0);
    CHECK(refused(R"({"ring": {"inner_radius": 1, "outer_radius": 1, "height": 1}})") ==
          "s:2: expected a inner_radius < 1, found 1");
    CHECK(
        refused(R"({"ring": {"inner_radius": 1, "outer_radius": 1.000000000001, "height": 1e12}})")
            .rfind("s:2: the mesh of the ring: expected ", 0) == 0);
    CHECK(refused(R"({"gear": {"teeth": 3, "radius": 1, "thickness": 1}})") ==
          "s:2: expected a number of teeth, a whole number from 4 to 200, found 3");
    CHECK(refused(R"({"gear": {"teeth": 12, "radius": 1, "thickness": 1, "bore": 0.9}})") ==
          "s:2: expected a bore < 0.84292, found 0.9");
    CHECK(refused(R"({"bowl": {"radius": 1, "thickness": 2}})") ==
          "s:2: expected a thickness < 1, found 2");
    CHECK(refused(R"({"cross": {"length": 1, "width": 2}})") ==
          "s:2: expected a width < 1, found 2");
    CHECK(refused(R"({"cross": {"length": 2, "width": 1, "cells": 1000}})") ==
          "s:2: expected a number of cells, a whole number from 8 to 128, found 1000");
    CHECK(refused(R"({"mesh": {}})") == "s:2: expected a \"file\" in the mesh, found {}");
}

TEST_CASE("shapes: a mesh file travels inside the scene that names it")
{
    const TemporaryFolder folder;
    folder.write("tetra.obj", "# by hand\nvn 0 0 1\n" + tetrahedron);
    const std::string text = bodies_of({R"({"mesh": {"file": "tetra.obj"}})",
                                        R"({"mesh": {"file": "tetra.obj", "scale": 2}})",
                                        R"({"mesh": {"file": "tetra.obj"}})"});
    const Scene loaded = load_scene(folder.write("s.json", text));
    const Scene sent = parse_scene(loaded.text, "elsewhere"); // as a worker or a trajectory has it
    for (const Scene* scene : {&loaded, &sent}) {
        CHECK_THAT(solid(*scene, 0).volume(), IsClose(1.0 / 6, Rounding(8)));
        CHECK_THAT(solid(*scene, 1).volume(), IsClose(8.0 / 6, Rounding(8)));
        CHECK(&solid(*scene, 0) == &solid(*scene, 2));
        CHECK(solid(*scene, 0).name() == "tetra.obj");
    }
    CHECK(sent.text == loaded.text);
    CHECK(load_scene(folder.write("again.json", loaded.text)).text == loaded.text);
    CHECK(refusal([&] { parse_scene(text, "s"); }) ==
          "s:2: expected the text of the mesh \"tetra.obj\" in \"meshes\", found none: load the "
          "scene from its file, which reads the mesh files");
    // Line numbers are those of the file.
    CHECK(refusal([&] {
              load_scene(folder.write("s.json", bodies_of({R"({"mesh": {"file": "tetra.obj"}})",
                                                           R"({"sphere": {"radius": -1}})"})));
          }) == "s.json:3: expected a radius > 0, found -1");
}

TEST_CASE("shapes: a bad mesh file is refused with its place")
{
    const TemporaryFolder folder;
    const std::string named =
        bodies_of({R"({"sphere": {"radius": 1}})", R"({"mesh": {"file": "m.obj"}})"});
    const auto load = [&] { return refusal([&] { load_scene(folder.write("s.json", named)); }); };
    const auto load_mesh = [&](const std::string& mesh) {
        folder.write("m.obj", mesh);
        return load();
    };
    CHECK(load().rfind("m.obj\"", 0) == 0); // … found nothing at ".../m.obj"
    CHECK(load_mesh("") ==
          "m.obj: expected vertices \"v x y z\" and faces \"f 1 2 3\", found none");
    CHECK(load_mesh("v 0 0 nan\n") ==
          "m.obj:1: expected a coordinate of at most 1e12 in size, found \"nan\"");
    CHECK(load_mesh(tetrahedron.substr(0, tetrahedron.size() - 8)) ==
          "m.obj:5: expected a closed surface, found the edge from (0, 1, 0) to (1, 0, 0) in one "
          "face only");
    CHECK(load_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n") ==
          "m.obj: expected faces that turn counter-clockwise seen from outside, found a volume of "
          "-0.166667 m³: flip all faces");
    CHECK(load_mesh("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n") ==
          "m.obj:4: expected a face with an area, found none at (0, 0, 0)");
    std::string crossing = tetrahedron;
    for (const char* vertex :
         {"v 0.1 0.1 -0.5\n", "v 1.1 0.1 -0.5\n", "v 0.1 1.1 -0.5\n", "v 0.1 0.1 0.5\n",
          "f -4 -2 -3\n", "f -4 -3 -1\n", "f -4 -1 -2\n", "f -3 -2 -1\n"})
        crossing += vertex;
    CHECK(load_mesh(crossing) == "m.obj:14: expected a surface that does not go through itself, "
                                 "found the face of line 14 crossing the face of line 5");
    std::string many = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 200'001; ++i)
        many += "f 1 2 3\n";
    CHECK(load_mesh(many) == "m.obj:200004: expected at most 200000 triangles, found more");
    // A scene that contains a bad mesh itself.
    CHECK(refusal([&] {
              parse_scene("{\"meshes\": {\"m.obj\":\n\"v 0 0 0\\nf 1 1 1\"}," + named.substr(1),
                          "s");
          }) == "s:2: \"m.obj\":2: expected a face with an area, found none at (0, 0, 0)");
}
