// SPDX-License-Identifier: MIT
// Assignment A4. Read: assignments/a4-collision/README.md, then framework/formulas/collision.hpp,
// which says what each function takes and returns, and what it does in special cases.
// Check: ./rigor check collision, or one task, ./rigor check A4.5
#include "formulas/collision.hpp"

namespace rigor {

// A4.1  φ(p), trilinear in the cell that contains p
double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    throw NotImplemented("collision::sample_level_set");
}

// A4.2  n = ∇φ / |∇φ|
Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    throw NotImplemented("collision::level_set_normal");
}

// A4.3  v = v₁ - v₂,  vᵢ = ωᵢ × (x - Xᵢ) + Vᵢ
Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    throw NotImplemented("collision::relative_velocity");
}

// A4.4  K = δ/M + (x - X)*ᵀ I⁻¹ (x - X)*
Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    throw NotImplemented("collision::impulse_matrix");
}

// A4.5  j = -(1 + ε) vₙ / (nᵀ K n) n
Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    throw NotImplemented("collision::frictionless_impulse");
}

// A4.6  j = K⁻¹ (-v - ε vₙ n)
Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    throw NotImplemented("collision::static_friction_impulse");
}

// A4.7  |j_T| ≤ μ jₙ,  jₙ ≥ 0
bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    throw NotImplemented("collision::inside_friction_cone");
}

// A4.8  j = jₙ n - μ jₙ T,  jₙ = -(1 + ε) vₙ / (nᵀ K (n - μ T)),  T = (v - vₙ n)/|v - vₙ n|
Vector3d sliding_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                  double restitution, double friction)
{
    throw NotImplemented("collision::sliding_friction_impulse");
}

// A4.9  separating: zero; else the sticking impulse if it is in the cone; else the sliding impulse
Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    throw NotImplemented("collision::collision_impulse");
}

// A4.10  V += j/M,  L += (x - X) × j,  ω += I⁻¹ (x - X) × j
Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    throw NotImplemented("collision::apply_impulse");
}

// A4.11  the deepest of the contacts with v·n < 0
std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    throw NotImplemented("collision::deepest_approaching_point");
}

} // namespace rigor
