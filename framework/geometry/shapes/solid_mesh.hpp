// SPDX-License-Identifier: MIT
// A triangle mesh as a solid, shared by all bodies of its shape.
#pragma once

#include "geometry/bounds/bounds.hpp"
#include "geometry/convex/hull.hpp"
#include "geometry/meshes/mesh_surface.hpp"
#include "geometry/meshes/triangle_tree.hpp"
#include "geometry/shapes/lazy.hpp"

#include <string>

namespace rigor {

/// The solid that a closed mesh encloses, and its hull, surface, tree and level set. It never
/// changes. The parts that not every scene needs are computed lazily, when a thread first asks for
/// them.
class SolidMesh {
public:
    /// Limits of `cells`: a coarser level set has no room for detail, a finer one costs too much
    /// time and memory.
    static constexpr int least_cells = 8, most_cells = 128;

    /// @param mesh   a mesh that passed `check_mesh`
    /// @param cells  number of cells along the longest side of the level set; 0:
    ///               `suggested_cells(mesh)`
    explicit SolidMesh(TriangleMesh mesh, std::string name = "mesh", int cells = 0);

    SolidMesh(const SolidMesh&) = delete;
    SolidMesh& operator=(const SolidMesh&) = delete;

    /// A copy for the same mesh, without what is computed lazily.
    std::shared_ptr<const SolidMesh> copy() const
    {
        return std::make_shared<SolidMesh>(mesh_, name_, cells_);
    }

    const TriangleMesh& mesh() const { return mesh_; }
    const std::string& name() const { return name_; }
    const Bounds& bounds() const { return bounds_; }
    /// The bounding ball: its center, the middle of the bounds, and its radius [m].
    Vector3d center() const { return (bounds_.low + bounds_.high) / 2; }
    double radius() const { return radius_; }
    double volume() const { return volume_; } // [m³]

    /// Whether the mesh is convex, as `is_hull` defines it. Contacts of convex meshes use the hull,
    /// and rarely need the level set.
    bool is_convex() const { return is_convex_; }
    /// @pre is_convex()
    const Hull& hull() const;

    /// The largest angle between two facets of a rounded surface, see mesh_edges.hpp [rad].
    double facet_angle() const;

    /// Sample points and sharp edges of the surface, one cell of the level set apart.
    const MeshSurface& surface() const;

    /// A tree of its triangles.
    const TriangleTree& triangles() const;

    /// Signed distances on a grid.
    /// @param made  called just before the distances are computed, which only the first call does
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
