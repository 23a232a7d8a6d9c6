// SPDX-License-Identifier: MIT
// Correct simultaneous resolution of contacts (A5.5). A mistake replaces the one step that it gets
// wrong.
#pragma once

#include "mistakes/contact/one_contact.hpp"

#include <functional>

namespace rigor {

/// A contact at the time when a sweep visits it.
struct VisitedContact {
    const BodyContact& contact;
    Matrix3d K;
    Vector3d v, j; // relative velocity [m/s], total impulse so far [N s]

    Vector3d n() const { return contact.normal; }
    double push_stiffness() const { return n().dot(K * n()); }
};

struct ContactsAtOnce {
    std::function<std::vector<int>(const Contacts& contacts)> order = [](const Contacts& contacts) {
        std::vector<int> indices(contacts.size());
        std::iota(indices.begin(), indices.end(), 0);
        return indices;
    };
    /// Applies the impulse that a contact starts from to its bodies. @return this impulse
    std::function<Vector3d(Bodies& bodies, const BodyContact& c)> start = [](Bodies& bodies,
                                                                             const BodyContact& c) {
        apply(bodies, c, c.impulse);
        return c.impulse;
    };
    /// Contacts between two static bodies also get an initial impulse, and are also resolved.
    bool starts_between_statics = false, resolves_statics = false;
    /// A contact sees the velocities that the contacts before it changed in the same sweep.
    bool sees_those_before = true;
    /// The normal part of the new impulse, at least 0.
    std::function<double(const VisitedContact& c)> push = [](const VisitedContact& c) {
        const double missing = c.v.dot(c.n()) - c.contact.separation_speed;
        return std::max(0.0, c.j.dot(c.n()) - missing / c.push_stiffness());
    };
    /// The larger eigenvalue of K in the tangent plane [1/kg].
    std::function<double(const VisitedContact& c)> lambda = [](const VisitedContact& c) {
        return larger_eigenvalue(c.K, c.n());
    };
    /// The change of the tangential impulse, before the friction cone limits it.
    std::function<Vector3d(const Vector3d& v_T, double lambda)> friction =
        [](const Vector3d& v_T, double l) -> Vector3d { return -v_T / l; };
    /// The tangential impulse, shortened to the friction cone.
    std::function<Vector3d(const Vector3d& j_T, double j_n, const VisitedContact& c)> shorten =
        [](const Vector3d& j_T, double j_n, const VisitedContact& c) -> Vector3d {
        const double most = c.contact.friction * j_n;
        return j_T.norm() > most ? Vector3d(j_T * (most / j_T.norm())) : j_T;
    };
    /// The new impulse; if set, it replaces the steps above from `push` on.
    std::function<Vector3d(const VisitedContact& c)> impulse;
    /// A contact keeps only the last change of its impulse; each sweep applies the whole impulse.
    bool reports_the_change = false, applies_the_whole = false;

    ContactResult operator()(const Bodies& bodies, const Contacts& contacts, int sweeps) const
    {
        ContactResult result{bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
        for (std::size_t i = 0; i < contacts.size(); ++i)
            if (starts_between_statics || !impulse_matrix_of(bodies, contacts[i]).isZero(0))
                result.impulses[i] = start(result.bodies, contacts[i]);
        for (int k = 0; k < sweeps; ++k)
            sweep(result, contacts);
        return result;
    }

private:
    Vector3d new_impulse(const VisitedContact& c) const
    {
        if (impulse) return impulse(c);
        const Vector3d n = c.n();
        const double j_n = push(c);
        const Vector3d v_T = c.v - c.v.dot(n) * n;
        const Vector3d j_T = c.j - c.j.dot(n) * n + friction(v_T, lambda(c));
        return j_n * n + shorten(j_T, j_n, c);
    }

    void sweep(ContactResult& result, const Contacts& contacts) const
    {
        const Bodies before = result.bodies;
        for (int i : order(contacts)) {
            const BodyContact& c = contacts[i];
            const Matrix3d K = impulse_matrix_of(before, c);
            if (!resolves_statics && K.isZero(0)) continue;
            const Vector3d v = velocity_of(sees_those_before ? result.bodies : before, c);
            const Vector3d j = result.impulses[i], j_new = new_impulse({c, K, v, j});
            const Vector3d change = j_new - j;
            result.impulses[i] = reports_the_change ? change : j_new;
            apply(result.bodies, c, applies_the_whole ? j_new : change);
        }
    }
};

} // namespace rigor
