// SPDX-License-Identifier: MIT
// Contact problems that are made by hand, for the tests of the contact stages.
#pragma once

#include "framework/rigid/worlds.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor::testing {

/// A contact problem with counters and threads of its own, with gravity, and with static body 0.
/// Its contacts form one island.
struct HandMade : ContactProblem {
    Island island;
    Counters counted;
    ThreadPool threads;

    explicit HandMade(int thread_count = 1) : threads(thread_count)
    {
        counters = &counted;
        pool = &threads;
        time_step = 0.01;
        settings.gravity = {0, -g, 0};
        bodies.emplace_back();
    }
    HandMade(const HandMade&) = delete;

    /// Adds a body and returns its index.
    int add(const Body& body)
    {
        bodies.push_back(body);
        const int index = static_cast<int>(bodies.size()) - 1;
        if (!body.is_static()) island.bodies.push_back(index);
        return index;
    }

    /// Adds a contact as a pair of its own. The reference is valid until the next one is added.
    ContactConstraint& touch(int body1, int body2, const Vector3d& point,
                             const Vector3d& normal = Vector3d::UnitY())
    {
        const int at = static_cast<int>(contacts.size());
        ContactConstraint& c = contacts.emplace_back(ContactConstraint{});
        c.body1 = body1;
        c.body2 = body2;
        c.point = point;
        c.normal = normal;
        c.radius = 0.5;
        set_impulse_matrix(c);
        island.pairs.push_back({at, at + 1});
        island.blocks = {{0, at + 1}};
        island.colors = {{0, 1}};
        return c;
    }
};

/// A body with the inertia of a ball of radius ½ m, which does not rotate.
inline Body ball_at(const Vector3d& X, double mass, const Vector3d& V = {0, 0, 0})
{
    Body ball;
    ball.inverse_mass = 1 / mass;
    ball.inverse_inertia = Matrix3d::Identity() / (0.1 * mass);
    ball.position = X;
    ball.velocity = V;
    return ball;
}

/// Momentum of the bodies that can move, or their angular momentum about the origin.
inline Vector3d momentum(std::span<const Body> bodies)
{
    Vector3d sum(0, 0, 0);
    for (const Body& b : bodies)
        if (!b.is_static()) sum += b.velocity / b.inverse_mass;
    return sum;
}
inline Vector3d angular_momentum(std::span<const Body> bodies)
{
    Vector3d sum(0, 0, 0);
    for (const Body& b : bodies)
        if (!b.is_static())
            sum += b.position.cross(b.velocity) / b.inverse_mass + b.angular_momentum;
    return sum;
}

/// Whether two bodies have the same bits in all that an impulse can change.
inline bool moves_alike(const Body& a, const Body& b)
{
    return a.velocity == b.velocity && a.angular_velocity == b.angular_velocity &&
           a.angular_momentum == b.angular_momentum;
}

} // namespace rigor::testing
