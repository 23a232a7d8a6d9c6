// SPDX-License-Identifier: MIT
// The polar decomposition of a deformation gradient.
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// F = R S, with R a rotation and S symmetric. Where F is inverted S has a negative eigenvalue, the
/// smallest in size.
struct Polar {
    Matrix3d R = Matrix3d::Identity(), S = Matrix3d::Identity();
};

/// The polar decomposition of any F: R is the rotation with the largest Tr(Rᵀ F).
Polar polar_decomposition(const Matrix3d& F);

} // namespace rigor
