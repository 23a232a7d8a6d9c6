// SPDX-License-Identifier: MIT
#include "geometry/mesh_files/stl.hpp"

#include "geometry/mesh_files/surface_files.hpp"
#include "geometry/meshes/generators.hpp"
#include "geometry/meshes/mesh_checks.hpp"
#include "support/catch.hpp"

#include <bit>
#include <cstdint>

namespace stl_test {

using namespace rigor;

namespace {

void append_word(std::string& bytes, std::uint32_t word)
{
    for (int i = 0; i < 4; ++i)
        bytes += static_cast<char>(word >> 8 * i & 0xFF);
}

// A mesh as a binary STL file, without normals.
std::string binary(const TriangleMesh& mesh)
{
    std::string bytes = "solid in name only"; // some programs write that into the header
    bytes.resize(80, ' ');
    append_word(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles) {
        bytes.append(12, '\0');
        for (const int v : triangle)
            for (const double x : mesh.vertices[v])
                append_word(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(x)));
        bytes.append(2, '\0');
    }
    return bytes;
}

std::string as_text(const TriangleMesh& mesh)
{
    std::string text = "solid a block\n";
    for (const auto& triangle : mesh.triangles) {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for (const int v : triangle) {
            const Vector3d& x = mesh.vertices[v];
            text += "      vertex " + std::to_string(x.x()) + " " + std::to_string(x.y()) + " " +
                    std::to_string(x.z()) + "\n";
        }
        text += "    endloop\n  endfacet\n";
    }
    return text + "endsolid a block\n";
}

std::string refusal(const std::string& bytes)
{
    try {
        read_stl(bytes);
    } catch (const MeshError& error) {
        return std::to_string(error.line) + ": " + error.what();
    }
    return "accepted";
}

} // namespace

TEST_CASE("stl: text and binary files of a block are the block", "[geometry]")
{
    const TriangleMesh block = box_mesh({1, 2, 3.5});
    for (const bool is_binary : {false, true}) {
        CAPTURE(is_binary);
        const SurfaceText read = read_stl(is_binary ? binary(block) : as_text(block));
        CHECK(read.mesh.vertices.size() == 8); // corners at one place are one vertex
        CHECK(read.mesh.triangles.size() == 12);
        CHECK_NOTHROW(check_mesh(read.mesh, read.lines));
        CHECK(std::abs(signed_volume(read.mesh) - 7) < 1e-12);
    }
    CHECK(read_stl(as_text(block)).lines.at(1) == 9);
}

TEST_CASE("stl: what is wrong is told", "[geometry]")
{
    const TriangleMesh block = box_mesh({1, 2, 3.5});
    CHECK(refusal("") == "0: expected a text that begins with \"solid\", or a binary file of at "
                         "least 84 bytes, found neither");
    CHECK(refusal("solid x\nendsolid x\n") == "0: expected triangles, found none");
    CHECK(refusal("solid x\nfacet normal 0 0 1\nouter loop\nvertex 1 2\nendloop")
              .rfind("5: expected a coordinate", 0) == 0);
    std::string cut = as_text(block);
    cut.resize(cut.size() / 2);
    CHECK(refusal(cut).find(": expected ") != std::string::npos);
    std::string bytes = binary(block);
    bytes.replace(0, 5, "block");
    bytes.pop_back();
    CHECK(refusal(bytes) == "0: expected 684 bytes for the 12 triangles of the file, found 683");
    bytes = binary(block);
    bytes.replace(84 + 50 + 12, 4, "\x00\x00\xc0\x7f", 4); // not a number
    CHECK(refusal(bytes) ==
          "0: expected coordinates of at most 1e12 in size, found others in triangle 2");
}

TEST_CASE("surface files: the end of the name says the format", "[geometry]")
{
    const std::string off = "OFF 3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    CHECK(read_surface(off, "a.off").mesh.triangles.size() == 1);
    CHECK(read_surface(off, "A.OFF").mesh.triangles.size() == 1);
    CHECK(read_surface(binary(box_mesh({1, 1, 1})), "a.stl").mesh.triangles.size() == 12);
    CHECK(read_surface("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "x").mesh.triangles.size() == 1);
    CHECK_THROWS_AS(read_surface(off, "a.obj"), MeshError);
}

} // namespace stl_test
