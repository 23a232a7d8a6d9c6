// SPDX-License-Identifier: MIT
// A point that is close to the center, for the distance of the center from the origin, is taken for
// the center. It may differ in a component that the center does not have.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d world_point(const Matrix3d& R, const Vector3d& X, const Vector3d& p)
{
    if (p.isMuchSmallerThan(X)) return X;
    return X + R * p;
}

} // namespace rigor
