// SPDX-License-Identifier: MIT
// Mesh files of every format, scaled by axis, and open meshes as terrain.
#include "errors/input_error.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/step/step.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/run/run_scene.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>

namespace mesh_keys_test {

using namespace rigor;
using rigor::testing::TemporaryFolder;

namespace {

const std::string tetrahedron_off = "OFF 4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                    "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
// A gentle valley along z, made of two rectangles, 8 m wide.
const std::string valley = "v -4 1 -4\nv -4 1 4\nv 0 0 -4\nv 0 0 4\nv 4 1 -4\nv 4 1 4\n"
                           "f 1 2 4 3\nf 3 4 6 5\n";

std::string scene_of(const std::string& mesh, const std::string& bodies = "")
{
    return "{\"bodies\": [\n{\"name\": \"a\", \"shape\": {\"mesh\": " + mesh +
           "}, \"static\": true}" + bodies + "]}";
}

std::string refusal(const TemporaryFolder& folder, const std::string& mesh)
{
    try {
        load_scene(folder.write("s.json", scene_of(mesh)));
    } catch (const InputError& error) {
        const std::string message = error.what(), place = folder.path().string() + "/";
        return message.rfind(place, 0) == 0 ? message.substr(place.size()) : message;
    }
    return "accepted";
}

const TriangleMesh& mesh_of(const Scene& scene)
{
    return std::get<Mesh>(scene.bodies.at(0).parts.at(0).shape).solid->mesh();
}

} // namespace

TEST_CASE("mesh: a file in OFF or STL form travels inside the scene")
{
    const TemporaryFolder folder;
    folder.write("t.off", tetrahedron_off);
    const Scene loaded = load_scene(folder.write("s.json", scene_of("{\"file\": \"t.off\"}")));
    const Scene sent = parse_scene(loaded.text, "elsewhere");
    for (const Scene* scene : {&loaded, &sent})
        CHECK(mesh_of(*scene).triangles.size() == 4);
    folder.write("t.stl", "solid t\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                          "vertex 0 1 0\nendloop\nendfacet\nendsolid\n");
    CHECK(refusal(folder, "{\"file\": \"t.stl\"}")
              .rfind("t.stl:2: expected a closed surface, found the edge", 0) == 0);
    folder.write("bad.off", "OFF\n4 four 0\n");
    CHECK(refusal(folder, "{\"file\": \"bad.off\"}") ==
          "bad.off:2: expected the number of faces from 1 to 200000, found \"four\"");
}

TEST_CASE("mesh: a scale may differ along x, y and z")
{
    const TemporaryFolder folder;
    folder.write("t.off", tetrahedron_off);
    const Scene scene = load_scene(
        folder.write("s.json", scene_of("{\"file\": \"t.off\", \"scale\": [2, 3, 0.5]}")));
    Vector3d high = Vector3d::Zero();
    for (const Vector3d& v : mesh_of(scene).vertices)
        high = high.cwiseMax(v);
    CHECK(high == Vector3d(2, 3, 0.5));
    CHECK(refusal(folder, "{\"file\": \"t.off\", \"scale\": [2, 0, 1]}") ==
          "s.json:2: expected a scale > 0, found 0");
    CHECK(refusal(folder, "{\"file\": \"t.off\", \"scale\": [2, 1]}")
              .rfind("s.json:2: expected three of a scale > 0", 0) == 0);
}

TEST_CASE("mesh: an open mesh with a depth is ground")
{
    const TemporaryFolder folder;
    folder.write("valley.obj", valley);
    const std::string ball = ", {\"name\": \"ball\", \"shape\": {\"sphere\": {\"radius\": 0.3}}, "
                             "\"position\": [-2, 1, 0], \"restitution\": 0, \"friction\": 2}";
    const Scene scene = load_scene(
        folder.write("s.json", scene_of("{\"file\": \"valley.obj\", \"depth\": 2}", ball)));
    World world = make_world(scene);
    for (int i = 0; i < 60; ++i)
        step(world, 0.01);
    // The ball rolls down the slope, tan α = 1/4, and its center is R/cos α above the surface.
    const Vector3d& X = world.bodies[1].state.position;
    CHECK(X.x() > -1.95);
    CHECK(X.x() < -1);
    CHECK(std::abs(X.y() + X.x() / 4 - 0.3 * std::sqrt(17.) / 4) < 1e-3);

    CHECK(refusal(folder, "{\"file\": \"valley.obj\"}")
              .rfind("valley.obj:7: expected a closed surface", 0) == 0);
    CHECK(refusal(folder, "{\"file\": \"valley.obj\", \"depth\": 0}") ==
          "s.json:2: expected a depth > 0, found 0");
    folder.write("roof.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
    CHECK(refusal(folder, "{\"file\": \"roof.obj\", \"depth\": 1}")
              .find("counter-clockwise seen from above") != std::string::npos);
}

} // namespace mesh_keys_test
