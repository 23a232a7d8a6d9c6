// SPDX-License-Identifier: MIT
// A triangle mesh as a solid, shared by all bodies of its shape.
#pragma once

#include "geometry/bounds.hpp"
#include "geometry/obj.hpp"

#include <mutex>
#include <optional>
#include <string>

namespace rigor {

/// The solid that a closed mesh encloses, with what follows from it. It never changes; what not every
/// scene needs is made when it is first asked for, by whichever thread asks.
class SolidMesh {
public:
    static constexpr int usual_cells = 48, least_cells = 8, most_cells = 128;

    /// @param mesh   passed `check_mesh`
    /// @param cells  of the level set along the longest side
    explicit SolidMesh(TriangleMesh mesh, std::string name = "mesh", int cells = usual_cells);

    const TriangleMesh& mesh() const { return mesh_; }
    const std::string& name() const { return name_; }
    int cells() const { return cells_; }
    const Bounds& bounds() const { return bounds_; }
    /// The ball about the middle of the bounds that holds it [m].
    Vector3d center() const { return (bounds_.low + bounds_.high) / 2; }
    double radius() const { return radius_; }
    double volume() const { return volume_; } // [m³]

private:
    TriangleMesh mesh_;
    std::string name_;
    int cells_;
    Bounds bounds_;
    double radius_ = 0, volume_ = 0;
};

} // namespace rigor
