// SPDX-License-Identifier: MIT
// Component loops with fused multiply-add, the permutation symbol, and sums from the last element.
#include "formulas/kinematics.hpp"

#include <cmath>

namespace rigor {

namespace {

// ε_ijk, which is 1, -1 or 0
int permutation(int i, int j, int k)
{
    return (j - i) * (k - j) * (k - i) / 2;
}

// a × b + c
Vector3d cross_plus(const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
    Vector3d sum = c;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                if (permutation(i, j, k) != 0)
                    sum[i] = std::fma(permutation(i, j, k) * a[j], b[k], sum[i]);
    return sum;
}

const Vector3d zero(0, 0, 0);

} // namespace

Matrix3d cross_matrix(const Vector3d& w)
{
    Matrix3d A;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            A(i, k) = 0;
            for (int j = 0; j < 3; ++j)
                if (permutation(i, j, k) != 0) A(i, k) += permutation(i, j, k) * w[j];
        }
    return A;
}

Vector3d world_point(const Matrix3d& R, const Vector3d& X, const Vector3d& p)
{
    Vector3d x = X;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            x[i] = std::fma(R(i, j), p[j], x[i]);
    return x;
}

Vector3d object_point(const Matrix3d& R, const Vector3d& X, const Vector3d& x)
{
    Vector3d p;
    for (int i = 0; i < 3; ++i)
        p[i] = R.col(i).dot(x) - R.col(i).dot(X);
    return p;
}

Vector3d angular_velocity(const Matrix3d& R_dot, const Matrix3d& R)
{
    // ω = ½ Σ Rᵢ × Ṙᵢ over the columns
    Vector3d w = zero;
    for (int i = 2; i >= 0; --i)
        w = cross_plus(R.col(i), R_dot.col(i), w);
    return 0.5 * w;
}

Vector3d point_velocity(const Vector3d& V, const Vector3d& omega, const Vector3d& X,
                        const Vector3d& x)
{
    return cross_plus(X - x, omega, V);
}

Matrix36d velocity_modes(const Vector3d& X, const Vector3d& x)
{
    Matrix36d S;
    for (int i = 0; i < 3; ++i) {
        S.col(i) = Vector3d::Unit(i);
        S.col(3 + i) = Vector3d::Unit(i).cross(x - X); // the velocity of x in a turn about axis i
    }
    return S;
}

Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X)
{
    Matrix6d sum = Matrix6d::Zero();
    for (std::size_t i = particles.size(); i-- > 0;) {
        const double m = particles[i].mass;
        const Vector3d r = particles[i].position - X;
        sum.topLeftCorner<3, 3>().diagonal().array() += m;
        sum.topRightCorner<3, 3>() -= m * cross_matrix(r);
        sum.bottomLeftCorner<3, 3>() += m * cross_matrix(r);
        sum.bottomRightCorner<3, 3>() +=
            m * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
    }
    return sum;
}

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    Wrench sum;
    for (std::size_t i = forces.size(); i-- > 0;) {
        sum.force += forces[i].force;
        sum.torque = cross_plus(forces[i].force, X - forces[i].point, sum.torque);
    }
    return sum;
}

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    MatrixStateRate rate;
    if (inverse_mass == 0) return rate;
    Vector3d w = zero;
    for (int j = 0; j < 3; ++j)
        w += I_inverse.col(j) * state.angular_momentum[j];
    rate.position_rate = state.velocity;
    for (int i = 0; i < 3; ++i)
        rate.rotation_rate.col(i) = cross_plus(w, state.rotation.col(i), zero);
    rate.velocity_rate = wrench.force / (1 / inverse_mass);
    rate.angular_momentum_rate = wrench.torque;
    return rate;
}

Matrix36d velocity_mode_rates(const Vector3d& V, const Vector3d& v)
{
    Matrix36d S_dot;
    for (int i = 0; i < 3; ++i) {
        S_dot.col(i) = zero;
        S_dot.col(3 + i) = Vector3d::Unit(i).cross(v - V);
    }
    return S_dot;
}

Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X, const Vector3d&,
                       const Vector3d& omega)
{
    // a = ω × (ω × r) = ω (ω·r) - r (ω·ω)
    Wrench sum;
    for (std::size_t i = particles.size(); i-- > 0;) {
        const Vector3d r = particles[i].position - X;
        const Vector3d f = particles[i].mass * (omega * omega.dot(r) - r * omega.squaredNorm());
        sum.force += f;
        sum.torque += r.cross(f);
    }
    return sum;
}

} // namespace rigor
