// SPDX-License-Identifier: MIT
// Code that the readers of OBJ, OFF and STL share: words of a line, coordinates, and faces as
// fans of triangles.
#pragma once

#include "geometry/meshes/mesh_checks.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace rigor {

/// A mesh as it was read: the syntax of its text is right, but it has not passed `check_mesh` yet.
struct SurfaceText {
    TriangleMesh mesh;      // without the vertices that no face uses
    std::vector<int> lines; // for each triangle, its line in the file; empty if the file is binary
};

/// The words of a line, one after the other.
class Words {
public:
    explicit Words(std::string_view line) : rest_(line) {}

    std::string_view next(); // the next word; empty at the end of the line

private:
    std::string_view rest_;
};

/// Reads three coordinates, each finite and at most 1e12 in size.
/// @throws MeshError
Vector3d read_coordinates(Words& words, int line);

/// A face of three or more vertices, which becomes a fan of triangles about its first vertex.
class Fan {
public:
    Fan(SurfaceText& read, int line) : read_(read), line_(line) {}

    /// @throws MeshError  if the mesh has too many triangles
    void add(int vertex);

    /// @throws MeshError  if the face has less than three vertices
    void finish() const;

private:
    SurfaceText& read_;
    int line_, corners_ = 0;
    std::array<int, 3> fan_{}; // the first vertex of the face, and the last two so far
};

/// Removes the vertices that no triangle uses. The others are numbered in the order in which
/// triangles first use them.
void keep_used_vertices(TriangleMesh& mesh);

} // namespace rigor
