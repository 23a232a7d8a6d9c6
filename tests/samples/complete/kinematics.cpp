// SPDX-License-Identifier: MIT
// A sample submission that is complete and is not written like the reference.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d cross_matrix(const Vector3d& w)
{
    Matrix3d star;
    for (int i = 0; i < 3; ++i)
        star.col(i) = w.cross(Vector3d::Unit(i));
    return star;
}

Vector3d world_point(const Matrix3d& R, const Vector3d& X, const Vector3d& p)
{
    return X + R * p;
}

Vector3d object_point(const Matrix3d& R, const Vector3d& X, const Vector3d& x)
{
    const Vector3d r = x - X;
    return {R.col(0).dot(r), R.col(1).dot(r), R.col(2).dot(r)};
}

Vector3d angular_velocity(const Matrix3d& R_dot, const Matrix3d& R)
{
    // ω × r = ṙ for each column r of R, so half the sum of r × ṙ is the vector of the skew part
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        sum += R.col(i).cross(R_dot.col(i));
    return sum / 2;
}

Vector3d point_velocity(const Vector3d& V, const Vector3d& omega, const Vector3d& X,
                        const Vector3d& x)
{
    return V + cross_matrix(omega) * (x - X);
}

Matrix36d velocity_modes(const Vector3d& X, const Vector3d& x)
{
    Matrix36d S;
    S.leftCols<3>().setIdentity();
    S.rightCols<3>() = cross_matrix(X - x);
    return S;
}

Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X)
{
    Matrix6d result = Matrix6d::Zero();
    for (const Particle& particle : particles) {
        const Matrix3d r_x = cross_matrix(X - particle.position);
        result.topLeftCorner<3, 3>() += particle.mass * Matrix3d::Identity();
        result.topRightCorner<3, 3>() += particle.mass * r_x;
        result.bottomLeftCorner<3, 3>() += particle.mass * r_x.transpose();
        result.bottomRightCorner<3, 3>() += particle.mass * r_x.transpose() * r_x;
    }
    return result;
}

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    Wrench sum;
    for (const PointForce& f : forces) {
        sum.force += f.force;
        sum.torque += cross_matrix(f.point - X) * f.force;
    }
    return sum;
}

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    MatrixStateRate rate;
    if (inverse_mass == 0) return rate;

    const Vector3d omega = I_inverse * state.angular_momentum;
    rate.position_rate = state.velocity;
    for (int i = 0; i < 3; ++i)
        rate.rotation_rate.col(i) = omega.cross(state.rotation.col(i));
    rate.velocity_rate = inverse_mass * wrench.force;
    rate.angular_momentum_rate = wrench.torque;
    return rate;
}

Matrix36d velocity_mode_rates(const Vector3d& V, const Vector3d& v)
{
    Matrix36d S_dot;
    S_dot << Matrix3d::Zero(), cross_matrix(V - v);
    return S_dot;
}

Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X, const Vector3d&,
                       const Vector3d& omega)
{
    Wrench sum;
    for (const Particle& particle : particles) {
        const Vector3d r = particle.position - X;
        const Vector3d f = particle.mass * omega.cross(omega.cross(r));
        sum.force += f;
        sum.torque += r.cross(f);
    }
    return sum;
}

} // namespace rigor
