// SPDX-License-Identifier: MIT
#include "geometry/mesh_files/off.hpp"

#include "geometry/meshes/mesh_checks.hpp"
#include "support/catch.hpp"

namespace off_test {

using namespace rigor;

namespace {

std::string refusal(const std::string& text)
{
    try {
        read_off(text);
    } catch (const MeshError& error) {
        return std::to_string(error.line) + ": " + error.what();
    }
    return "accepted";
}

} // namespace

TEST_CASE("off: vertices from 0 and faces of any number of them", "[geometry]")
{
    // A pyramid on a square, with a comment, an unused vertex and colors.
    const SurfaceText read = read_off("OFF # a pyramid\n\n6 5 0\n0 0 0\n2 0 0\n2 0 2\n0 0 2\n"
                                      "1 3e0 1\n9 9 9\n4 0 1 2 3 255 0 0\n3 1 0 4\n3 2 1 4\n"
                                      "3 3 2 4 0.5 0.5 0.5\n3 0 3 4");
    CHECK(read.mesh.vertices.size() == 5);
    CHECK(read.mesh.triangles.size() == 6);
    CHECK(read.lines == std::vector<int>{10, 10, 11, 12, 13, 14});
    CHECK_NOTHROW(check_mesh(read.mesh, read.lines));
    CHECK(std::abs(signed_volume(read.mesh) - 4) < 1e-12);
    CHECK(read_off("OFF 3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").mesh.triangles.size() == 1);
}

TEST_CASE("off: what is wrong is told with its line", "[geometry]")
{
    CHECK(refusal("") == "0: expected \"OFF\", found the end of the file");
    CHECK(refusal("COFF\n1 1 1\n") == "1: expected \"OFF\" at the start, found \"COFF\"");
    CHECK(refusal("OFF\n") ==
          "1: expected the numbers of vertices and faces, found the end of the file");
    CHECK(refusal("OFF\n0 1 0\n") ==
          "2: expected the number of vertices from 1 to 200000, found \"0\"");
    CHECK(refusal("OFF\n3 x\n") == "2: expected the number of faces from 1 to 200000, found \"x\"");
    CHECK(refusal("OFF\n3 1 0\n0 0 0\n1 0\n") ==
          "4: expected a coordinate of at most 1e12 in size, found the end of the line");
    CHECK(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n") ==
          "4: expected another vertex, found the end of the file");
    const std::string three = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
    CHECK(refusal(three) == "5: expected another face, found the end of the file");
    CHECK(refusal(three + "3 0 1 3\n") == "6: expected a vertex from 0 to 2, found \"3\"");
    CHECK(refusal(three + "3 0 1\n") ==
          "6: expected a vertex from 0 to 2, found the end of the line");
    CHECK(refusal(three + "2 0 1\n") == "6: expected a face of at least three vertices, found 2");
    CHECK(refusal("OFF\n999999999999 1 0\n").find("from 1 to 200000") != std::string::npos);
}

} // namespace off_test
