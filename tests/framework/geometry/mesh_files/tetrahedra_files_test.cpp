// SPDX-License-Identifier: MIT
#include "geometry/mesh_files/tetrahedra_files.hpp"
#include "geometry/tetrahedra/tetrahedra_checks.hpp"
#include "geometry/tetrahedra/tetrahedra_generators.hpp"

#include "support/close.hpp"

namespace tetrahedra_files_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

std::string refusal(const std::string& text)
{
    try {
        read_tetrahedra(text);
    } catch (const MeshError& error) {
        return std::to_string(error.line) + ": " + error.what();
    }
    return "accepted";
}

const std::string msh2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                         "$PhysicalNames\n1\n3 1 \"solid part\"\n$EndPhysicalNames\n"
                         "$Nodes\n5\n10 9 9 9\n1 0 0 0\n2 1 0 0\n7 0 1 0\n4 0 0 1e0\n$EndNodes\n"
                         "$Elements\n3\n1 15 2 0 1 10\n2 2 2 0 1 1 2 7\n3 4 2 0 1 1 2 7 4\n"
                         "$EndElements\n";
const std::string msh4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
                         "$Entities\n1 0 0 1\n1 0 0 0 0\n1 0 0 0 1 1 1 0 0\n$EndEntities\n"
                         "$Nodes\n2 5 1 10\n0 1 0 1\n10\n9 9 9\n3 1 0 4\n1\n2\n7\n4\n0 0 0\n1 0 0\n"
                         "0 1 0\n0 0 1\n$EndNodes\n"
                         "$Elements\n2 2 1 2\n2 1 2 1\n1 1 2 7\n3 1 4 1\n2 1 2 7 4\n$EndElements\n";
const std::string medit = "MeshVersionFormatted 1\n# a comment\nDimension\n3\n\nVertices\n5\n"
                          "9 9 9 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\nTriangles\n1\n2 3 4 0\n"
                          "Tetrahedra\n1\n2 3 4 5 0\nEnd\n";

std::string replaced(std::string text, const std::string& old_part, const std::string& new_part)
{
    return text.replace(text.find(old_part), old_part.size(), new_part);
}

} // namespace

TEST_CASE("tetrahedra: every format gives the same mesh", "[geometry]")
{
    const std::vector<Vector3d> vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const std::string& text : {msh2, msh4, medit}) {
        const TetrahedraText read = read_tetrahedra(text);
        CHECK(read.mesh.vertices == vertices);
        CHECK(read.mesh.tetrahedra == std::vector<std::array<int, 4>>{{0, 1, 2, 3}});
        CHECK_NOTHROW(check_mesh(read.mesh, read.lines));
    }
    CHECK(read_tetrahedra(msh2).lines == std::vector<int>{20});
    CHECK(read_tetrahedra(msh4).lines == std::vector<int>{29});
    CHECK(read_tetrahedra(medit).lines == std::vector<int>{18});
}

TEST_CASE("tetrahedra: a mesh that is written reads as the same bits", "[geometry]")
{
    const TetrahedralMesh ball = ball_tetrahedra(0.3, 2);
    const TetrahedraText read = read_tetrahedra(medit_text(ball));
    CHECK(medit_text(read.mesh) == medit_text(read_tetrahedra(medit_text(read.mesh)).mesh));
    REQUIRE(read.mesh.tetrahedra.size() == ball.tetrahedra.size());
    for (std::size_t t = 0; t < ball.tetrahedra.size(); ++t)
        for (int i = 0; i < 4; ++i)
            CHECK(read.mesh.vertices[read.mesh.tetrahedra[t][i]] ==
                  ball.vertices[ball.tetrahedra[t][i]]);
}

TEST_CASE("tetrahedra: a text that is no mesh is refused where it goes wrong", "[geometry]")
{
    CHECK(refusal("") == "1: expected \"MeshVersionFormatted\", found the end of the text");
    CHECK(refusal("solid ball\n") == "1: expected \"MeshVersionFormatted\", found \"solid\"");
    CHECK(refusal(replaced(msh2, "2.2 0 8", "2.2 1 8")) ==
          "2: expected a text file, \"0\", found \"1\"");
    CHECK(refusal(replaced(msh2, "2.2", "3.0")) ==
          "2: expected the format of Gmsh 2.2 or 4.1, found \"3.0\"");
    CHECK(refusal(replaced(msh2, "1e0", "high")) ==
          "14: expected a coordinate of at most 1e12 in size, found \"high\"");
    CHECK(refusal(replaced(msh2, "1e0", "nan")) ==
          "14: expected a coordinate of at most 1e12 in size, found \"nan\"");
    CHECK(refusal(replaced(msh2, "7 4\n$End", "7 5\n$End")) ==
          "20: expected the number of a vertex of this file, found 5 in an element");
    CHECK(refusal(replaced(msh2, "7 0 1", "1 0 1")) ==
          "0: expected each vertex once, found number 1 twice");
    CHECK(refusal(replaced(msh2, "3 4 2", "3 11 2")) ==
          "20: expected tetrahedra of four vertices, kind 4, found \"11\"");
    CHECK(refusal(replaced(msh2, "\n5\n10", "\n4\n10")) ==
          "14: expected \"$EndNodes\", found \"4\"");
    CHECK(refusal(replaced(msh2, "\n5\n10", "\n2000000\n10")) ==
          "9: expected at most 1000000 vertices, found \"2000000\"");
    CHECK(refusal(replaced(msh2, "3 4 2 0 1 1 2 7 4\n", "3 1 2 0 1 1 2\n")) ==
          "0: expected tetrahedra, found none");
    CHECK(refusal(msh2.substr(0, msh2.find("$EndElements"))) ==
          "21: expected \"$EndElements\", found the end of the text");
    CHECK(refusal(replaced(msh4, "2 5 1 10", "2 4 1 10")) ==
          "14: expected at most 3 vertices, found \"4\"");
    CHECK(refusal(replaced(medit, "\n3\n", "\n2\n")) == "4: expected dimension 3, found \"2\"");
    CHECK(refusal(replaced(medit, "2 3 4 5", "2 3 4 -5")) ==
          "18: expected the number of a vertex, found \"-5\"");
}

} // namespace tetrahedra_files_test
