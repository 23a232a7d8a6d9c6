// SPDX-License-Identifier: MIT
// Solutions of assignment A1: points, velocities and the equations of motion of a rigid body. Each
// formula is the one of the lecture "Rigid bodies", in the order of the tasks.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d cross_matrix(const Vector3d& w)
{
    Matrix3d w_x;
    w_x << 0, -w[2], w[1], //
        w[2], 0, -w[0],    //
        -w[1], w[0], 0;
    return w_x;
}

Vector3d world_point(const Matrix3d& R, const Vector3d& X, const Vector3d& p)
{
    // x = R p + X
    return R * p + X;
}

Vector3d object_point(const Matrix3d& R, const Vector3d& X, const Vector3d& x)
{
    // p = Rᵀ (x - X)
    return R.transpose() * (x - X);
}

Vector3d angular_velocity(const Matrix3d& R_dot, const Matrix3d& R)
{
    // ω* = Ṙ Rᵀ, or the skew part of this matrix if it is not exactly skew-symmetric
    const Matrix3d A = R_dot * R.transpose();
    const Matrix3d w_x = (A - A.transpose()) / 2;
    return {w_x(2, 1), w_x(0, 2), w_x(1, 0)};
}

Vector3d point_velocity(const Vector3d& V, const Vector3d& omega, const Vector3d& X,
                        const Vector3d& x)
{
    // v = ω × (x - X) + V
    return omega.cross(x - X) + V;
}

Matrix36d velocity_modes(const Vector3d& X, const Vector3d& x)
{
    // S(x) = ( δ  X* - x* )
    Matrix36d S;
    S << Matrix3d::Identity(), cross_matrix(X - x);
    return S;
}

Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X)
{
    // Sᵀ M S = Σ mᵢ S(xᵢ)ᵀ S(xᵢ)
    Matrix6d STMS = Matrix6d::Zero();
    for (const Particle& particle : particles) {
        const Matrix36d S = velocity_modes(X, particle.position);
        STMS += particle.mass * S.transpose() * S;
    }
    return STMS;
}

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    // F = Σ fᵢ    τ = Σ (xᵢ - X) × fᵢ
    Vector3d F = Vector3d::Zero(), tau = Vector3d::Zero();
    for (const PointForce& at : forces) {
        F += at.force;
        tau += (at.point - X).cross(at.force);
    }
    return {F, tau};
}

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    if (inverse_mass == 0) return {}; // a static body does not move

    const Matrix3d& R = state.rotation;
    const Vector3d& V = state.velocity;
    const Vector3d& L = state.angular_momentum;
    const Vector3d& F = wrench.force;
    const Vector3d& tau = wrench.torque;

    // Ẋ = V    Ṙ = ω* R  with  ω = I(t)⁻¹ L    V̇ = F / M    L̇ = τ
    const Vector3d w = I_inverse * L;
    return {V, cross_matrix(w) * R, F * inverse_mass, tau};
}

Matrix36d velocity_mode_rates(const Vector3d& V, const Vector3d& v)
{
    // Ṡ = ( 0  V* - v* )
    Matrix36d S_dot;
    S_dot << Matrix3d::Zero(), cross_matrix(V - v);
    return S_dot;
}

Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X, const Vector3d& V,
                       const Vector3d& omega)
{
    Eigen::Matrix<double, 6, 1> u, sum = Eigen::Matrix<double, 6, 1>::Zero();
    u << V, omega;

    // Σ mᵢ Sᵢᵀ Ṡᵢ u
    for (const Particle& particle : particles) {
        const Vector3d v = point_velocity(V, omega, X, particle.position);
        const Matrix36d S = velocity_modes(X, particle.position);
        sum += particle.mass * S.transpose() * (velocity_mode_rates(V, v) * u);
    }
    return {sum.head<3>(), sum.tail<3>()};
}

} // namespace rigor
