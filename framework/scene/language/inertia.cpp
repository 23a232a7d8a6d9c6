// SPDX-License-Identifier: MIT
#include "scene/language/inertia.hpp"

#include "scene/language/values.hpp"

#include <fmt/format.h>

namespace rigor {

Matrix3d inertia(const Value& value)
{
    constexpr std::string_view what = "three moments, or three rows of three numbers";
    if (array(value, what).size() != 3) expected(what, value);
    Matrix3d I = Matrix3d::Zero();
    const bool rows = value.items[0].kind == Value::Kind::array;
    for (int i = 0; i < 3; ++i) {
        const Value& item = value.items[i];
        if (rows)
            I.row(i) = vector3(item, "a row of three numbers").transpose();
        else
            I(i, i) = number(item, "a moment");
    }
    const double rounding = 1e-9 * I.norm();
    if ((I - I.transpose()).norm() > rounding)
        throw Mistake{value.line, "expected a symmetric inertia, found rows that differ from the "
                                  "columns"};
    // For matter, D = ½ tr(I) δ - I, with the unit matrix δ, is the sum of x xᵀ dm over the mass dm
    // at the points x, so it has no negative eigenvalue. An inertia whose D has one is refused: it
    // has a negative principal moment, or one that is larger than the sum of the other two.
    const Matrix3d D = 0.5 * I.trace() * Matrix3d::Identity() - I;
    Eigen::SelfAdjointEigenSolver<Matrix3d> eigen;
    eigen.compute(D, Eigen::EigenvaluesOnly);
    if (!(eigen.eigenvalues().minCoeff() >= -rounding))
        throw Mistake{value.line,
                      fmt::format("expected an inertia that matter can have (no moment negative or "
                                  "larger than the sum of the other two), found {}",
                                  rows ? "a matrix that breaks this"
                                       : fmt::format("[{}, {}, {}]", I(0, 0), I(1, 1), I(2, 2)))};
    return I;
}

} // namespace rigor
