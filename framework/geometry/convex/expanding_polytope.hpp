// SPDX-License-Identifier: MIT
// The polytope of the expanding polytope algorithm, EPA.
#pragma once

#include "formulas/types.hpp"

#include <vector>

namespace rigor {

/// A convex polytope around the origin, inside a convex set, that grows until its nearest face is
/// on the surface of the set (van den Bergen 2001, "Proximity queries and penetration depth
/// computation on 3D game objects").
class ExpandingPolytope {
public:
    /// @param corners  four points whose tetrahedron contains the origin [m]
    explicit ExpandingPolytope(const std::array<Vector3d, 4>& corners);

    /// Whether the polytope has faces. If the tetrahedron was flat, there are none.
    bool is_solid() const { return !faces_.empty(); }

    /// The face nearest to the origin: its outward unit normal, and its plane's distance from the
    /// origin [m].
    const Vector3d& nearest_normal() const { return faces_[nearest_].normal; }
    double nearest_distance() const { return faces_[nearest_].distance; }

    /// Adds a point beyond the nearest face.
    /// @return whether the point was added; if rounding prevents it, the polytope does not change
    bool add(const Vector3d& p);

private:
    struct Face {
        std::array<int, 3> corners;
        Vector3d normal;
        double distance = 0;
    };
    bool add_face(int a, int b, int c);
    void find_nearest();

    std::vector<Vector3d> points_;
    std::vector<Face> faces_;
    std::size_t nearest_ = 0;
};

} // namespace rigor
