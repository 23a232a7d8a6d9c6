// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture.hpp"
#include "scene/description/scene.hpp"

#include <string>
#include <vector>

namespace rigor {

/// What a picture needs to know about a rigid body besides its state.
struct DrawnBody {
    std::string name;
    bool is_static = false;
    std::vector<Part> parts;                    // relative to the center of mass
    Vector3d center_of_mass = Vector3d::Zero(); // in the body's frame of the scene file [m]
    // For each part, the index of its surface in `Picture::models`; -1 for a box, a ball, an
    // ellipsoid or a plane.
    std::vector<int> models;
    // I_body⁻¹ [1/(kg m²)]; it is zero along an axis about which the body has no inertia.
    Matrix3d inverse_inertia = Matrix3d::Zero();
    // Mass [kg] and mean of the principal moments of inertia [kg m²]; 0 for a static body.
    double mass = 0, mean_inertia = 0;
    // Radius of a ball around the center of mass that contains all parts but planes [m].
    double radius = 0;
    Vector4f color;
};

/// Two states of a body look different if a point on its surface moves by more than about this
/// fraction of the body's radius from one state to the other.
constexpr double visible_distance = 0.004;

/// Whether a body at this position is drawn. Bodies that have flown too far away are not drawn.
inline bool in_sight(const Vector3d& position)
{
    constexpr double far = 1e6; // [m]
    return position.norm() < far;
}

} // namespace rigor
