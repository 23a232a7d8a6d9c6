// SPDX-License-Identifier: MIT
// Correct resolution of contacts one at a time (A5.2). A mistake replaces the one step that it gets
// wrong.
#pragma once

#include "mistakes/contact/one_contact.hpp"

#include <functional>

namespace rigor {

struct ContactsOneAtATime {
    std::function<std::vector<int>(const Contacts& contacts)> order = by_depth;
    /// The impulse that a contact has before the first iteration.
    std::function<Vector3d(const BodyContact& c)> start = [](const BodyContact&) -> Vector3d {
        return Vector3d::Zero();
    };
    /// The restitution of iteration k of n.
    std::function<double(int k, int n)> restitution = contact_restitution;
    /// The velocity that an impulse has to stop, u [m/s].
    std::function<Vector3d(const Vector3d& v, const BodyContact& c)> velocity_to_stop =
        [](const Vector3d& v, const BodyContact& c) -> Vector3d {
        return v - c.separation_speed * c.normal;
    };
    std::function<Vector3d(const Matrix3d& K, const Vector3d& u, const BodyContact& c,
                           double epsilon)>
        impulse = [](const Matrix3d& K, const Vector3d& u, const BodyContact& c, double epsilon) {
            return collision_impulse(K, u, c.normal, epsilon, c.friction);
        };
    std::function<void(Bodies& bodies, const BodyContact& c, const Vector3d& j)> push = apply;
    /// The impulse to report for a contact, after another impulse j.
    std::function<Vector3d(const Vector3d& sum, const Vector3d& j)> report =
        [](const Vector3d& sum, const Vector3d& j) -> Vector3d { return sum + j; };
    /// A contact sees the velocities that the contacts before it changed in the same iteration.
    bool sees_those_before = true;
    /// Each iteration ends after the first contact that approaches.
    bool stops_after_one = false;
    /// An iteration in which no contact gets an impulse is the last one.
    bool stops_if_quiet = false;

    ContactResult operator()(const Bodies& bodies, const Contacts& contacts, int n) const
    {
        ContactResult result{bodies, {}};
        for (const BodyContact& c : contacts)
            result.impulses.push_back(start(c));
        const std::vector<int> indices = order(contacts);
        for (int k = 0; k < n; ++k) {
            const double epsilon = restitution(k, n);
            const Bodies before = result.bodies;
            bool is_quiet = true;
            for (int i : indices) {
                const BodyContact& c = contacts[i];
                const Vector3d v = velocity_of(sees_those_before ? result.bodies : before, c);
                const Vector3d u = velocity_to_stop(v, c);
                if (u.dot(c.normal) >= 0) continue;
                const Vector3d j = impulse(impulse_matrix_of(result.bodies, c), u, c, epsilon);
                push(result.bodies, c, j);
                result.impulses[i] = report(result.impulses[i], j);
                is_quiet &= j.isZero(0);
                if (stops_after_one) break;
            }
            if (stops_if_quiet && is_quiet) break;
        }
        return result;
    }
};

} // namespace rigor
