// SPDX-License-Identifier: MIT
// Assignment A3. Read: assignments/a3-rotation/README.md, then framework/formulas/rotation.hpp,
// which says what each function takes and returns, and what it does in special cases.
// Check: ./rigor check rotation, or one task, ./rigor check A3.5
#include "formulas/rotation.hpp"

namespace rigor {

// A3.1  R + Δt ω* R
Matrix3d advance_matrix(const Matrix3d& R, const Vector3d& omega, double time_step)
{
    throw NotImplemented("rotation::advance_matrix");
}

// A3.2  Gram–Schmidt on the columns, first to last; the third follows from the first two
Matrix3d gram_schmidt(const Matrix3d& R)
{
    throw NotImplemented("rotation::gram_schmidt");
}

// A3.3  R = R_z(ψ) R_y(θ) R_x(φ)
Matrix3d euler_to_matrix(const Vector3d& angles)
{
    throw NotImplemented("rotation::euler_to_matrix");
}

// A3.4  the solution of ω = ψ̇ e_z + R_z(ψ) (θ̇ e_y + R_y(θ) φ̇ e_x); empty at gimbal lock
std::optional<Vector3d> euler_rates(const Vector3d& angles, const Vector3d& omega)
{
    throw NotImplemented("rotation::euler_rates");
}

// A3.5  a b = (s_a s_b - v_a·v_b,  s_a v_b + s_b v_a + v_a × v_b)
Quaternion multiply(const Quaternion& a, const Quaternion& b)
{
    throw NotImplemented("rotation::multiply");
}

// A3.6  q̄ = (s, -v)
Quaternion conjugate(const Quaternion& q)
{
    throw NotImplemented("rotation::conjugate");
}

// A3.7  q / |q|; zero: the identity
Quaternion normalize(const Quaternion& q)
{
    throw NotImplemented("rotation::normalize");
}

// A3.8  q (0, p) q̄
Vector3d rotate(const Quaternion& q, const Vector3d& p)
{
    throw NotImplemented("rotation::rotate");
}

// A3.9  R, whose columns are the rotated axes
Matrix3d to_matrix(const Quaternion& q)
{
    throw NotImplemented("rotation::to_matrix");
}

// A3.10  q̇ = ½ (0, ω) q
Quaternion quaternion_rate(const Quaternion& q, const Vector3d& omega)
{
    throw NotImplemented("rotation::quaternion_rate");
}

// A3.11  (cos(Δt |ω|/2), sin(Δt |ω|/2) ω/|ω|) q, smooth at ω = 0
Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step)
{
    throw NotImplemented("rotation::advance_exact");
}

// A3.12  q + Δt/2 (0, ω) q, renormalized
Quaternion advance_linear(const Quaternion& q, const Vector3d& omega, double time_step)
{
    throw NotImplemented("rotation::advance_linear");
}

// A3.13  (π/2) / |ω|; at rest: infinity
double max_time_step(const Vector3d& omega)
{
    throw NotImplemented("rotation::max_time_step");
}

// A3.14  F = M g, τ = 0
Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    throw NotImplemented("rotation::gravity_wrench");
}

// A3.15  V' = V + Δt F/M    X' = X + Δt V'    L' = L + Δt τ    q' = advance_linear(q, ω, Δt)
//        with ω = R I_body⁻¹ Rᵀ L', where R is the matrix of the old q
RigidState step_symplectic_euler(const RigidState& state, const BodyInertia& body,
                                 const Wrench& wrench, double time_step)
{
    throw NotImplemented("rotation::step_symplectic_euler");
}

// A3.16  Ω = ω + Δt/2 ω̇ + Δt²/12 (ω̇ × ω), ω̇ = I⁻¹ (τ - ω × L)    q' = advance_exact(q, Ω, Δt)
RigidState step_buss(const RigidState& state, const BodyInertia& body, const Wrench& wrench,
                     double time_step)
{
    throw NotImplemented("rotation::step_buss");
}

} // namespace rigor
