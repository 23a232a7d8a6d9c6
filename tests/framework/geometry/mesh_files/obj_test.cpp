// SPDX-License-Identifier: MIT
#include "geometry/mesh_files/obj.hpp"
#include "geometry/meshes/generators.hpp"
#include "geometry/meshes/mesh_checks.hpp"
#include "support/close.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

// The error "line: message" of a text that is refused when it is read.
std::string refusal(const std::string& text)
{
    try {
        read_obj(text);
    } catch (const MeshError& error) {
        return std::to_string(error.line) + ": " + error.what();
    }
    return "accepted";
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

} // namespace

TEST_CASE("obj: a number has one sign", "[geometry]")
{
    REQUIRE(read_obj("v +1 -2 +3e+1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").mesh.vertices.at(0) ==
            Vector3d(1, -2, 30));
    for (const char* number : {"+-1", "-+1", "++1", "--1", "+", "-"})
        CHECK(refusal(std::string("v 0 0 ") + number + "\n") != "accepted");
}

TEST_CASE("obj: every way to write a face names the same vertices", "[geometry]")
{
    const std::vector<std::array<int, 3>> fan = {{0, 1, 2}, {0, 2, 3}};
    for (const char* face :
         {"f 1 2 3 4", "f 1/1 2/1 3/1 4/1", "f 1//7 2//7 3//7 4//7", "f 1/1/1 2/2/2 3/3/3 4/4/4",
          "f -4 -3 -2 -1", "f -4//1 2/5/6 -2/1 4", "  f\t1  2 3 \t4 \r"}) {
        CAPTURE(face);
        const SurfaceText read = read_obj(square + face + "\n");
        REQUIRE(read.mesh.triangles == fan);
        CHECK(read.lines == std::vector<int>{5, 5});
        CHECK(read.mesh.vertices.at(2) == Vector3d(1, 1, 0));
    }
}

TEST_CASE("obj: what is no vertex or face is skipped", "[geometry]")
{
    const SurfaceText read = read_obj("# a comment\nmtllib a.mtl\no name\nvn 0 0 1\nvt 0 0\n"
                                      "v +1e-3 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 9 9 9\nv 0 1 0\ng f\n"
                                      "usemtl m\ns off\nl 1 2\nf 1 2 4\n\n");
    REQUIRE(read.mesh.vertices.size() == 3); // the vertex that no face uses is removed
    CHECK(read.mesh.vertices[0] == Vector3d(1e-3, 0, 0));
    CHECK(read.mesh.vertices[2] == Vector3d(0, 1, 0));
    CHECK(read.mesh.triangles == std::vector<std::array<int, 3>>{{0, 1, 2}});
    CHECK(read.lines == std::vector<int>{14});
}

TEST_CASE("obj: a mesh written and read again has the same bits", "[geometry]")
{
    const TriangleMesh mesh = icosphere(0.1, 2);
    const TriangleMesh again = read_obj(obj_text(mesh)).mesh;
    REQUIRE(again.triangles.size() == mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i)
            REQUIRE(again.vertices[again.triangles[t][i]] == mesh.vertices[mesh.triangles[t][i]]);
}

TEST_CASE("obj: what cannot be read is refused in its line", "[geometry]")
{
    const std::string nothing =
        "0: expected vertices \"v x y z\" and faces \"f 1 2 3\", found none";
    CHECK(refusal("") == nothing);
    CHECK(refusal(square) == nothing);
    CHECK(refusal("\x7f"
                  "ELF\x02\x01\x01") == nothing);
    CHECK(refusal("v 0 0\n") ==
          "1: expected a coordinate of at most 1e12 in size, found the end of the line");
    CHECK(refusal("v 0 0 0\nv 0 nan 0\n") ==
          "2: expected a coordinate of at most 1e12 in size, found \"nan\"");
    CHECK(refusal("v 0 inf 0\n") ==
          "1: expected a coordinate of at most 1e12 in size, found \"inf\"");
    CHECK(refusal("v 0 1e999 0\n") ==
          "1: expected a coordinate of at most 1e12 in size, found \"1e999\"");
    CHECK(refusal("v 0 1,5 0\n") ==
          "1: expected a coordinate of at most 1e12 in size, found \"1,5\"");
    CHECK(refusal(square + "f 1 2\n") == "5: expected a face of at least three vertices, found 2");
    CHECK(refusal(square + "f 1 2 0\n") ==
          "5: expected a vertex from 1, or from -1 back to -4, found \"0\"");
    CHECK(refusal(square + "f 1 2 -5\n") ==
          "5: expected a vertex from 1, or from -1 back to -4, found \"-5\"");
    CHECK(refusal(square + "f 1 2 x\n") ==
          "5: expected a vertex from 1, or from -1 back to -4, found \"x\"");
    CHECK(refusal(square + "f 1 2 5\n") == "5: expected vertices from 1 to 4, found 5");
    CHECK(refusal(square + "f 1 2 99999999999\n") ==
          "5: expected a vertex from 1, or from -1 back to -4, found \"99999999999\"");
}

TEST_CASE("obj: five million faces are refused at the first too many", "[geometry]")
{
    std::string text = square;
    const std::size_t faces = 5'000'000;
    text.reserve(text.size() + 8 * faces);
    for (std::size_t i = 0; i < faces; ++i)
        text += "f 1 2 3\n";
    CHECK(refusal(text) == "200005: expected at most 200000 triangles, found more");
    text = square + "f";
    for (std::size_t i = 0; i < faces; ++i) // one face of five million vertices
        text += " 1";
    CHECK(refusal(text) == "5: expected at most 200000 triangles, found more");
    text.clear();
    for (std::size_t i = 0; i < most_mesh_vertices + 1; ++i)
        text += "v 0 0 0\n";
    CHECK(refusal(text) == "200001: expected at most 200000 vertices, found more");
}
