// SPDX-License-Identifier: MIT
// A normal velocity of -0 counts as approaching, because only its sign bit is looked at.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

namespace {

Vector3d sticking(const Matrix3d& K, const Vector3d& v, const Vector3d& n, double restitution)
{
    const Vector3d change = -v - restitution * v.dot(n) * n;
    return K.inverse() * change;
}

Vector3d shortened(const Vector3d& j, const Vector3d& n, double friction)
{
    const double normal = j.dot(n);
    if (normal <= 0) {
        return Vector3d::Zero();
    }
    Vector3d tangential = j - normal * n;
    const double length = tangential.norm();
    if (length > friction * normal) {
        tangential *= friction * normal / length;
    }
    return normal * n + tangential;
}

Vector3d sliding(const Matrix3d& K, const Vector3d& v, const Vector3d& n, double restitution,
                 double friction)
{
    const double normal_speed = v.dot(n);
    const double target = -(1 + restitution) * normal_speed;
    const Vector3d tangential = v - normal_speed * n;
    const double speed = tangential.norm();
    if (speed <= 1e-12 * v.norm()) {
        return target / n.dot(K * n) * n;
    }
    const Vector3d edge = n - friction / speed * tangential;
    const double effect = n.dot(K * edge);
    if (effect > 0) {
        return target / effect * edge;
    }
    return shortened(sticking(K, v, n, restitution), n, friction);
}

} // namespace

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    const double approach = v.dot(n);
    if (!std::signbit(approach) || K.isZero(0)) {
        return Vector3d::Zero();
    }
    const Vector3d j = sticking(K, v, n, restitution);
    const double normal = j.dot(n);
    const Vector3d tangential = j - normal * n;
    if (normal >= 0 && tangential.norm() <= friction * normal) {
        return j;
    }
    return sliding(K, v, n, restitution, friction);
}

} // namespace rigor
