// SPDX-License-Identifier: MIT
// Matrices written out, Householder's orthonormalization, rates from a linear system, body frame.
// Quaternions and Euler matrices are computed entry by entry. The rates of Euler angles come from
// solving ω = B (φ̇, θ̇, ψ̇). Steps apply I⁻¹ in the body's own frame.
#include "formulas/rotation.hpp"

#include <cmath>
#include <limits>

namespace rigor {

namespace {

const double quarter_turn = std::acos(0.0);

// The largest power of two that is not above |x|. A division by it causes no rounding.
double magnitude(double x)
{
    return std::ldexp(1.0, std::ilogb(x));
}

// I⁻¹ L in world space, computed in the body's own frame.
Vector3d by_inverse_inertia(const Quaternion& q, const BodyInertia& body, const Vector3d& L)
{
    const Vector3d L_body = rotate(conjugate(q), L);
    return rotate(q, body.inverse_inertia * L_body);
}

} // namespace

Matrix3d advance_matrix(const Matrix3d& R, const Vector3d& omega, double time_step)
{
    // each column turns about ω
    Matrix3d result;
    for (int i = 0; i < 3; ++i)
        result.col(i) = R.col(i) + time_step * omega.cross(R.col(i));
    return result;
}

Matrix3d gram_schmidt(const Matrix3d& R)
{
    // Q of Householder's decomposition Q U, with the signs of its columns chosen to make U's
    // diagonal positive
    Matrix3d scaled = R;
    for (int i = 0; i < 3; ++i)
        if (R.col(i).lpNorm<Eigen::Infinity>() > 0)
            scaled.col(i) /= magnitude(R.col(i).lpNorm<Eigen::Infinity>());
    const Eigen::HouseholderQR<Matrix3d> qr(scaled);
    Matrix3d Q = qr.householderQ();
    for (int i = 0; i < 2; ++i)
        if (qr.matrixQR()(i, i) < 0) Q.col(i) = -Q.col(i);
    if (Q.determinant() < 0) Q.col(2) = -Q.col(2);
    return Q;
}

Matrix3d euler_to_matrix(const Vector3d& angles)
{
    const double cx = std::cos(angles.x()), sx = std::sin(angles.x());
    const double cy = std::cos(angles.y()), sy = std::sin(angles.y());
    const double cz = std::cos(angles.z()), sz = std::sin(angles.z());
    Matrix3d R;
    R << cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx, //
        sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx,  //
        -sy, cy * sx, cy * cx;
    return R;
}

std::optional<Vector3d> euler_rates(const Vector3d& angles, const Vector3d& omega)
{
    const double cy = std::cos(angles.y()), sy = std::sin(angles.y());
    const double cz = std::cos(angles.z()), sz = std::sin(angles.z());
    if (std::abs(cy) < 1e-12) return {};

    // ω = B (φ̇, θ̇, ψ̇)
    Matrix3d B;
    B << cz * cy, -sz, 0, sz * cy, cz, 0, -sy, 0, 1;
    return Vector3d(B.partialPivLu().solve(omega));
}

Quaternion multiply(const Quaternion& a, const Quaternion& b)
{
    const Vector3d &u = a.v, &v = b.v;
    return {-u.z() * v.z() - u.y() * v.y() - u.x() * v.x() + a.s * b.s,
            {u.y() * v.z() - u.z() * v.y() + u.x() * b.s + a.s * v.x(),
             u.z() * v.x() - u.x() * v.z() + u.y() * b.s + a.s * v.y(),
             u.x() * v.y() - u.y() * v.x() + u.z() * b.s + a.s * v.z()}};
}

Quaternion conjugate(const Quaternion& q)
{
    return {q.s, Vector3d::Zero() - q.v};
}

Quaternion normalize(const Quaternion& q)
{
    Eigen::Vector4d c(q.s, q.v.x(), q.v.y(), q.v.z());
    if ((c.array() == 0).all()) return {};
    c /= magnitude(c.lpNorm<Eigen::Infinity>());
    c.normalize();
    return {c[0], c.tail<3>()};
}

Vector3d rotate(const Quaternion& q, const Vector3d& p)
{
    // p + 2 s (v × p) + 2 v × (v × p)
    const Vector3d t = 2 * q.v.cross(p);
    return p + q.s * t + q.v.cross(t);
}

Matrix3d to_matrix(const Quaternion& q)
{
    const double s = q.s, x = q.v.x(), y = q.v.y(), z = q.v.z();
    Matrix3d R;
    R << 1 - 2 * (y * y + z * z), 2 * (x * y - s * z), 2 * (x * z + s * y), //
        2 * (x * y + s * z), 1 - 2 * (x * x + z * z), 2 * (y * z - s * x),  //
        2 * (x * z - s * y), 2 * (y * z + s * x), 1 - 2 * (x * x + y * y);
    return R;
}

Quaternion quaternion_rate(const Quaternion& q, const Vector3d& omega)
{
    return {-omega.dot(q.v) / 2, (q.s * omega - q.v.cross(omega)) / 2};
}

Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step)
{
    // sin(a)/a for a = |Δt ω/2|, by its series near 0
    constexpr double largest = std::numeric_limits<double>::max();
    const double rate = omega.stableNorm();
    const double a = std::min(std::abs(time_step) / 2 * rate, largest);
    if (a < 1e-3) {
        const double sinc = 1 - a * a / 6 * (1 - a * a / 20);
        return multiply({std::cos(a), sinc * (time_step / 2) * omega}, q);
    }
    const Vector3d axis = std::copysign(1.0, time_step) * omega.stableNormalized();
    return multiply({std::cos(a), std::sin(a) * axis}, q);
}

Quaternion advance_linear(const Quaternion& q, const Vector3d& omega, double time_step)
{
    // multiplies by (1, Δt ω/2)
    return normalize(multiply({1, time_step / 2 * omega}, q));
}

double max_time_step(const Vector3d& omega)
{
    const double rate = std::hypot(omega.x(), omega.y(), omega.z());
    return rate > 0 ? quarter_turn / rate : std::numeric_limits<double>::infinity();
}

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    Wrench wrench;
    for (int i = 0; i < 3; ++i)
        wrench.force[i] = gravity[i] * mass;
    return wrench;
}

RigidState step_symplectic_euler(const RigidState& state, const BodyInertia& body,
                                 const Wrench& wrench, double time_step)
{
    if (body.inverse_mass == 0) return state;
    RigidState next = state;
    next.angular_momentum += wrench.torque * time_step;
    next.velocity += wrench.force * (time_step * body.inverse_mass);
    next.position += next.velocity * time_step;
    next.orientation = advance_linear(
        state.orientation, by_inverse_inertia(state.orientation, body, next.angular_momentum),
        time_step);
    return next;
}

RigidState step_buss(const RigidState& state, const BodyInertia& body, const Wrench& wrench,
                     double time_step)
{
    if (body.inverse_mass == 0) return state;
    const double h = time_step;
    const Vector3d a = wrench.force * body.inverse_mass;

    // L × ω stands for -ω × L, and `mean` is Ω = ω + h/2 (ω̇ + h/6 ω̇ × ω)
    const Quaternion& q = state.orientation;
    const Vector3d& L = state.angular_momentum;
    const Vector3d w = by_inverse_inertia(q, body, L);
    const Vector3d w_dot = by_inverse_inertia(q, body, L.cross(w) + wrench.torque);
    const Vector3d mean = w + h / 2 * (w_dot - h / 6 * w.cross(w_dot));

    RigidState next = state;
    next.velocity += h * a;
    next.position += h / 2 * (state.velocity + next.velocity);
    next.angular_momentum += h * wrench.torque;
    next.orientation = advance_exact(q, mean, h);
    return next;
}

} // namespace rigor
