// SPDX-License-Identifier: MIT
// Adaptive substeps of single islands. "New overlap" is the increase of the overlap of two bodies
// in this step. For each pair of bodies, a bound of it is computed first, from the bodies' rotation
// and from the remaining approach speed; contacts are searched again only where the bound is too
// large. An island with too much new overlap is copied into a separate world, with the static
// bodies near it, and takes two steps of half the length. An island in which two balls meet takes
// one step up to the impact and one after it.
#include "rigid/step/adaptive_substeps.hpp"

#include "geometry/bounds/bounds.hpp"
#include "geometry/shapes/shape_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace rigor {

namespace {

// Largest island that may be refined [bodies]; larger ones cost too much. Chosen by trial.
constexpr std::size_t most_bodies = 32;
// Allowed increase of the overlap in a step, as a fraction of the thinner body's thickness. The
// first value applies where bodies rotate into each other, the second where only the solver left
// some approach speed. With smaller values more steps are repeated, with larger ones more
// penetration remains. Chosen by trial; tests/stress shows the depth.
constexpr double overlap_by_turn = 0.005, overlap_by_speed = 0.05;

// The smallest extent of a body's thinnest part, where planes do not count [m].
double thickness(const RigidBody& body)
{
    double least = std::numeric_limits<double>::infinity();
    for (const Part& part : body.parts) {
        if (is_plane(part)) continue;
        if (const Box* box = std::get_if<Box>(&part.shape)) {
            least = std::min(least, box->size.minCoeff());
            continue;
        }
        const Bounds bounds = bounds_of(part.shape, {});
        least = std::min(least, (bounds.high - bounds.low).minCoeff());
    }
    return least;
}

// Whether a body is a ball, which occupies the same space in every orientation.
bool is_ball(const RigidBody& body)
{
    return body.parts.size() == 1 && std::holds_alternative<Sphere>(body.parts[0].shape);
}

// The largest distance by which the rotation of a body in this step may move its points out of the
// tangent planes of its contacts [m].
double deviation_by_rotation(const World& world, const ContactProblem& problem, int i,
                             double radius)
{
    const RigidBody& body = world.bodies[i];
    if (body.is_still() || is_ball(body)) return 0;
    const double angle = problem.time_step * problem.bodies[i].angular_velocity.norm();
    return angle * angle / 2 * radius;
}

// The largest depth of the contacts, at least 0 [m].
double deepest(const std::vector<Contact>& contacts)
{
    double depth = 0;
    for (const Contact& c : contacts)
        depth = std::max(depth, -c.gap);
    return depth;
}

// A separate world with the bodies of an island and the static bodies near them.
struct IslandWorld {
    World world;
    std::vector<int> bodies; // for each body of `world`, its index in the whole world; ascending
};

// Copies an island and the static bodies that contacts in `near` connect with it.
IslandWorld part_of(const World& world, const Island& island, const std::vector<Contact>& near)
{
    IslandWorld part;
    part.bodies = island.bodies;
    for (const Contact& c : near)
        for (const auto& [fixed, other] :
             {std::pair(c.body1, c.body2), std::pair(c.body2, c.body1)})
            if (world.bodies[fixed].is_static &&
                std::binary_search(island.bodies.begin(), island.bodies.end(), other))
                part.bodies.push_back(fixed);
    std::sort(part.bodies.begin(), part.bodies.end());
    part.bodies.erase(std::unique(part.bodies.begin(), part.bodies.end()), part.bodies.end());

    std::map<int, int> index;
    for (int i : part.bodies) {
        index[i] = static_cast<int>(part.world.bodies.size());
        part.world.bodies.push_back(world.bodies[i]);
    }
    part.world.pair_laws = laws_among(world.pair_laws, part.bodies);
    part.world.settings = world.settings;
    part.world.settings.optimisations.sleep = false;
    part.world.time = world.time;
    part.world.counters = world.counters;
    for (WarmContact warm : world.memory.warm_contacts) {
        const auto body1 = index.find(warm.body1), body2 = index.find(warm.body2);
        if (body1 == index.end() || body2 == index.end()) continue;
        warm.body1 = body1->second;
        warm.body2 = body2->second;
        part.world.memory.warm_contacts.push_back(warm);
    }
    return part;
}

// Checks whether the overlap of the two bodies of a pair has grown in the step by more than is
// allowed.
class OverlapCheck {
public:
    OverlapCheck(const World& world, const ContactProblem& problem,
                 const ContactCandidates& candidates, const std::vector<RigidState>& states)
        : world_(world), problem_(problem), candidates_(candidates), states_(states)
    {
    }

    bool operator()(const ContactPair& pair)
    {
        const ContactConstraint& first = problem_.contacts[pair.first];
        const int i = first.body1, j = first.body2;
        const double thinner = std::min(thickness(world_.bodies[i]), thickness(world_.bodies[j]));
        double before = 0, predicted = 0; // largest depths [m]
        for (int k = pair.first; k < pair.last; ++k) {
            const ContactConstraint& c = problem_.contacts[k];
            const double v_n = problem_.velocity_at(c, c.point).dot(c.normal);
            before = std::max(before, -c.gap);
            predicted = std::max(predicted, -problem_.predicted_gap(c, v_n));
        }
        const double turned = deviation_by_rotation(world_, problem_, i, candidates_.radii[i]) +
                              deviation_by_rotation(world_, problem_, j, candidates_.radii[j]);
        const bool may_turn_in = turned > overlap_by_turn * thinner;
        if (!may_turn_in && !(predicted > before + overlap_by_speed * thinner)) return false;
        const double allowed = may_turn_in ? overlap_by_turn : overlap_by_speed;
        return depth_after(i, j) > before + allowed * thinner;
    }

private:
    double depth_after(int i, int j)
    {
        poses_.resize(states_.size());
        for (int body : {i, j})
            poses_[body] = pose_of(states_[body]);
        std::vector<Contact> after;
        find_contacts(world_, poses_, i, j, 0, after);
        return deepest(after);
    }

    const World& world_;
    const ContactProblem& problem_;
    const ContactCandidates& candidates_;
    const std::vector<RigidState>& states_;
    std::vector<Pose> poses_; // poses after the step, set only for the pair that is checked
};

// The time from the start of the step to the first bounce of two moving balls; 0 if there is none.
// Bounces that `bounce_at_impacts` has already moved to their time of impact do not count. The
// exact time matters, as in billiards: balls part along the line of centers that they have at the
// impact. On straight paths the distance of two balls is a convex function of time, so the
// predicted time is never late. The later part of the step predicts the time again and may be
// divided again. This iteration converges quadratically.
double first_impact(const World& world, const ContactProblem& problem, const Island& island)
{
    constexpr double just_before = 1 - 1e-9; // so that the bounce happens in the later part
    double first = problem.time_step;
    for (const ContactPair& pair : island.pairs) {
        const ContactConstraint& c = problem.contacts[pair.first];
        const RigidBody &body1 = world.bodies[c.body1], &body2 = world.bodies[c.body2];
        const bool are_balls = is_ball(body1) && is_ball(body2);
        const bool bounces =
            c.restitution > 0 && !c.collision_impulse.isZero(0) && c.gap > touching_gap * c.radius;
        if (!are_balls || !bounces || body1.is_static || body2.is_static) continue;
        const double approach = -(body1.state.velocity - body2.state.velocity).dot(c.normal);
        if (approach * first > c.gap) first = just_before * c.gap / approach;
    }
    return first < problem.time_step ? first : 0;
}

// The number of pairs of an island that bounced in the step before it is repeated in parts. The
// counters already include these bounces.
std::uint64_t bounced_pairs(const ContactProblem& problem, const Island& island)
{
    return std::count_if(island.pairs.begin(), island.pairs.end(), [&](const ContactPair& pair) {
        return std::any_of(
            problem.contacts.begin() + pair.first, problem.contacts.begin() + pair.last,
            [](const ContactConstraint& c) { return !c.collision_impulse.isZero(0); });
    });
}

void take_substeps(IslandWorld& part, const Step& step, std::array<double, 2> times,
                   Refinement& refined)
{
    for (const double time : times)
        for (ContactRecord record : step(part.world, time)) {
            record.body1 = part.bodies[record.body1];
            record.body2 = part.bodies[record.body2];
            refined.records.push_back(record);
        }
    for (WarmContact contact : part.world.memory.warm_contacts) {
        contact.body1 = part.bodies[contact.body1];
        contact.body2 = part.bodies[contact.body2];
        refined.warm_contacts.push_back(contact);
    }
}

} // namespace

Refinement refine_by_substeps(World& world, ContactProblem& problem,
                              const std::vector<bool>& pulled, const ContactCandidates& candidates,
                              std::vector<RigidState>& states, const Step& step)
{
    Refinement refined;
    OverlapCheck overlaps_anew(world, problem, candidates, states);
    for (const Island& island : problem.islands) {
        if (island.bodies.size() > most_bodies) continue;
        if (std::any_of(island.bodies.begin(), island.bodies.end(),
                        [&](int i) { return pulled[i]; }))
            continue;
        const double h = problem.time_step, impact = first_impact(world, problem, island);
        const bool is_halved = impact == 0 && std::any_of(island.pairs.begin(), island.pairs.end(),
                                                          std::ref(overlaps_anew));
        if (impact == 0 && !is_halved) continue;
        IslandWorld part = part_of(world, island, candidates.contacts);
        take_substeps(part, step,
                      is_halved ? std::array{h / 2, h / 2} : std::array{impact, h - impact},
                      refined);
        for (std::size_t k = 0; k < part.bodies.size(); ++k)
            if (!part.world.bodies[k].is_static)
                states[part.bodies[k]] = part.world.bodies[k].state;
        // The parts do not count as steps of this world. If the step was divided at an impact, both
        // the first attempt and the parts counted its bounces, so one bounce is subtracted for each
        // pair that bounced. If the step was halved, the counters include the work of the first
        // attempt and of the halves.
        const std::uint64_t steps = world.counters.steps;
        world.counters = part.world.counters;
        if (!is_halved) world.counters.collision_impulses -= bounced_pairs(problem, island);
        world.counters.steps = steps;
        for (const ContactPair& pair : island.pairs)
            for (int i = pair.first; i < pair.last; ++i) {
                problem.contacts[i].collision_impulse.setZero();
                problem.contacts[i].contact_impulse.setZero();
            }
    }
    return refined;
}

} // namespace rigor
