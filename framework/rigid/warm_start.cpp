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

namespace {

// Those of the step before between the two bodies.
std::span<const WarmContact> warm_of(const World& world, const SolvedContact& c)
{
    const auto is_before = [](const WarmContact& warm, const std::pair<int, int>& pair) {
        return bodies_of(warm) < pair;
    };
    const std::vector<WarmContact>& all = world.warm_contacts;
    const auto first = std::lower_bound(all.begin(), all.end(), bodies_of(c), is_before);
    auto last = first;
    while (last != all.end() && bodies_of(*last) == bodies_of(c))
        ++last;
    return {first, last};
}

// Where a contact of the step before is now.
struct Choice {
    Vector3d point;
    bool is_taken;
};

// Each contact of the pair takes the nearest that no other has taken. @return how many did
std::uint64_t start_warm(const World& world, double time_step, std::span<SolvedContact> contacts,
                         std::vector<Choice>& choices)
{
    const std::span<const WarmContact> before = warm_of(world, contacts.front());
    if (before.empty()) return 0;
    const RigidState& state = world.bodies[contacts.front().body1].state;
    const Matrix3d R = rotation_matrix(state.orientation);
    choices.clear();
    for (const WarmContact& warm : before)
        choices.push_back({R * warm.point + state.position, false});
    std::uint64_t count = 0;
    for (SolvedContact& c : contacts) {
        double nearest = near_fraction * c.radius * near_fraction * c.radius; // squared
        std::size_t found = before.size();
        for (std::size_t k = 0; k < before.size(); ++k) {
            if (choices[k].is_taken) continue;
            const double distance = (choices[k].point - c.point).squaredNorm();
            if (distance > nearest) continue;
            nearest = distance;
            found = k;
        }
        if (found == before.size()) continue;
        choices[found].is_taken = true;
        c.guess = turned_to(c, time_step * before[found].impulse);
        ++count;
    }
    return count;
}

} // namespace

void start_warm(const World& world, double time_step, std::span<const ContactPair> pairs,
                std::vector<SolvedContact>& contacts, Counters& counters, Team& team)
{
    constexpr std::size_t worth_sharing = 128; // pairs
    const int stretches = team.stretches_of(pairs.size(), worth_sharing);
    std::vector<std::uint64_t> counts(stretches, 0);
    team.share(stretches, [&](int k) {
        const auto [first, last] = Team::stretch(pairs.size(), stretches, k);
        std::vector<Choice> choices; // of one pair, its memory used again
        for (const ContactPair& pair : pairs.subspan(first, last - first)) {
            const auto of_pair = std::span(contacts).subspan(pair.first, pair.last - pair.first);
            counts[k] += start_warm(world, time_step, of_pair, choices);
        }
    });
    for (const std::uint64_t count : counts)
        counters.warm_starts += count;
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
