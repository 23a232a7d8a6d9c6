// SPDX-License-Identifier: MIT
// The exact motion of a free rigid body. The angular velocity is Jacobi's solution of Euler's
// equations (Landau and Lifshitz, "Mechanics", § 37), with elliptic functions by descending Landen
// transformations. The orientation follows from it: the precession about L is integrated by
// Gauss–Legendre quadrature.
#include "support/free_rotor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace rigor {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Jacobi {
    double sn = 0, cn = 1, dn = 1;
};

// Jacobi's elliptic functions of parameter m = k² in [0, 1), by descending Landen transformations
// (Abramowitz and Stegun 1964, 16.4).
Jacobi jacobi(double u, double m)
{
    std::array<double, 16> a{}, c{};
    a[0] = 1;
    double b = std::sqrt(1 - m);
    int n = 0;
    for (; n < 15; ++n) {
        c[n + 1] = (a[n] - b) / 2;
        a[n + 1] = (a[n] + b) / 2;
        b = std::sqrt(a[n] * b);
        constexpr double negligible = 1e-17; // beside 1, in double
        if (std::abs(c[n + 1]) < negligible) break;
    }
    n = std::min(n + 1, 15);
    double phi = std::ldexp(a[n] * u, n);
    for (; n > 0; --n)
        phi = (phi + std::asin(c[n] / a[n] * std::sin(phi))) / 2;
    const double sn = std::sin(phi);
    return {sn, std::cos(phi), std::sqrt(1 - m * sn * sn)};
}

constexpr int nodes = 16;

// Nodes and weights of Gauss–Legendre quadrature on [-1, 1]. The nodes are the roots of P₁₆, found
// by Newton's method.
std::array<std::pair<double, double>, nodes> gauss_legendre()
{
    std::array<std::pair<double, double>, nodes> rule;
    for (int i = 0; i < nodes; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (nodes + 0.5)), slope = 1;
        constexpr int iterations = 8; // more than Newton's method needs from there
        for (int iteration = 0; iteration < iterations; ++iteration) {
            const double p = std::legendre(nodes, x), before = std::legendre(nodes - 1, x);
            slope = nodes * (before - x * p) / (1 - x * x);
            x -= p / slope;
        }
        rule[i] = {x, 2 / ((1 - x * x) * slope * slope)};
    }
    return rule;
}

} // namespace

FreeRotor::FreeRotor(const Vector3d& moments, const Vector3d& w)
    : moments_(moments), L_(moments.cwiseProduct(w)), energy_twice_(w.dot(L_))
{
    // The moments ascend, I₁ < I₂ < I₃. Axes 1 and 3 are swapped if L circles about the axis of the
    // smallest moment.
    int order[] = {0, 1, 2};
    std::sort(order, order + 3, [&](int i, int j) { return moments[i] < moments[j]; });
    axis1_ = order[0], axis2_ = order[1], axis3_ = order[2];
    const double L2 = L_.squaredNorm(), E2 = energy_twice_;
    if (L2 < E2 * moments[axis2_]) std::swap(axis1_, axis3_);

    const double I1 = moments[axis1_], I2 = moments[axis2_], I3 = moments[axis3_];
    amplitude1_ = std::sqrt((E2 * I3 - L2) / (I1 * (I3 - I1)));
    amplitude2_ = std::sqrt((E2 * I3 - L2) / (I2 * (I3 - I2)));
    amplitude3_ = std::copysign(std::sqrt((L2 - E2 * I1) / (I3 * (I3 - I1))), w[axis3_]);
    modulus_squared_ = (I2 - I1) * (E2 * I3 - L2) / ((I3 - I2) * (L2 - E2 * I1));

    // I₂ ω̇₂ = (I₃ - I₁) ω₃ ω₁ in a right-handed frame. In the other cases the rate of the phase
    // changes its sign.
    const bool right_handed = (axis2_ - axis1_ + 3) % 3 == 1;
    const double sign = ((I3 > I1) == right_handed) == (amplitude3_ > 0) ? 1 : -1;
    rate_ = sign * std::sqrt((I3 - I2) * (L2 - E2 * I1) / (I1 * I2 * I3));
    const double k = std::sqrt(modulus_squared_);
    phase_ = std::ellint_1(k, std::atan2(w[axis2_] / amplitude2_, w[axis1_] / amplitude1_));
    period_ = 4 * std::comp_ellint_1(k) / std::abs(rate_);
}

Vector3d FreeRotor::body_angular_velocity(double t) const
{
    const Jacobi j = jacobi(phase_ + rate_ * t, modulus_squared_);
    Vector3d w;
    w[axis1_] = amplitude1_ * j.cn;
    w[axis2_] = amplitude2_ * j.sn;
    w[axis3_] = amplitude3_ * j.dn;
    return w;
}

// Three axes in object space, as columns: the direction of axis 3 perpendicular to L, the direction
// that completes the frame, and the direction of L.
Matrix3d FreeRotor::triad(double t) const
{
    const Vector3d m = moments_.cwiseProduct(body_angular_velocity(t)).normalized();
    const Vector3d e = Vector3d::Unit(axis3_);
    Matrix3d B;
    B.col(0) = (e - e.dot(m) * m).normalized();
    B.col(1) = m.cross(B.col(0));
    B.col(2) = m;
    return B;
}

double FreeRotor::precession(double t) const
{
    static const auto rule = gauss_legendre();
    const double I3 = moments_[axis3_], L2 = L_.squaredNorm();
    const auto quadrature = [&](int panels) {
        const double half = t / panels / 2;
        double sum = 0;
        for (int panel = 0; panel < panels; ++panel)
            for (const auto& [x, weight] : rule) {
                const double w3 = body_angular_velocity(half * (2 * panel + 1 + x))[axis3_];
                sum += weight * (energy_twice_ - I3 * w3 * w3) / (L2 - I3 * I3 * w3 * w3);
            }
        return half * std::sqrt(L2) * sum;
    };
    // Near the separatrix the rate has sharp peaks, so the number of panels doubles until the
    // integral converges.
    int panels = 1 + static_cast<int>(std::abs(t) / period_ * 8);
    double coarse = quadrature(panels);
    for (int doubling = 0; doubling < 10; ++doubling) {
        const double fine = quadrature(panels *= 2);
        constexpr double rounding = 4e-15; // relative, in a sum of that many terms
        const bool converged = std::abs(fine - coarse) <= rounding * (1 + std::abs(fine));
        coarse = fine;
        if (converged) break;
    }
    return coarse;
}

Eigen::Quaterniond FreeRotor::orientation(double t) const
{
    const Eigen::AngleAxisd about_L(precession(t), L_.normalized());
    const Matrix3d R = about_L.toRotationMatrix() * triad(0) * triad(t).transpose();
    return Eigen::Quaterniond(R).normalized();
}

double rotation_angle(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b)
{
    const Eigen::Quaterniond d = a.conjugate() * b;
    return 2 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

} // namespace rigor
