// SPDX-License-Identifier: MIT
#include "rigid/warm_start.hpp"

#include "geometry/pose.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

namespace {

constexpr double near_fraction = 0.1; // of the radius

template <class C> std::pair<int, int> bodies_of(const C& contact)
{
    return {contact.body1, contact.body2};
}

// As a push along n and a friction within the cone.
Vector3d turned_to(const SolvedContact& c, const Vector3d& impulse)
{
    const Vector3d& n = c.normal;
    const double j_n = impulse.dot(n);
    if (j_n <= 0) return Vector3d::Zero();
    Vector3d j_T = impulse - j_n * n;
    const double length = j_T.norm();
    if (length > c.friction * j_n) j_T *= c.friction * j_n / length;
    return j_n * n + j_T;
}

} // namespace

void start_warm(const World& world, double time_step, std::vector<SolvedContact>& contacts,
                Counters& counters)
{
    std::vector<bool> is_used(world.warm_contacts.size(), false);
    auto first = world.warm_contacts.begin();
    auto last = first;
    std::pair<int, int> bodies{-1, -1};
    RigidState state; // of body 1
    Matrix3d R = Matrix3d::Identity();
    for (SolvedContact& c : contacts) {
        if (bodies_of(c) != bodies) {
            bodies = bodies_of(c);
            const auto is_before = [](const WarmContact& warm, const std::pair<int, int>& pair) {
                return bodies_of(warm) < pair;
            };
            first = std::lower_bound(last, world.warm_contacts.end(), bodies, is_before);
            last = first;
            while (last != world.warm_contacts.end() && bodies_of(*last) == bodies)
                ++last;
            if (first == last) continue;
            state = world.bodies[c.body1].state;
            R = rotation_matrix(state.orientation);
        }
        double nearest = near_fraction * c.radius * near_fraction * c.radius; // squared
        auto found = last;
        for (auto warm = first; warm != last; ++warm) {
            const double distance = (R * warm->point + state.position - c.point).squaredNorm();
            if (is_used[warm - world.warm_contacts.begin()] || distance > nearest) continue;
            nearest = distance;
            found = warm;
        }
        if (found == last) continue;
        is_used[found - world.warm_contacts.begin()] = true;
        c.guess = turned_to(c, time_step * found->impulse);
        ++counters.warm_starts;
    }
}

std::vector<WarmContact> warm_contacts(const World& world,
                                       const std::vector<SolvedContact>& contacts, double time_step)
{
    std::vector<WarmContact> warm;
    int body1 = -1;
    Matrix3d R = Matrix3d::Identity();
    for (const SolvedContact& c : contacts) {
        if (c.holding.isZero(0)) continue;
        const RigidState& state = world.bodies[c.body1].state;
        if (c.body1 != body1) R = rotation_matrix(state.orientation);
        body1 = c.body1;
        warm.push_back(
            {c.body1, c.body2, R.transpose() * (c.point - state.position), c.holding / time_step});
    }
    return warm;
}

} // namespace rigor
