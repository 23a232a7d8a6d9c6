// SPDX-License-Identifier: MIT
// Correct helper functions for the mistakes of this topic: relative velocity, impulse matrix K and
// impulse at one contact.
#pragma once

#include "formulas/collision.hpp"
#include "formulas/contact.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rigor {

using Bodies = std::vector<Body>;
using Contacts = std::vector<BodyContact>;

inline Vector3d velocity_of(const Bodies& bodies, const BodyContact& c)
{
    return relative_velocity(bodies[c.body1], bodies[c.body2], c.point);
}

inline Matrix3d impulse_matrix_of(const Bodies& bodies, const BodyContact& c)
{
    const Body &b1 = bodies[c.body1], &b2 = bodies[c.body2];
    return impulse_matrix(b1.inverse_mass, b1.inverse_inertia, b1.position, c.point) +
           impulse_matrix(b2.inverse_mass, b2.inverse_inertia, b2.position, c.point);
}

inline void apply(Bodies& bodies, const BodyContact& c, const Vector3d& j)
{
    bodies[c.body1] = apply_impulse(bodies[c.body1], c.point, j);
    bodies[c.body2] = apply_impulse(bodies[c.body2], c.point, -j);
}

inline std::vector<int> by_depth(const Contacts& contacts)
{
    std::vector<int> order(contacts.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return contacts[a].depth > contacts[b].depth; });
    return order;
}

inline double larger_eigenvalue(const Matrix3d& K, const Vector3d& n)
{
    const Matrix3d P = Matrix3d::Identity() - n * n.transpose();
    return Eigen::SelfAdjointEigenSolver<Matrix3d>(P * K * P).eigenvalues().maxCoeff();
}

} // namespace rigor
