// SPDX-License-Identifier: MIT
// Formulas of topic `collision` in a form that the compiler can inline. They replace only the
// formulas of the reference implementation, never those of a student. A test checks that both give
// the same results up to rounding.
#pragma once

#include "rigid/bodies/inlined_product.hpp"

namespace rigor::optimised {

/// Inlined form of `relative_velocity`.
[[gnu::always_inline]] inline Vector3d relative_velocity(const Body& body1, const Body& body2,
                                                         const Vector3d& x)
{
    return body1.velocity + body1.angular_velocity.cross(x - body1.position) - body2.velocity -
           body2.angular_velocity.cross(x - body2.position);
}

/// Inlined form of `impulse_matrix`: δ/M + r*ᵀ I⁻¹ r* with r = x - X (X: position of the body, δ:
/// identity, r*: the matrix with r* a = r × a, I⁻¹: `J` in the code). Column i of the second term
/// is (I⁻¹ (r × eᵢ)) × r.
[[gnu::always_inline]] inline Matrix3d impulse_matrix(const Body& body, const Vector3d& x)
{
    const Vector3d r = x - body.position;
    const Matrix3d& J = body.inverse_inertia;
    Matrix3d K;
    K.col(0) = Vector3d(r.z() * J.col(1) - r.y() * J.col(2)).cross(r);
    K.col(1) = Vector3d(r.x() * J.col(2) - r.z() * J.col(0)).cross(r);
    K.col(2) = Vector3d(r.y() * J.col(0) - r.x() * J.col(1)).cross(r);
    K.diagonal().array() += body.inverse_mass;
    return K;
}

/// Inlined form of `apply_impulse`, which changes the body in place. Do not call it for a static
/// body, whose angular momentum would change.
inline void apply_impulse(Body& body, const Vector3d& x, const Vector3d& j)
{
    const Vector3d torque = (x - body.position).cross(j);
    body.velocity += body.inverse_mass * j;
    body.angular_momentum += torque;
    body.angular_velocity += product(body.inverse_inertia, torque);
}

} // namespace rigor::optimised
