// SPDX-License-Identifier: MIT
// Contacts of nodes for which handles prescribe one or more coordinates. A contact moves such a
// node only along its free coordinates, which are those that no handle prescribes.
#pragma once

#include "formulas/types.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace rigor {

/// Which of the world-space coordinates x, y and z of a node are prescribed by handles.
struct HeldAxes {
    std::array<bool, 3> axes = {false, false, false};

    bool any() const { return axes[0] || axes[1] || axes[2]; }
    /// v with its prescribed coordinates set to 0.
    Vector3d free_part(const Vector3d& v) const
    {
        return {axes[0] ? 0 : v.x(), axes[1] ? 0 : v.y(), axes[2] ? 0 : v.z()};
    }
    /// The matrix that sets the prescribed coordinates of a vector to 0.
    Matrix3d free_axes() const
    {
        return Vector3d(axes[0] ? 0 : 1, axes[1] ? 0 : 1, axes[2] ? 0 : 1).asDiagonal();
    }
};

/// The direction in which a contact with the unit normal n can move a node.
struct FreeNormal {
    Vector3d m;    // the part of n along the free coordinates, normalized to a unit vector
    double cosine; // n·m: a node that moves by s along m moves by s n·m away from the surface
};

/// The direction m for a contact with the unit normal n. The result is empty if handles keep the
/// node from moving along n, or if a move along m would be more than ten times as long as its part
/// along n. In both cases the contact acts on the rigid body alone.
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
