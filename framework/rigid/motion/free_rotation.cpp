// SPDX-License-Identifier: MIT
// Computes Jacobi's solution for the free rotor in four stages. Stage 1 finds the closed curve on
// which the angular momentum moves in the body. Stage 2 finds the elliptic functions at the end of
// the step by the addition theorem. Stage 3 finds the angle about the fixed momentum by Carlson's
// integrals. Stage 4 finds the rotation of the body from two frames that axis 3 and the momentum
// span in the body, one at the start of the step and one at its end.
// Differences of squares are written as sums of positive terms, so that no digits cancel near the
// unstable axis or where two moments are nearly equal. The only exception is `s` in `path_of`,
// where the rounding of the arguments causes an error as large as that of the cancellation.
#include "rigid/motion/free_rotation.hpp"

#include "rigid/motion/elliptic_functions.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {

namespace {

// The smallest 1 - m that is used (m: parameter of the elliptic functions). Smaller values would
// change nothing: even with 1e-100, the argument u has to grow from 0 to a quarter period of about
// 117 before the momentum M passes the unstable axis (axis 2).
constexpr double least_m1 = 1e-100;

// The closed curve of the unit vector M/|M| in the body.
struct Path {
    int axis1 = 0, axis2 = 1, axis3 = 2; // M circles about axis 3
    double J1 = 0, J2 = 0, J3 = 0;
    double A1 = 0, A2 = 0, A3 = 0; // M₁ = A₁ cn u, M₂ = A₂ sn u, M₃ = A₃ dn u
    double N = 1;                  // (A₂/A₁)²
    double m1 = 1;                 // 1 - m (m: parameter of the elliptic functions)
    double rate = 0;               // u̇/|M| [1/(kg m²)]

    // Whether M moves in the body. M does not move if it lies along a principal axis or if all
    // moments are equal.
    bool is_moving() const { return rate != 0 && A1 > 0 && std::isfinite(N); }
};

Path path_of(const Vector3d& J, const Vector3d& M)
{
    int a[] = {0, 1, 2};
    std::sort(a, a + 3, [&](int i, int j) { return J[i] > J[j]; });
    const auto square = [&](int k) { return M[a[k]] * M[a[k]]; };
    const double s = (J[a[1]] - J[a[2]]) * square(2) - (J[a[0]] - J[a[1]]) * square(0);
    if (s < 0) std::swap(a[0], a[2]);

    Path path{a[0], a[1], a[2], J[a[0]], J[a[1]], J[a[2]]};
    const double J_12 = std::abs(path.J1 - path.J2), J_23 = std::abs(path.J2 - path.J3);
    const double J_13 = std::abs(path.J1 - path.J3);
    const double r = J_12 * square(1) + J_13 * square(2);
    path.N = J_13 / J_23;
    path.A1 = std::hypot(M[a[0]], M[a[1]] / std::sqrt(path.N));
    path.A2 = std::sqrt(path.N) * path.A1;
    path.A3 = std::copysign(std::sqrt(r / J_13), M[a[2]]);
    path.m1 = std::clamp(path.N * (std::abs(s) / r), least_m1, 1.0);
    // Ṁ₂ = (J₁ - J₃) M₃ M₁ in a right-handed frame
    const bool is_right_handed = (a[1] - a[0] + 3) % 3 == 1;
    const bool is_forward = is_right_handed == ((path.J1 > path.J3) == (path.A3 > 0));
    path.rate = (is_forward ? 1 : -1) * std::sqrt(J_23 * r);
    return path;
}

// Two quantities of the interval that starts at the zero of cn nearest to u and ends at u: its
// signed length w, and the integral G = ∫ cn²/(cn² + N sn²) du over it.
struct Swept {
    double w = 0, G = 0;
};

Swept swept(const Path& path, const EllipticFunctions& u)
{
    const double s2 = u.sn * u.sn, c2 = u.cn * u.cn, d2 = u.dn * u.dn, m1 = path.m1;
    const double c = u.sn > 0 ? -u.cn : u.cn;
    return {c * carlson_rf(m1 * s2, m1, d2),
            c * c2 * m1 / (3 * path.N) * carlson_rj(m1 * s2, m1, d2, m1 * (s2 + c2 / path.N))};
}

// ∫ cn²/(cn² + N sn²) du over a step in which u grows by v, from `start` to `end`.
double integral(const Path& path, const EllipticFunctions& start, const EllipticFunctions& end,
                double v)
{
    const Swept from = swept(path, start), to = swept(path, end);
    const double K = quarter_period(path.m1);
    const double half_periods = std::round((v - (to.w - from.w)) / (2 * K));
    const double G = to.G - from.G;
    return half_periods == 0 ? G : G + half_periods * 2 * swept(path, {0, 1, 1}).G;
}

// The frame that axis 3 and M span (|M| = 1). Its columns are unit vectors: the direction of the
// part of axis 3 perpendicular to M, the direction that completes the frame, and M.
Matrix3d frame_of(const Vector3d& M, int axis3)
{
    const double across = std::hypot(M[(axis3 + 1) % 3], M[(axis3 + 2) % 3]);
    Matrix3d B;
    B.col(0) = -M[axis3] / across * M;
    B(axis3, 0) = across;
    B.col(1) = M.cross(B.col(0));
    B.col(2) = M;
    return B;
}

// The rotation vector of R: it lies along the axis of the rotation, and its length is the angle.
Vector3d rotation_vector(const Matrix3d& R)
{
    const Eigen::Quaterniond q(R);
    const double sine = q.vec().norm();
    if (!(sine > 0)) return Vector3d::Zero();
    return 2 * std::atan2(std::copysign(sine, q.w()), std::abs(q.w())) / sine * q.vec();
}

} // namespace

Vector3d mean_free_angular_velocity(const Vector3d& inverse_moments, const Vector3d& momentum,
                                    double time)
{
    const double L = momentum.stableNorm(); // the length, without squares that underflow
    const Vector3d M = momentum / L;
    const Path path = path_of(inverse_moments, M);
    if (!path.is_moving()) return inverse_moments.cwiseProduct(momentum);

    const double v = path.rate * L * time;
    const EllipticFunctions start{M[path.axis2] / path.A2, M[path.axis1] / path.A1,
                                  M[path.axis3] / path.A3};
    const EllipticFunctions end = at_sum(start, elliptic_functions(v, path.m1), path.m1);
    Vector3d M_end;
    M_end[path.axis1] = path.A1 * end.cn;
    M_end[path.axis2] = path.A2 * end.sn;
    M_end[path.axis3] = path.A3 * end.dn;

    // φ = |L| (J₂ h + (J₁ - J₂) ∫ M₁²/(M₁² + M₂²) dt), with h = `time`
    const double phi =
        path.J2 * L * time + (path.J1 - path.J2) / path.rate * integral(path, start, end, v);
    const Matrix3d B = frame_of(M, path.axis3);
    const Matrix3d B_end = frame_of(M_end.normalized(), path.axis3);
    const Eigen::AngleAxisd about_L(phi, Vector3d::UnitZ());
    return rotation_vector(B * about_L.toRotationMatrix() * B_end.transpose()) / time;
}

} // namespace rigor
