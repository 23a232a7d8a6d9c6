// SPDX-License-Identifier: MIT
#include "rigid/neighbourhood.hpp"

#include "geometry/shapes/shape_bounds.hpp"
#include "rigid/broad_phase.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

double body_radius(const RigidBody& body)
{
    double radius = 0;
    for (const Part& part : body.parts)
        radius = std::max(radius, bounding_radius(part));
    return radius;
}

Bounds body_bounds(const RigidBody& body, const Pose& pose)
{
    Bounds bounds;
    for (const Part& part : body.parts)
        bounds.include(bounds_of(part.shape, part_pose(pose, part)));
    return bounds;
}

// How far the points of a body move at most in the step, along its path or with its last velocity [m].
// An angle α is |Δq| ≈ α/2; a quarter more for the chord and for an axis that tumbles.
double travel(const RigidState& from, const RigidState& to, double radius, double time_step)
{
    const Quaternion &p = from.orientation, &q = to.orientation;
    const double same = (p.s - q.s) * (p.s - q.s) + (p.v - q.v).squaredNorm();
    const double opposite = (p.s + q.s) * (p.s + q.s) + (p.v + q.v).squaredNorm();
    const double moved = (to.position - from.position).norm();
    return std::max(moved, time_step * to.velocity.norm()) +
           2.5 * std::sqrt(std::min(same, opposite)) * radius;
}

constexpr int most_hands = 8; // that a blow is passed on through in a step

// What of a body matters when it is hit.
struct Target {
    double mass = 0, restitution = 0;
    bool is_still = false;
};

// Of the speed that body j has, what body i gets when j hits it: (1 + ε) m_j / (m_i + m_j), but never more.
double passed_on(const Target& i, const Target& j)
{
    const double restitution = std::min(i.restitution, j.restitution);
    return std::min(1.0, (1 + restitution) * j.mass / (i.mass + j.mass));
}

Target target_of(const RigidBody& body)
{
    return {body.mass, body.material.restitution, body.is_still()};
}

// Everything that looking closely at a pair needs to know.
struct Surroundings {
    const World& world;
    std::vector<Bounds> bounds;  // over the step
    std::vector<double> travels; // [m]
    Neighbourhood near;          // poses, radii and then margins are there, contacts not yet
    double time_step = 0;        // [s]
};

// Whether two bodies come near each other, if they look as far as this beyond their paths.
bool come_near(const Surroundings& at, const BodyPair& pair, double reach)
{
    Bounds bounds = at.bounds[pair.body1];
    bounds.grow(reach);
    return bounds.overlaps(at.bounds[pair.body2]);
}

// How far a body looks beyond its path if a blow may move it as far as this; more than half its radius is
// never needed.
double margin(const Surroundings& at, int i, double farthest)
{
    return std::min(farthest, at.near.radii[i] / 2);
}

// As far as this a blow may move a body.
struct Blow {
    int body = 0;
    double travel = 0; // [m]
};

// Blows are passed on from hand to hand; this is the one that comes next.
struct Hand {
    const std::vector<Target>& bodies;
    std::vector<double> farthest; // so far, of each body [m]
    std::vector<char> is_news;    // whether the hand before changed that

    // What it adds.
    std::vector<Blow> pass_on(const Surroundings& at, std::span<const BodyPair> pairs) const
    {
        std::vector<Blow> blows;
        for (const BodyPair& pair : pairs) {
            auto [hit, hits] = pair;
            if (!is_news[hit] && !is_news[hits]) continue;
            if (farthest[hit] > farthest[hits]) std::swap(hit, hits);
            if (farthest[hits] <= farthest[hit]) continue; // it gets no more than that
            if (bodies[hit].is_still || bodies[hits].is_still) continue;
            const double passed = passed_on(bodies[hit], bodies[hits]) * farthest[hits];
            if (passed <= farthest[hit]) continue;
            const double reach = margin(at, hit, farthest[hit]) + margin(at, hits, farthest[hits]);
            if (come_near(at, pair, reach)) blows.push_back({hit, passed});
        }
        return blows;
    }
};

// A body at rest may be hit in this step, and then move with what the blow leaves it of the speed of whatever
// hits it, hand to hand.
std::vector<double> margins_of(const Surroundings& at, const std::vector<BodyPair>& pairs,
                               Team& team)
{
    std::vector<double> margins(at.travels.size());
    for (int i = 0; i < static_cast<int>(margins.size()); ++i)
        margins[i] = margin(at, i, at.travels[i]);
    const std::vector<RigidBody>& all = at.world.bodies;
    if (std::all_of(pairs.begin(), pairs.end(), [&](const BodyPair& pair) {
            return all[pair.body1].is_still() || all[pair.body2].is_still();
        }))
        return margins; // nobody is hit

    std::vector<Target> bodies;
    bodies.reserve(all.size());
    for (const RigidBody& body : all)
        bodies.push_back(target_of(body));
    constexpr std::size_t worth_sharing = 1024; // pairs
    Hand hand{bodies, at.travels, std::vector<char>(bodies.size(), true)};
    bool any = true;
    for (int hands = 0; hands < most_hands && any; ++hands) {
        const std::vector<std::vector<Blow>> blows =
            team.collect(pairs.size(), worth_sharing, [&](std::size_t first, std::size_t last) {
                return hand.pass_on(at, std::span(pairs).subspan(first, last - first));
            });
        any = false;
        hand.is_news.assign(bodies.size(), false);
        for (const std::vector<Blow>& of_stretch : blows)
            for (const auto& [body, travel] : of_stretch) {
                if (travel <= hand.farthest[body]) continue;
                hand.farthest[body] = travel;
                hand.is_news[body] = any = true;
            }
    }
    for (int i = 0; i < static_cast<int>(margins.size()); ++i)
        margins[i] = margin(at, i, hand.farthest[i]);
    return margins;
}

// With what a blow may add to the motion of a body: none is faster than the fastest nor heavier than the
// heaviest.
std::vector<Bounds> wide_bounds(const Surroundings& at, Team& team)
{
    const double fastest = *std::max_element(at.travels.begin(), at.travels.end());
    Target heaviest{0, 1};
    for (const RigidBody& body : at.world.bodies)
        heaviest.mass = std::max(heaviest.mass, body.mass);
    std::vector<Bounds> wide = at.bounds;
    constexpr std::size_t worth_sharing = 128; // bodies
    team.share_stretches(wide.size(), worth_sharing, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Target body = target_of(at.world.bodies[i]);
            const double hit = body.is_still ? 0 : passed_on(body, heaviest) * fastest;
            wide[i].grow(margin(at, static_cast<int>(i), std::max(at.travels[i], hit)));
        }
    });
    return wide;
}

// What bodies get to move in for some steps: a body that slows down or is held does not use it up soon.
std::vector<double> spare_room(const Surroundings& at)
{
    std::vector<double> spare(at.travels.size());
    for (std::size_t i = 0; i < spare.size(); ++i)
        spare[i] = 0.1 * at.near.radii[i] + 3 * at.travels[i];
    return spare;
}

// What looking closely at some pairs found.
struct Found {
    std::vector<Contact> contacts;
    std::vector<int> disturbed;
    bool any_may_meet = false;
    Counters counters;
};

Found look_closely(const Surroundings& at, std::span<const BodyPair> pairs)
{
    Found found;
    for (const auto& [i, j] : pairs) {
        const double margin = at.near.margins[i] + at.near.margins[j];
        if (!come_near(at, {i, j}, margin)) continue;
        ++found.counters.pairs_tested;
        const double path = at.travels[i] + at.travels[j];
        const std::size_t first = found.contacts.size();
        find_contacts(at.world, at.near.poses, i, j, path + margin, found.contacts, found.counters,
                      at.time_step);
        bool may_meet = false;
        for (std::size_t k = first; k < found.contacts.size(); ++k)
            may_meet |= found.contacts[k].gap < path;
        found.any_may_meet |= may_meet;
        for (int sleeping : {i, j}) {
            if (!at.world.bodies[sleeping].rest.is_asleep()) continue;
            if (may_meet) found.disturbed.push_back(sleeping);
            found.contacts.resize(first);
        }
    }
    return found;
}

// Where the bodies are and where they fly to.
Surroundings surroundings(const World& world, std::span<const RigidState> flown, double time_step,
                          Team& team)
{
    constexpr std::size_t worth_sharing = 32; // bodies
    const std::size_t n = flown.size();
    Surroundings at{world, std::vector<Bounds>(n), std::vector<double>(n), {}};
    at.near.poses.resize(n);
    at.near.radii.resize(n);
    team.share_stretches(n, worth_sharing, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const RigidBody& body = world.bodies[i];
            at.near.poses[i] = pose_of(body.state);
            at.bounds[i] = body_bounds(body, at.near.poses[i]);
            if (!body.is_static) at.near.radii[i] = body_radius(body);
            if (body.is_still()) continue;
            at.bounds[i].include(body_bounds(body, pose_of(flown[i])));
            at.travels[i] = travel(body.state, flown[i], at.near.radii[i], time_step);
        }
    });
    return at;
}

} // namespace

Neighbourhood neighbourhood(const World& world, std::span<const RigidState> flown, double time_step,
                            PairMemory& memory, Counters& counters, Team& team)
{
    Surroundings at = surroundings(world, flown, time_step, team);
    at.time_step = time_step;
    const std::vector<BodyPair> pairs = near_pairs(world, at.near.poses, wide_bounds(at, team),
                                                   spare_room(at), memory, counters, team);
    if (pairs.empty()) return std::move(at.near);
    at.near.margins = margins_of(at, pairs, team);

    Neighbourhood& near = at.near;
    constexpr std::size_t worth_sharing = 128; // pairs
    std::vector<Found> all =
        team.collect(pairs.size(), worth_sharing, [&](std::size_t first, std::size_t last) {
            return look_closely(at, std::span(pairs).subspan(first, last - first));
        });
    const std::size_t contacts = std::accumulate(
        all.begin(), all.end(), std::size_t{0},
        [](std::size_t sum, const Found& found) { return sum + found.contacts.size(); });
    near.contacts = std::move(all[0].contacts); // which is empty then
    near.contacts.reserve(contacts);
    bool any_may_meet = false;
    for (const Found& found : all) {
        near.contacts.insert(near.contacts.end(), found.contacts.begin(), found.contacts.end());
        near.disturbed.insert(near.disturbed.end(), found.disturbed.begin(), found.disturbed.end());
        any_may_meet |= found.any_may_meet;
        counters.pairs_tested += found.counters.pairs_tested;
        counters.level_sets_built += found.counters.level_sets_built;
        counters.level_set_samples += found.counters.level_set_samples;
    }
    if (!any_may_meet) near.contacts.clear(); // then no formula of collisions is needed
    return std::move(at.near);
}

} // namespace rigor
