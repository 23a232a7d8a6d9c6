// SPDX-License-Identifier: MIT
// Columns instead of matrices, sums from the last to the first, blocks instead of S(x)ᵀ S(x).
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d cross_matrix(const Vector3d& w)
{
    // column i is w × eᵢ
    Matrix3d w_x;
    for (int i = 0; i < 3; ++i)
        w_x.col(i) = w.cross(Vector3d::Unit(i));
    return w_x;
}

Vector3d world_point(const Matrix3d& R, const Vector3d& X, const Vector3d& p)
{
    Vector3d x = X;
    for (int i = 2; i >= 0; --i)
        x += p[i] * R.col(i);
    return x;
}

Vector3d object_point(const Matrix3d& R, const Vector3d& X, const Vector3d& x)
{
    // solves R p = x - X
    return R.partialPivLu().solve(x - X);
}

Vector3d angular_velocity(const Matrix3d& R_dot, const Matrix3d& R)
{
    // ω = ½ Σ rᵢ × ṙᵢ over the columns
    Vector3d twice = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        twice += R.col(i).cross(R_dot.col(i));
    return twice / 2;
}

Vector3d point_velocity(const Vector3d& V, const Vector3d& omega, const Vector3d& X,
                        const Vector3d& x)
{
    // V - r × ω
    const Vector3d r = x - X;
    return {V.x() - (r.y() * omega.z() - r.z() * omega.y()),
            V.y() - (r.z() * omega.x() - r.x() * omega.z()),
            V.z() - (r.x() * omega.y() - r.y() * omega.x())};
}

Matrix36d velocity_modes(const Vector3d& X, const Vector3d& x)
{
    // column i is the velocity of x in mode i
    Matrix36d S;
    for (int i = 0; i < 3; ++i) {
        S.col(i) = Vector3d::Unit(i);
        S.col(3 + i) = point_velocity(Vector3d::Zero(), Vector3d::Unit(i), X, x);
    }
    return S;
}

Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X)
{
    // ( M δ    M c*ᵀ )
    // ( M c*   I     )  with the center of mass at X + c
    double M = 0;
    Vector3d first = Vector3d::Zero();
    Matrix3d I = Matrix3d::Zero();
    for (auto particle = particles.rbegin(); particle != particles.rend(); ++particle) {
        const Vector3d r = particle->position - X;
        M += particle->mass;
        first += particle->mass * r;
        I += particle->mass * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
    }
    Matrix6d result;
    result << M * Matrix3d::Identity(), cross_matrix(first).transpose(), cross_matrix(first), I;
    return result;
}

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    Wrench total;
    for (auto at = forces.rbegin(); at != forces.rend(); ++at) {
        total.force += at->force;
        total.torque -= at->force.cross(at->point - X);
    }
    return total;
}

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    MatrixStateRate rate;
    if (inverse_mass == 0) return rate; // static

    // each column of R is a vector that turns with the body
    Vector3d w = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        w += state.angular_momentum[i] * I_inverse.col(i);
    for (int i = 0; i < 3; ++i)
        rate.rotation_rate.col(i) = w.cross(state.rotation.col(i));
    rate.position_rate = state.velocity;
    rate.velocity_rate = wrench.force / (1 / inverse_mass);
    rate.angular_momentum_rate = wrench.torque;
    return rate;
}

Matrix36d velocity_mode_rates(const Vector3d& V, const Vector3d& v)
{
    // column 3 + i is the rate of eᵢ × (x - X), the particle's velocity in mode 3 + i
    Matrix36d rates = Matrix36d::Zero();
    for (int i = 0; i < 3; ++i)
        rates.col(3 + i) = Vector3d::Unit(i).cross(v - V);
    return rates;
}

Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X, const Vector3d&,
                       const Vector3d& omega)
{
    // ω × (ω × Σ m r) and ω × I ω = Σ m (ω·r) r × ω = -ω × C ω, with C = Σ m r rᵀ
    Vector3d first = Vector3d::Zero();
    Matrix3d C = Matrix3d::Zero();
    for (auto particle = particles.rbegin(); particle != particles.rend(); ++particle) {
        const Vector3d r = particle->position - X;
        first += particle->mass * r;
        C += particle->mass * r * r.transpose();
    }
    return {omega.cross(omega.cross(first)), -omega.cross(C * omega)};
}

} // namespace rigor
