// SPDX-License-Identifier: MIT
// Checks that a mesh of tetrahedra is one solid: first its counts, indices and coordinates, then
// volumes, then faces, and last that all tetrahedra are connected. Faces are compared as sorted
// triples of vertices. Whether the solid is connected is found by a search from the first
// tetrahedron through faces.
#include "geometry/tetrahedra/tetrahedra_checks.hpp"

#include "geometry/meshes/mesh_checks.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace rigor {

namespace {

// A tetrahedron is flat if its volume, divided by the cube of its longest edge, is at most this.
// For a regular tetrahedron this ratio is 0.12. Flat ones are refused, because a deformation
// gradient is computed by a division by the volume.
constexpr double least_volume = 1e-9;

class Check {
public:
    Check(const TetrahedralMesh& mesh, const std::vector<int>& lines) : mesh_(mesh), lines_(lines)
    {
    }

    void run() const
    {
        numbers();
        volumes();
        faces();
        one_piece();
    }

private:
    [[noreturn]] void refuse(int tetrahedron, const std::string& message) const
    {
        throw MeshError(lines_.empty() ? 0 : lines_[tetrahedron], message);
    }
    // The name of a tetrahedron in an error message.
    std::string name(int tetrahedron) const
    {
        return lines_.empty() ? "tetrahedron " + std::to_string(tetrahedron + 1)
                              : "the tetrahedron of line " + std::to_string(lines_[tetrahedron]);
    }

    void numbers() const
    {
        const auto& [vertices, tetrahedra] = mesh_;
        if (tetrahedra.empty()) throw MeshError(0, "expected a mesh of tetrahedra, found none");
        if (tetrahedra.size() > most_tetrahedra)
            throw MeshError(0, "expected at most " + std::to_string(most_tetrahedra) +
                                   " tetrahedra, found " + std::to_string(tetrahedra.size()));
        std::vector<char> is_used(vertices.size(), 0);
        for (int t = 0; t < static_cast<int>(tetrahedra.size()); ++t)
            for (const int v : tetrahedra[t]) {
                if (v < 0 || v >= static_cast<int>(vertices.size()))
                    refuse(t, "expected vertices from 1 to " + std::to_string(vertices.size()) +
                                  ", found " + std::to_string(v + 1) + " in " + name(t));
                is_used[v] = 1;
            }
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            if (!vertices[v].allFinite() || vertices[v].cwiseAbs().maxCoeff() > largest_coordinate)
                throw MeshError(0, "expected coordinates of at most 1e12 in size, found other "
                                   "ones at vertex " +
                                       std::to_string(v + 1));
            if (!is_used[v])
                throw MeshError(0, "expected a tetrahedron at each vertex, found none at vertex " +
                                       std::to_string(v + 1));
        }
    }

    void volumes() const
    {
        for (int t = 0; t < static_cast<int>(mesh_.tetrahedra.size()); ++t) {
            double longest = 0;
            for (const int i : mesh_.tetrahedra[t])
                for (const int j : mesh_.tetrahedra[t])
                    longest = std::max(longest, (mesh_.vertices[i] - mesh_.vertices[j]).norm());
            const double V = tetrahedron_volume(mesh_, t);
            const double least = least_volume * longest * longest * longest;
            if (V < -least)
                refuse(t,
                       "expected a tetrahedron with its fourth vertex where the first three turn "
                       "counter-clockwise, found " +
                           name(t) + " inverted: its volume is " + number_text(V) + " m³");
            if (V <= least)
                refuse(t, "expected a tetrahedron with a volume, found " + name(t) + " flat");
        }
    }

    void faces() const
    {
        const std::vector<SortedFace> faces = sorted_faces(mesh_);
        for (std::size_t i = 1; i < faces.size(); ++i) {
            const SortedFace &f = faces[i - 1], &g = faces[i];
            if (f.vertices != g.vertices) continue;
            if (i >= 2 && faces[i - 2].vertices == g.vertices)
                refuse(g.tetrahedron, "expected at most two tetrahedra at a face, found " +
                                          name(g.tetrahedron) + " as a third");
            if (f.is_even == g.is_even)
                refuse(g.tetrahedron, "expected tetrahedra on both sides of a face, found " +
                                          name(f.tetrahedron) + " and " + name(g.tetrahedron) +
                                          " on the same");
        }
    }

    void one_piece() const
    {
        const auto neighbours = face_neighbours(mesh_);
        std::vector<char> is_reached(neighbours.size(), 0);
        std::vector<int> open = {0};
        is_reached[0] = 1;
        while (!open.empty()) {
            const int t = open.back();
            open.pop_back();
            for (const int u : neighbours[t])
                if (u >= 0 && !std::exchange(is_reached[u], 1)) open.push_back(u);
        }
        const auto apart = std::find(is_reached.begin(), is_reached.end(), 0);
        if (apart == is_reached.end()) return;
        const int t = static_cast<int>(apart - is_reached.begin());
        refuse(t, "expected one solid, found " + name(t) + " joined to " + name(0) +
                      " by no chain of faces");
    }

    const TetrahedralMesh& mesh_;
    const std::vector<int>& lines_;
};

} // namespace

void check_mesh(const TetrahedralMesh& mesh, const std::vector<int>& lines)
{
    Check(mesh, lines).run();
}

} // namespace rigor
