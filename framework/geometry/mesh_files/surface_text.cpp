// SPDX-License-Identifier: MIT
#include "geometry/mesh_files/surface_text.hpp"

#include "geometry/mesh_files/mesh_text.hpp"

#include <cmath>

namespace rigor {

std::string_view Words::next()
{
    const std::size_t start = rest_.find_first_not_of(" \t\r");
    if (start == std::string_view::npos) return {};
    rest_.remove_prefix(start);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r"));
    rest_.remove_prefix(word.size());
    return word;
}

Vector3d read_coordinates(Words& words, int line)
{
    Vector3d v;
    for (double& x : v) {
        const std::string_view word = words.next();
        if (!parse(word, x) || !std::isfinite(x) || std::abs(x) > largest_coordinate)
            throw MeshError(line, "expected a coordinate of at most 1e12 in size, found " +
                                      quoted(word, "the end of the line"));
    }
    return v;
}

void Fan::add(int vertex)
{
    if (corners_ < 3)
        fan_[corners_] = vertex;
    else
        fan_ = {fan_[0], fan_[2], vertex};
    if (++corners_ < 3) return;
    if (read_.mesh.triangles.size() >= most_mesh_triangles)
        throw MeshError(line_, "expected at most " + std::to_string(most_mesh_triangles) +
                                   " triangles, found more");
    read_.mesh.triangles.push_back(fan_);
    read_.lines.push_back(line_);
}

void Fan::finish() const
{
    if (corners_ < 3)
        throw MeshError(line_, "expected a face of at least three vertices, found " +
                                   std::to_string(corners_));
}

void keep_used_vertices(TriangleMesh& mesh)
{
    std::vector<int> number(mesh.vertices.size(), -1); // new index of each vertex, or -1 if unused
    std::vector<Vector3d> used;
    for (auto& triangle : mesh.triangles)
        for (int& vertex : triangle) {
            int& n = number[vertex];
            if (n < 0) {
                n = static_cast<int>(used.size());
                used.push_back(mesh.vertices[vertex]);
            }
            vertex = n;
        }
    mesh.vertices = std::move(used);
}

} // namespace rigor
