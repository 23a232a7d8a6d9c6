// SPDX-License-Identifier: MIT
// The polar decomposition of a deformation gradient.
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// F = R S, with a rotation R and a symmetric S. If F is inverted, the eigenvalue of S with the
/// smallest absolute value is negative.
struct Polar {
    Matrix3d R = Matrix3d::Identity(), S = Matrix3d::Identity();
};

/// The polar decomposition of any F: R is the rotation with the largest Tr(Rᵀ F).
Polar polar_decomposition(const Matrix3d& F);

} // namespace rigor
