// SPDX-License-Identifier: MIT
// Assignment A1. Read: assignments/a1-kinematics/README.md, then framework/formulas/kinematics.hpp,
// which says what each function takes and returns, and what it does in special cases.
// Check: ./rigor check kinematics, or one task, ./rigor check A1.4
#include "formulas/kinematics.hpp"

namespace rigor {

// A1.1  w* x = w × x
Matrix3d cross_matrix(const Vector3d& w)
{
    throw NotImplemented("kinematics::cross_matrix");
}

// A1.2  x = R p + X
Vector3d world_point(const Matrix3d& R, const Vector3d& X, const Vector3d& p)
{
    throw NotImplemented("kinematics::world_point");
}

// A1.3  p = Rᵀ (x - X)
Vector3d object_point(const Matrix3d& R, const Vector3d& X, const Vector3d& x)
{
    throw NotImplemented("kinematics::object_point");
}

// A1.4  ω* = Ṙ Rᵀ, or its skew part
Vector3d angular_velocity(const Matrix3d& R_dot, const Matrix3d& R)
{
    throw NotImplemented("kinematics::angular_velocity");
}

// A1.5  v = ω × (x - X) + V
Vector3d point_velocity(const Vector3d& V, const Vector3d& omega, const Vector3d& X,
                        const Vector3d& x)
{
    throw NotImplemented("kinematics::point_velocity");
}

// A1.6  S(x) = ( δ  X* - x* )
Matrix36d velocity_modes(const Vector3d& X, const Vector3d& x)
{
    throw NotImplemented("kinematics::velocity_modes");
}

// A1.7  Sᵀ M S = Σ mᵢ S(xᵢ)ᵀ S(xᵢ)
Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X)
{
    throw NotImplemented("kinematics::generalized_mass");
}

// A1.8  F = Σ fᵢ    τ = Σ (xᵢ - X) × fᵢ
Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    throw NotImplemented("kinematics::net_wrench");
}

// A1.9  Ẋ = V    Ṙ = ω* R  with  ω = I(t)⁻¹ L    V̇ = F / M    L̇ = τ
MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    throw NotImplemented("kinematics::equations_of_motion");
}

// A1.12  Ṡ = ( 0  V* - v* )
Matrix36d velocity_mode_rates(const Vector3d& V, const Vector3d& v)
{
    throw NotImplemented("kinematics::velocity_mode_rates");
}

// A1.13  Σ mᵢ Sᵢᵀ Ṡᵢ u
Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X, const Vector3d& V,
                       const Vector3d& omega)
{
    throw NotImplemented("kinematics::inertial_wrench");
}

} // namespace rigor
