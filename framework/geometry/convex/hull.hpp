// SPDX-License-Identifier: MIT
// A mesh without a dent, by its corners and flat faces.
#pragma once

#include "formulas/types.hpp"
#include "geometry/convex/feature.hpp"

#include <array>
#include <vector>

namespace rigor {

/// The convex solid that a mesh is: its triangles merged to flat faces.
class Hull {
public:
    static constexpr std::size_t most_vertices = 1000; // with more, the mesh goes by its level set

    /// @param mesh  `is_hull`
    explicit Hull(const TriangleMesh& mesh);

    /// The farthest vertex along a direction.
    Vector3d support(const Vector3d& direction) const;

    /// A face, an edge or a corner, as of every convex shape; of a face with many corners 16.
    Feature feature_towards(const Vector3d& direction) const;

    /// Of at most the 32 largest faces.
    const std::vector<Vector3d>& face_normals() const { return face_normals_; }

private:
    struct Face {
        Vector3d normal;
        double area = 0;
        std::vector<int> corners; // in order around the normal
    };
    int farthest(const Vector3d& direction) const;
    void merge_faces(const TriangleMesh& mesh);
    void link_neighbours(const TriangleMesh& mesh);

    std::vector<Vector3d> vertices_;
    std::vector<Face> faces_;
    std::vector<Vector3d> face_normals_;
    std::vector<std::vector<int>> neighbours_; // of each vertex
    std::array<int, 6> extremes_ = {};         // along ±x, ±y, ±z: where a search starts
};

/// Whether a closed mesh has no dent: no vertex lies above the plane of any face, to 1e-9 of its size,
/// and it is small enough to be searched.
bool is_hull(const TriangleMesh& mesh);

} // namespace rigor
