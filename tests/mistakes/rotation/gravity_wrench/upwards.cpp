// SPDX-License-Identifier: MIT
// The sign is wrong: the force is M g, and g already points down.
#include "formulas/rotation.hpp"

namespace rigor {

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    return {-mass * gravity, Vector3d::Zero()};
}

} // namespace rigor
