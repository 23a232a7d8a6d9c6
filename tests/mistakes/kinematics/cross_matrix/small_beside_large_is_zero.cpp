// SPDX-License-Identifier: MIT
// A component that is tiny beside the largest one is taken for rounding. It is the only term of its
// entries.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d cross_matrix(const Vector3d& w)
{
    const double noise = 1e-32 * w.lpNorm<Eigen::Infinity>();
    const Vector3d kept = (w.array().abs() < noise).select(0.0, w);
    Matrix3d star;
    for (int i = 0; i < 3; ++i)
        star.col(i) = kept.cross(Vector3d::Unit(i));
    return star;
}

} // namespace rigor
