// SPDX-License-Identifier: MIT
// Gravity exerts no torque about the center of mass.
#include "formulas/rotation.hpp"

namespace rigor {

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    return {mass * gravity, mass * Vector3d::UnitX().cross(gravity)};
}

} // namespace rigor
