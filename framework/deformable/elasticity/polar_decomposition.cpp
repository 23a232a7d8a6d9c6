// SPDX-License-Identifier: MIT
// Computes the rotation R and the symmetric S of F = R S for any F, even a singular or inverted
// one. R comes from the closed form of closed_polar.hpp, and one step of Newton's method makes it
// orthogonal up to rounding. Where the closed form is inaccurate, R comes from an eigenvector
// instead (Horn 1987).
#include "deformable/elasticity/polar_decomposition.hpp"

#include "deformable/elasticity/closed_polar.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace rigor {

namespace {

// The rotation with the largest Tr(Rᵀ F). For the quaternion q of R, this trace is qᵀ N q, so that
// q is an eigenvector of N for its largest eigenvalue (Horn 1987). This is slower than the closed
// form but works for every F.
Matrix3d closest_rotation(const Matrix3d& F)
{
    Eigen::Matrix4d N;
    N(0, 0) = F(0, 0) + F(1, 1) + F(2, 2);
    N(1, 1) = F(0, 0) - F(1, 1) - F(2, 2);
    N(2, 2) = -F(0, 0) + F(1, 1) - F(2, 2);
    N(3, 3) = -F(0, 0) - F(1, 1) + F(2, 2);
    N(1, 0) = F(2, 1) - F(1, 2);
    N(2, 0) = F(0, 2) - F(2, 0);
    N(3, 0) = F(1, 0) - F(0, 1);
    N(2, 1) = F(0, 1) + F(1, 0);
    N(3, 1) = F(2, 0) + F(0, 2);
    N(3, 2) = F(1, 2) + F(2, 1);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(N); // reads only the lower triangle
    const Eigen::Vector4d q = solver.eigenvectors().col(3);
    return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

} // namespace

Polar polar_decomposition(const Matrix3d& F)
{
    // F is divided by `norm`, so that the tolerances do not depend on the size of F.
    const double norm = F.cwiseAbs().maxCoeff();
    if (norm == 0) return {Matrix3d::Identity(), Matrix3d::Zero()};
    Square3<double> scaled;
    for (int i = 0; i < 9; ++i)
        scaled.a[i / 3][i % 3] = F(i / 3, i % 3) / norm;
    const double norm2 = dot(scaled, scaled);
    const auto is_end = [](double step) { return std::abs(step) < small_step; };
    const ClosedPolar<double> closed = closed_polar(scaled, norm2, std::sqrt(3 * norm2), is_end);
    Polar polar;
    if (is_exact(closed.conditioning, closed.last_step)) {
        Matrix3d R;
        for (int i = 0; i < 9; ++i)
            R(i / 3, i % 3) = closed.R.a[i / 3][i % 3];
        polar.R = 1.5 * R - 0.5 * R * (R.transpose() * R); // now orthogonal up to rounding
    } else {
        polar.R = closest_rotation(F / norm);
    }
    const Matrix3d RtF = polar.R.transpose() * F;
    polar.S = 0.5 * (RtF + RtF.transpose());
    return polar;
}

} // namespace rigor
