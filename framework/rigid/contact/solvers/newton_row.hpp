// SPDX-License-Identifier: MIT
// A contact in `newton_impulses` (newton_contact.hpp): its velocity error u, the projection P and
// the derivative of P.
#pragma once

#include "formulas/types.hpp"

#include <algorithm>

namespace rigor::newton {

// A contact in Newton's method.
struct NewtonRow {
    int body1 = -1, body2 = -1; // body k has the unknowns 6k … 6k + 5; -1: a static body
    Vector3d n, r1, r2;         // contact normal; lever arms of body 1 and body 2 [m]
    // Target velocity: target speed times n, plus `surface_velocity` (newton_contact.cpp) [m/s].
    Vector3d s;
    double friction = 0;
    double normal_K = 0;           // nᵀKn [1/kg]
    double rho = 0;                // penalty ρ [kg]
    double limit = 0;              // friction limit μ jₙ, constant during a round [N s]
    Vector3d j = Vector3d::Zero(); // impulse j on body 1 [N s]
};

struct Split {
    double normal = 0;
    Vector3d tangential;
};

inline Split split(const NewtonRow& row, const Vector3d& y)
{
    const double normal = y.dot(row.n);
    return {normal, y - normal * row.n};
}

// Velocity of the point of a body at the end of the lever arm r [m/s]. The unknowns v are V and
// ω of each body that can move. A static body has the index -1, and its velocity counts as zero
// here.
inline Vector3d velocity(const Eigen::VectorXd& v, int body, const Vector3d& r)
{
    if (body < 0) return Vector3d::Zero();
    const Vector3d V = v.segment<3>(6 * body), w = v.segment<3>(6 * body + 3);
    return V + w.cross(r);
}

// The velocity error u = J v - s of a contact, where J v is the relative velocity of the two bodies
// at the contact and s the target velocity.
inline Vector3d u(const NewtonRow& row, const Eigen::VectorXd& v, const Vector3d& s)
{
    return velocity(v, row.body1, row.r1) - velocity(v, row.body2, row.r2) - s;
}

// The projection P(y): a negative normal part becomes 0, and a tangential part that is longer than
// `limit` is shortened to this length.
inline Vector3d projected(const NewtonRow& row, const Vector3d& y)
{
    auto [normal, tangential] = split(row, y);
    const double length = tangential.norm();
    if (length > row.limit) tangential *= row.limit / length;
    return std::max(0.0, normal) * row.n + tangential;
}

// The derivative P'(y) of the projection.
inline Matrix3d slope(const NewtonRow& row, const Vector3d& y)
{
    const auto [normal, tangential] = split(row, y);
    const Matrix3d nn = row.n * row.n.transpose();
    Matrix3d D = Matrix3d::Zero();
    if (normal > 0) D += nn;
    const double length = tangential.norm();
    if (length <= row.limit) return D + Matrix3d::Identity() - nn;
    const Vector3d T = tangential / length;
    return D + row.limit / length * (Matrix3d::Identity() - nn - T * T.transpose());
}

} // namespace rigor::newton
