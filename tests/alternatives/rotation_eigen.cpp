// SPDX-License-Identifier: MIT
// Eigen's quaternions and angle-axis, Rodrigues's formula, and steps in the body's own frame.
#include "formulas/rotation.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigor {

namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;

Quaterniond eigen(const Quaternion& q)
{
    return {q.s, q.v.x(), q.v.y(), q.v.z()};
}

Quaternion plain(const Quaterniond& q)
{
    return {q.w(), q.vec()};
}

// Scales by a power of two so that the largest component is about 1.
template <class Vector> Vector scaled(const Vector& v)
{
    const double largest = v.template lpNorm<Eigen::Infinity>();
    int exponent = 0;
    std::frexp(largest, &exponent);
    Vector result = v;
    for (Eigen::Index i = 0; i < v.size(); ++i)
        result[i] = std::ldexp(v[i], -exponent);
    return result;
}

double length(const Vector3d& v)
{
    return std::hypot(v.x(), v.y(), v.z());
}

// The angular velocity in the body's frame.
Vector3d body_rate(const Quaterniond& q, const BodyInertia& body, const Vector3d& L)
{
    return body.inverse_inertia * (q.conjugate() * L);
}

} // namespace

Matrix3d advance_matrix(const Matrix3d& R, const Vector3d& omega, double time_step)
{
    Matrix3d result = R;
    for (int i = 0; i < 3; ++i)
        result.col(i) -= R.col(i).cross(time_step * omega);
    return result;
}

Matrix3d gram_schmidt(const Matrix3d& R)
{
    Matrix3d A;
    for (int i = 0; i < 3; ++i)
        A.col(i) = R.col(i).isZero(0) ? Vector3d::Zero() : scaled<Vector3d>(R.col(i));
    if (A.col(0).isZero(0)) A.col(0) = Vector3d::UnitX();
    A.col(0).normalize();
    const Vector3d a = A.col(0), u = a.unitOrthogonal(), w = a.cross(u);
    // the second column in the frame (u, w), which is perpendicular to the first column
    const double x = u.dot(A.col(1)), y = w.dot(A.col(1)), r = std::hypot(x, y);
    const bool depends = r <= 4 * std::numeric_limits<double>::epsilon() * A.col(1).norm();
    const Vector3d b = depends ? u : Vector3d(x / r * u + y / r * w);
    Matrix3d Q;
    Q << a, b, a.cross(b);
    return Q;
}

Matrix3d euler_to_matrix(const Vector3d& angles)
{
    const Quaterniond q = AngleAxisd(angles.z(), Vector3d::UnitZ()) *
                          AngleAxisd(angles.y(), Vector3d::UnitY()) *
                          AngleAxisd(angles.x(), Vector3d::UnitX());
    return q.toRotationMatrix();
}

std::optional<Vector3d> euler_rates(const Vector3d& angles, const Vector3d& omega)
{
    const double cosine = std::cos(angles.y()), sine = std::sin(angles.y());
    if (!(std::abs(cosine) >= 1e-12)) return {};
    const double c = std::cos(angles.z()), s = std::sin(angles.z());
    const double forward = c * omega.x() + s * omega.y();
    return Vector3d(forward / cosine, c * omega.y() - s * omega.x(),
                    omega.z() + sine / cosine * forward);
}

Quaternion multiply(const Quaternion& a, const Quaternion& b)
{
    // the matrix of the left factor
    Eigen::Matrix4d A;
    A << a.s, -a.v.x(), -a.v.y(), -a.v.z(), //
        a.v.x(), a.s, -a.v.z(), a.v.y(),    //
        a.v.y(), a.v.z(), a.s, -a.v.x(),    //
        a.v.z(), -a.v.y(), a.v.x(), a.s;
    const Eigen::Vector4d product = A * Eigen::Vector4d(b.s, b.v.x(), b.v.y(), b.v.z());
    return {product[0], product.tail<3>()};
}

Quaternion conjugate(const Quaternion& q)
{
    return plain(eigen(q).conjugate());
}

Quaternion normalize(const Quaternion& q)
{
    const Eigen::Vector4d whole(q.s, q.v.x(), q.v.y(), q.v.z());
    if (whole.isZero(0)) return {};
    const Eigen::Vector4d unit = scaled(whole).normalized();
    return {unit[0], unit.tail<3>()};
}

Vector3d rotate(const Quaternion& q, const Vector3d& p)
{
    // Rodrigues: p + 2 s (v × p) + 2 v × (v × p)
    const Vector3d t = 2 * q.v.cross(p);
    return p + q.s * t + q.v.cross(t);
}

Matrix3d to_matrix(const Quaternion& q)
{
    return eigen(q).toRotationMatrix();
}

Quaternion quaternion_rate(const Quaternion& q, const Vector3d& omega)
{
    const Quaternion twice = multiply({0, omega}, q);
    return {0.5 * twice.s, 0.5 * twice.v};
}

Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step)
{
    if (omega.isZero(0)) return q;
    const Vector3d axis = scaled(omega).normalized();
    const double angle = time_step * length(omega);
    if (!std::isfinite(angle)) return q;
    return plain(Quaterniond(AngleAxisd(angle, axis)) * eigen(q));
}

Quaternion advance_linear(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const Quaternion turn = {1, time_step / 2 * omega};
    return normalize(multiply(turn, q));
}

double max_time_step(const Vector3d& omega)
{
    const double speed = length(omega);
    return speed == 0 ? std::numeric_limits<double>::infinity() : 0.5 / (speed / std::numbers::pi);
}

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    Wrench wrench;
    wrench.force = gravity * mass;
    return wrench;
}

RigidState step_symplectic_euler(const RigidState& state, const BodyInertia& body,
                                 const Wrench& wrench, double time_step)
{
    if (body.inverse_mass == 0) return state;
    RigidState next = state;
    next.velocity += body.inverse_mass * (time_step * wrench.force);
    next.position += time_step * next.velocity;
    next.angular_momentum += wrench.torque * time_step;
    const Quaterniond q = eigen(state.orientation);
    const Vector3d w = q * body_rate(q, body, next.angular_momentum);
    next.orientation = advance_linear(state.orientation, w, time_step);
    return next;
}

RigidState step_buss(const RigidState& state, const BodyInertia& body, const Wrench& wrench,
                     double time_step)
{
    if (body.inverse_mass == 0) return state;
    const double h = time_step;
    const Quaterniond q = eigen(state.orientation);

    // all in the frame of the body at the beginning of the step
    const Vector3d L = q.conjugate() * state.angular_momentum, tau = q.conjugate() * wrench.torque,
                   w = body.inverse_inertia * L, w_dot = body.inverse_inertia * (tau + L.cross(w));
    const Vector3d W = w + h * (w_dot / 2 - h / 12 * w.cross(w_dot));

    RigidState next = state;
    next.velocity += h * body.inverse_mass * wrench.force;
    next.position += h / 2 * (state.velocity + next.velocity);
    next.orientation = advance_exact(state.orientation, q * W, h);
    next.angular_momentum += h * wrench.torque;
    return next;
}

} // namespace rigor
