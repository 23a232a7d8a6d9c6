// SPDX-License-Identifier: MIT
// The mass is missing: the force is g instead of M g.
#include "formulas/rotation.hpp"

namespace rigor {

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    return {(mass > 0 ? 1.0 : 0.0) * gravity, Vector3d::Zero()};
}

} // namespace rigor
