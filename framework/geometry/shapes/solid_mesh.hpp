// SPDX-License-Identifier: MIT
// A triangle mesh as a solid. All bodies of a world with the same mesh share it.
#pragma once

#include "geometry/bounds/bounds.hpp"
#include "geometry/convex/hull.hpp"
#include "geometry/meshes/mesh_surface.hpp"
#include "geometry/meshes/triangle_tree.hpp"
#include "geometry/shapes/lazy.hpp"

#include <string>

namespace rigor {

/// The solid that a closed mesh encloses, with its hull, sample points, tree of triangles and level
/// set. A `SolidMesh` never changes. Data that not every scene needs is computed lazily, when a
/// thread first asks for it.
class SolidMesh {
public:
    /// Limits for the parameter `cells` of the constructor: a coarser level set loses the
    /// details of the shape, a finer one costs too much time and memory.
    static constexpr int least_cells = 8, most_cells = 128;

    /// @param mesh   a mesh that passed `check_mesh`
    /// @param cells  number of cells of the level set along the longest side of the mesh's bounds;
    ///               0 means `suggested_cells(mesh)` (level_sets/level_set.hpp)
    explicit SolidMesh(TriangleMesh mesh, std::string name = "mesh", int cells = 0);

    SolidMesh(const SolidMesh&) = delete;
    SolidMesh& operator=(const SolidMesh&) = delete;

    /// A new SolidMesh for the same mesh. Data that was computed lazily is not copied.
    std::shared_ptr<const SolidMesh> copy() const
    {
        return std::make_shared<SolidMesh>(mesh_, name_, cells_);
    }

    const TriangleMesh& mesh() const { return mesh_; }
    const std::string& name() const { return name_; }
    const Bounds& bounds() const { return bounds_; }
    /// A ball that contains the mesh: its center is the middle of the bounds, and its radius the
    /// distance from there to the farthest vertex [m].
    Vector3d center() const { return (bounds_.low + bounds_.high) / 2; }
    double radius() const { return radius_; }
    double volume() const { return volume_; } // [m³]

    /// Whether the mesh is convex and has few enough vertices for a hull (`is_hull` in
    /// convex/hull.hpp). Contacts of such a mesh with a box, cylinder, cone, ellipsoid or another
    /// such mesh use the hull instead of the level set.
    bool is_convex() const { return is_convex_; }
    /// The hull of the mesh. Call it only if `is_convex()`: for another mesh the hull is wrong.
    const Hull& hull() const;

    /// The largest angle between the normals of two neighboring facets of a round surface [rad];
    /// 0 if the mesh has no round surface (`facet_angle` in meshes/mesh_edges.hpp).
    double facet_angle() const;

    /// Sample points and sharp edges of the surface, with one cell of the level set as `spacing`.
    const MeshSurface& surface() const;

    /// A bounding tree of the mesh's triangles.
    const TriangleTree& triangles() const;

    /// The signed distances to the mesh on a grid (level_sets/level_set.hpp).
    /// @param made  function that is called just before the distances are computed. Only the first
    ///              call of `level_set` computes them.
    template <class Made> const LevelSet& level_set(const Made& made) const
    {
        return level_set_.get([&] {
            made();
            return new_level_set();
        });
    }

private:
    int cells() const;
    std::unique_ptr<LevelSet> new_level_set() const;

    TriangleMesh mesh_;
    std::string name_;
    int cells_;
    Bounds bounds_;
    double radius_ = 0, volume_ = 0;
    bool is_convex_ = false;
    Lazy<Hull> hull_;
    Lazy<double> facet_angle_;
    Lazy<int> chosen_cells_;
    Lazy<MeshSurface> surface_;
    Lazy<TriangleTree> triangles_;
    Lazy<LevelSet> level_set_;
};

} // namespace rigor
