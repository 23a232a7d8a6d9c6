// SPDX-License-Identifier: MIT
// Solutions of assignment A3: rotation matrices, Euler angles, quaternions and the time
// integration of a rigid body. `step_buss` is the augmented second-order method of Buss (2000); the
// other formulas are those of the lecture "Inertia, rotation, impulses", in the order of the tasks.
#include "formulas/rotation.hpp"

#include "formulas/kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigor {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

// v/|v| for v ≠ 0. Dividing by the largest component first keeps the squares in range.
Vector3d direction(const Vector3d& v)
{
    const Vector3d scaled = v / v.lpNorm<Eigen::Infinity>();
    return scaled / scaled.norm();
}

// I⁻¹ = R I_body⁻¹ Rᵀ for the body in orientation q.
Matrix3d inverse_inertia_world(const Quaternion& q, const BodyInertia& body)
{
    const Matrix3d R = to_matrix(q);
    return R * body.inverse_inertia * R.transpose();
}

} // namespace

Matrix3d advance_matrix(const Matrix3d& R, const Vector3d& omega, double time_step)
{
    // R + Δt ω* R
    return R + time_step * cross_matrix(omega) * R;
}

Matrix3d gram_schmidt(const Matrix3d& R)
{
    // a = R₀ / |R₀|
    const Vector3d a = R.col(0).isZero(0) ? Vector3d::UnitX() : direction(R.col(0));

    // b = R₁ - (a·R₁) a, normalized
    Vector3d b = R.col(1).isZero(0) ? Vector3d::Zero() : direction(R.col(1));
    b -= a.dot(b) * a;
    if (b.norm() <= 4 * eps) b = a.unitOrthogonal(); // R₁ is 0 or parallel to R₀
    b.normalize();
    b = direction(b - a.dot(b) * a); // again, because a short b has a rounding error along a

    Matrix3d Q;
    Q << a, b, a.cross(b); // det = +1
    return Q;
}

Matrix3d euler_to_matrix(const Vector3d& angles)
{
    const double phi = angles.x(), theta = angles.y(), psi = angles.z();
    const Matrix3d R_x = Eigen::AngleAxisd(phi, Vector3d::UnitX()).toRotationMatrix();
    const Matrix3d R_y = Eigen::AngleAxisd(theta, Vector3d::UnitY()).toRotationMatrix();
    const Matrix3d R_z = Eigen::AngleAxisd(psi, Vector3d::UnitZ()).toRotationMatrix();

    // R = R_z(ψ) R_y(θ) R_x(φ)
    return R_z * R_y * R_x;
}

std::optional<Vector3d> euler_rates(const Vector3d& angles, const Vector3d& omega)
{
    const double theta = angles.y(), psi = angles.z();
    constexpr double locked = 1e-12; // |cos θ| below which yaw and roll turn about one axis
    if (std::abs(std::cos(theta)) < locked) return std::nullopt; // gimbal lock

    // R_z(ψ)ᵀ ω = ψ̇ e_z + θ̇ e_y + φ̇ R_y(θ) e_x,   R_y(θ) e_x = (cos θ, 0, -sin θ)
    const Vector3d w = Eigen::AngleAxisd(-psi, Vector3d::UnitZ()) * omega;
    const double phi_dot = w.x() / std::cos(theta);
    const double theta_dot = w.y();
    const double psi_dot = w.z() + phi_dot * std::sin(theta);
    return Vector3d(phi_dot, theta_dot, psi_dot);
}

Quaternion multiply(const Quaternion& a, const Quaternion& b)
{
    // a b = (s_a s_b - v_a·v_b,  s_a v_b + s_b v_a + v_a × v_b)
    return {a.s * b.s - a.v.dot(b.v), a.s * b.v + b.s * a.v + a.v.cross(b.v)};
}

Quaternion conjugate(const Quaternion& q)
{
    // q̄ = (s, -v)
    return {q.s, -q.v};
}

Quaternion normalize(const Quaternion& q)
{
    // The largest component becomes ±1, so that no square under- or overflows.
    const double largest = std::max(std::abs(q.s), q.v.lpNorm<Eigen::Infinity>());
    if (largest == 0) return {1, Vector3d::Zero()}; // the zero quaternion
    const double s = q.s / largest;
    const Vector3d v = q.v / largest;

    // q / |q|
    const double length = std::sqrt(s * s + v.squaredNorm());
    return {s / length, v / length};
}

Vector3d rotate(const Quaternion& q, const Vector3d& p)
{
    // q (0, p) q̄
    return multiply(multiply(q, {0, p}), conjugate(q)).v;
}

Matrix3d to_matrix(const Quaternion& q)
{
    // The columns of R are the rotated axes.
    Matrix3d R;
    R << rotate(q, Vector3d::UnitX()), rotate(q, Vector3d::UnitY()), rotate(q, Vector3d::UnitZ());
    return R;
}

Quaternion quaternion_rate(const Quaternion& q, const Vector3d& omega)
{
    // q̇ = ½ (0, ω) q
    return multiply({0, omega / 2}, q);
}

Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step)
{
    if (omega.isZero(0)) return q; // there is no axis to turn about

    // (cos(Δt |ω|/2), sin(Δt |ω|/2) ω/|ω|) q
    constexpr double largest = std::numeric_limits<double>::max(); // sin(∞) is NaN
    const double half_angle = std::clamp(time_step / 2 * omega.stableNorm(), -largest, largest);
    const Vector3d axis = direction(omega);
    return multiply({std::cos(half_angle), std::sin(half_angle) * axis}, q);
}

Quaternion advance_linear(const Quaternion& q, const Vector3d& omega, double time_step)
{
    // q + Δt/2 (0, ω) q, renormalized
    const Quaternion q_dot = quaternion_rate(q, omega);
    return normalize({q.s + time_step * q_dot.s, q.v + time_step * q_dot.v});
}

double max_time_step(const Vector3d& omega)
{
    if (omega.isZero(0)) return std::numeric_limits<double>::infinity(); // at rest
    // (π/2) / |ω|
    return std::numbers::pi / 2 / omega.stableNorm();
}

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    // F = M g, τ = 0
    return {mass * gravity, Vector3d::Zero()};
}

RigidState step_symplectic_euler(const RigidState& state, const BodyInertia& body,
                                 const Wrench& wrench, double time_step)
{
    if (body.inverse_mass == 0) return state; // static
    const auto& [X, q, V, L] = state;
    const auto& [F, tau] = wrench;
    const double M_inv = body.inverse_mass;

    // V' = V + Δt F/M    X' = X + Δt V'    L' = L + Δt τ    q' = advance_linear(q, ω, Δt)
    const Vector3d V_new = V + time_step * M_inv * F;
    const Vector3d X_new = X + time_step * V_new;
    const Vector3d L_new = L + time_step * tau;

    // ω = I⁻¹ L', with the new L and the old q
    const Vector3d w = inverse_inertia_world(q, body) * L_new;
    return {X_new, advance_linear(q, w, time_step), V_new, L_new};
}

RigidState step_buss(const RigidState& state, const BodyInertia& body, const Wrench& wrench,
                     double time_step)
{
    if (body.inverse_mass == 0) return state; // static
    const auto& [X, q, V, L] = state;
    const auto& [F, tau] = wrench;
    const double h = time_step, M_inv = body.inverse_mass;
    const Matrix3d I_inv = inverse_inertia_world(q, body);

    // ω = I⁻¹ L    ω̇ = I⁻¹ (τ - ω × L)
    const Vector3d w = I_inv * L;
    const Vector3d w_dot = I_inv * (tau - w.cross(L));

    // Ω = ω + Δt/2 ω̇ + Δt²/12 (ω̇ × ω): the mean angular velocity, and a correction because
    // rotations do not commute
    const Vector3d W = w + h / 2 * w_dot + h * h / 12 * w_dot.cross(w);

    // X' = X + Δt V + ½ Δt² F/M    q' = advance_exact(q, Ω, Δt)    V' = V + Δt F/M    L' = L + Δt τ
    return {X + h * V + h * h / 2 * M_inv * F, advance_exact(q, W, h), V + h * M_inv * F,
            L + h * tau};
}

} // namespace rigor
