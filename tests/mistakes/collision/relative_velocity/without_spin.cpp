// SPDX-License-Identifier: MIT
// The bodies turn: ω × (x - X) is missing.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d&)
{
    return body1.velocity - body2.velocity;
}

} // namespace rigor
