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

/// The solid that a closed mesh encloses, with what follows from it. It never changes; what not every
/// scene needs is made when it is first asked for, by whichever thread asks.
class SolidMesh {
public:
    static constexpr int least_cells = 8, most_cells = 128;

    /// @param mesh   passed `check_mesh`
    /// @param cells  of the level set along the longest side; 0: `suggested_cells(mesh)`
    explicit SolidMesh(TriangleMesh mesh, std::string name = "mesh", int cells = 0);

    SolidMesh(const SolidMesh&) = delete;
    SolidMesh& operator=(const SolidMesh&) = delete;

    /// The same mesh, with nothing made of it yet.
    std::shared_ptr<const SolidMesh> copy() const
    {
        return std::make_shared<SolidMesh>(mesh_, name_, cells_);
    }

    const TriangleMesh& mesh() const { return mesh_; }
    const std::string& name() const { return name_; }
    const Bounds& bounds() const { return bounds_; }
    /// The ball about the middle of the bounds that holds it [m].
    Vector3d center() const { return (bounds_.low + bounds_.high) / 2; }
    double radius() const { return radius_; }
    double volume() const { return volume_; } // [m³]

    /// Whether it has no dent: then contacts go by its hull, and its level set is rarely needed.
    bool is_convex() const { return is_convex_; }
    /// @pre is_convex()
    const Hull& hull() const;

    /// Points and edges of the surface, a cell of the level set apart.
    const MeshSurface& surface() const;

    /// Its triangles, to find the nearest.
    const TriangleTree& triangles() const;

    /// Signed distance on a grid. @param made  called if it was made for this call
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
    Lazy<int> chosen_cells_;
    Lazy<MeshSurface> surface_;
    Lazy<TriangleTree> triangles_;
    Lazy<LevelSet> level_set_;
};

} // namespace rigor
