// SPDX-License-Identifier: MIT
// A sum over entries for nᵀ K n, an LU decomposition with full pivots, sums in another order.
// K is δ/M - r* (I⁻¹ r*) with r = x - X, since the transpose of r* is -r*.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

namespace {

Matrix3d star(const Vector3d& r)
{
    Matrix3d S;
    S << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    return S;
}

double quadratic(const Matrix3d& K, const Vector3d& a, const Vector3d& b)
{
    double sum = 0;
    for (int i = 2; i >= 0; --i)
        for (int j = 2; j >= 0; --j)
            sum += a[i] * K(i, j) * b[j];
    return sum;
}

} // namespace

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    const Vector3d v1 = star(body1.angular_velocity) * (x - body1.position) + body1.velocity;
    const Vector3d v2 = star(body2.angular_velocity) * (x - body2.position) + body2.velocity;
    return v1 - v2;
}

Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    if (inverse_mass == 0) return Matrix3d::Zero();
    Matrix3d K = -star(x - X) * (I_inverse * star(x - X));
    K.diagonal().array() += inverse_mass;
    return K;
}

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    if (K.cwiseAbs().maxCoeff() == 0) return Vector3d::Zero();
    const Vector3d wanted = n * (-restitution * v.dot(n)) - v;
    return K.fullPivLu().solve(wanted);
}

Vector3d sliding_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                  double restitution, double friction)
{
    const double v_n = v.dot(n);
    const Vector3d v_T = v - v_n * n;
    if (v_T.norm() <= 1e-12 * v.norm()) return frictionless_impulse(K, v, n, restitution);

    const Vector3d T = v_T.normalized();
    const double k = quadratic(K, n, n) - friction * quadratic(K, n, T);
    if (k > 0) {
        const double j_n = -(v_n + restitution * v_n) / k;
        return j_n * (n - friction * T);
    }
    const Vector3d j = static_friction_impulse(K, v, n, restitution);
    const double j_n = j.dot(n);
    if (j_n <= 0) return Vector3d::Zero();
    const Vector3d j_T = j - j_n * n;
    return j_T.norm() <= friction * j_n ? j : Vector3d(j_n * (n + friction * j_T.normalized()));
}

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    if (body.is_static()) return body;
    Body after = body;
    const Vector3d turn = star(x) * j - star(body.position) * j;
    after.velocity = body.velocity + body.inverse_mass * j;
    after.angular_momentum = body.angular_momentum + turn;
    after.angular_velocity = body.angular_velocity + body.inverse_inertia * turn;
    return after;
}

} // namespace rigor
