// SPDX-License-Identifier: MIT
// Contacts of nodes of which handles prescribe some coordinates. A contact can move such a node
// along its free coordinates only.
#pragma once

#include "formulas/types.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace rigor {

/// Which coordinates of a node handles prescribe.
struct HeldAxes {
    std::array<bool, 3> axes = {false, false, false};

    bool any() const { return axes[0] || axes[1] || axes[2]; }
    /// The vector with 0 in the prescribed coordinates.
    Vector3d free_part(const Vector3d& v) const
    {
        return {axes[0] ? 0 : v.x(), axes[1] ? 0 : v.y(), axes[2] ? 0 : v.z()};
    }
    /// The projector on the free coordinates.
    Matrix3d free_axes() const
    {
        return Vector3d(axes[0] ? 0 : 1, axes[1] ? 0 : 1, axes[2] ? 0 : 1).asDiagonal();
    }
};

/// The direction in which a contact can move a node.
struct FreeNormal {
    Vector3d m;    // the part of the normal n along the free coordinates, as a unit vector
    double cosine; // n·m: a node that moves by s along m moves by s n·m away from the surface
};

/// No value if the node cannot move along the normal, or only by moving ten times as far along the
/// surface. The contact then acts on the body alone.
inline std::optional<FreeNormal> free_normal(const HeldAxes& held, const Vector3d& n)
{
    if (!held.any()) return FreeNormal{n, 1};
    constexpr double least_cosine = 0.1;
    const Vector3d m = held.free_part(n);
    const double cosine = m.norm();
    if (cosine < least_cosine) return {};
    return FreeNormal{m / cosine, cosine};
}

} // namespace rigor
