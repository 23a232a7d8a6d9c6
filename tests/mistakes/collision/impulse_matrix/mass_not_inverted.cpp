// SPDX-License-Identifier: MIT
// δ/M is the inverse mass times δ: it is given, and must not be inverted again.
#include "formulas/collision.hpp"
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    if (inverse_mass == 0) return Matrix3d::Zero();

    const Matrix3d r_star = cross_matrix(x - X);
    return Matrix3d::Identity() / inverse_mass + r_star.transpose() * I_inverse * r_star;
}

} // namespace rigor
