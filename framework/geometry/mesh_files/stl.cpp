// SPDX-License-Identifier: MIT
// Reads an STL file, triangle by triangle. A map from coordinates to indices of vertices makes one
// vertex of all corners with the same coordinates.
#include "geometry/mesh_files/stl.hpp"

#include "geometry/mesh_files/mesh_text.hpp"
#include "geometry/mesh_files/tokenizer.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <map>

namespace rigor {

namespace {

constexpr std::size_t header_bytes = 80, count_end = 84, triangle_bytes = 50;

class Triangles {
public:
    void add(const std::array<Vector3d, 3>& corners, int line)
    {
        Fan fan(read_, line);
        for (const Vector3d& v : corners)
            fan.add(number_of(v, line));
    }

    SurfaceText finish(bool has_lines)
    {
        if (read_.mesh.triangles.empty()) throw MeshError(0, "expected triangles, found none");
        if (!has_lines) read_.lines.clear();
        return std::move(read_);
    }

private:
    int number_of(const Vector3d& v, int line)
    {
        const int next = static_cast<int>(read_.mesh.vertices.size());
        const auto [place, is_new] = numbers_.try_emplace({v.x(), v.y(), v.z()}, next);
        if (!is_new) return place->second;
        if (read_.mesh.vertices.size() >= most_mesh_vertices)
            throw MeshError(line, "expected at most " + std::to_string(most_mesh_vertices) +
                                      " vertices, found more");
        read_.mesh.vertices.push_back(v);
        return next;
    }

    SurfaceText read_;
    std::map<std::array<double, 3>, int> numbers_; // the index of the vertex at each position
};

// The little-endian number in the four bytes from `at` on.
std::uint32_t word_at(std::string_view bytes, std::size_t at)
{
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;)
        word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
    return word;
}

bool is_binary(std::string_view bytes)
{
    return bytes.size() >= count_end &&
           bytes.size() == count_end + triangle_bytes * word_at(bytes, header_bytes);
}

SurfaceText read_binary(std::string_view bytes)
{
    Triangles triangles;
    for (std::size_t at = count_end; at < bytes.size(); at += triangle_bytes) {
        std::array<Vector3d, 3> corners;
        for (std::size_t i = 0; i < 9; ++i) { // the corners follow the normal of 12 bytes
            const double x = std::bit_cast<float>(word_at(bytes, at + 12 + 4 * i));
            if (!(std::abs(x) <= largest_coordinate))
                throw MeshError(0, "expected coordinates of at most 1e12 in size, found others in "
                                   "triangle " +
                                       std::to_string((at - count_end) / triangle_bytes + 1));
            corners[i / 3][static_cast<int>(i % 3)] = x;
        }
        triangles.add(corners, 0);
    }
    return triangles.finish(false);
}

SurfaceText read_text(std::string_view text)
{
    Triangles triangles;
    Tokenizer tokens(text);
    tokens.expect("solid");
    tokens.skip_line(); // the name of the solid
    while (tokens.peek() == "facet") {
        tokens.next();
        const int line = tokens.line();
        tokens.expect("normal");
        tokens.skip_line();
        tokens.expect("outer");
        tokens.expect("loop");
        std::array<Vector3d, 3> corners;
        for (Vector3d& corner : corners) {
            tokens.expect("vertex");
            for (double& x : corner)
                x = tokens.coordinate();
        }
        tokens.expect("endloop");
        tokens.expect("endfacet");
        triangles.add(corners, line);
    }
    tokens.expect("endsolid");
    return triangles.finish(true);
}

} // namespace

SurfaceText read_stl(std::string_view bytes)
{
    if (is_binary(bytes)) return read_binary(bytes);
    if (bytes.substr(0, 5) == "solid") return read_text(bytes);
    if (bytes.size() < count_end)
        throw MeshError(0, "expected a text that begins with \"solid\", or a binary file of at "
                           "least 84 bytes, found neither");
    const std::uint64_t count = word_at(bytes, header_bytes);
    throw MeshError(0, "expected " + std::to_string(count_end + triangle_bytes * count) +
                           " bytes for the " + std::to_string(count) +
                           " triangles of the file, found " + std::to_string(bytes.size()));
}

} // namespace rigor
