// SPDX-License-Identifier: MIT
// Finds the contact candidates of a step: all pairs of points that may touch before it ends. The
// bounds of each body are swept over its free flight, and the broad phase finds the pairs whose
// bounds overlap. The margin of a body is how far the body may move in this step, but at most half
// its radius; impulses that pass from body to body make the margin larger. The narrow phase then
// finds the contacts whose gap is below the sum of the relative path and both margins. All motion
// is measured relative to other bodies and never to the origin of the world, so a scene that moves
// at a constant velocity has the same contacts as at rest. The search also lists sleeping bodies
// that another body may touch, since they have to wake before the step goes on.
#include "rigid/detection/contact_candidates.hpp"

#include "geometry/shapes/shape_bounds.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/bodies/orientation.hpp"
#include "rigid/detection/broad_phase.hpp"
#include "rigid/detection/travel.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <utility>

namespace rigor {

bool never_collide(const World& world, int i, int j)
{
    if (world.bodies[i].is_static && world.bodies[j].is_static) return true; // nothing pushes them
    const int group = world.bodies[i].group;
    if (group != 0 && group == world.bodies[j].group) return true;
    const PairLaw* law = law_of(world.pair_laws, i, j);
    return law && !law->collides;
}

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

// A body in the propagation of impulses.
struct ImpulseBody {
    double mass = 0, restitution = 0;
    bool is_still = false;
};

// The data of a body for the propagation of impulses. If the world has pair laws, one of them may
// give contacts of this body a restitution up to 1, so 1 is used.
ImpulseBody impulse_body(const World& world, const RigidBody& body)
{
    const double restitution = world.pair_laws.empty() ? body.material.restitution : 1;
    constexpr double driven_mass = 1e300; // [kg]; very large, since nothing stops a driven body
    return {body.changes_place() ? driven_mass : body.mass, restitution, body.is_still()};
}

// The share of body j's speed that body i gets when j hits it: (1 + ε) m_j / (m_i + m_j), but at
// most 1.
double speed_transfer(const ImpulseBody& i, const ImpulseBody& j)
{
    const double restitution = std::min(i.restitution, j.restitution);
    return std::min(1.0, (1 + restitution) * j.mass / (i.mass + j.mass));
}

// Whether a body turns in the step by so large a part of the angle between two facets that it rolls
// like a round body. In the orientation at the start of the step, the vertex on which such a body
// will stand at the end lies ahead of the body, and a contact at this vertex would brake the body.
// A body that turns less touches the ground with one vertex after the other. Its contacts are
// correct only in its orientation at the start of the step.
bool turns_over_facets(const RigidBody& body, const RigidState& flown)
{
    // The smallest rotation in a step with which a body counts as turning over its facets, as a
    // fraction of the angle between two of them. With a larger value, wheels that need many steps
    // for a facet are braked too much. With a smaller value, wheels keep speed that the impacts of
    // their corners should take. The value was chosen by trial; tests/classics has rolling wheels.
    constexpr double least_turn = 1. / 16;
    double angle = 0; // largest angle between two facets [rad]
    for (const Part& part : body.parts)
        if (const Mesh* mesh = std::get_if<Mesh>(&part.shape))
            angle = std::max(angle, mesh->solid->facet_angle());
    if (angle == 0 || body.is_still()) return false;
    return 2 * orientation_distance(body.state.orientation, flown.orientation) > least_turn * angle;
}

// Data for the search for contacts.
struct ContactSearch {
    const World& world;
    std::vector<Travel> motions; // one for each body
    std::vector<Bounds> bounds;  // one for each body, swept over the step, see `frame_of_bounds`
    // For each body, its longest path relative to one of the motions of `frames_of` [m].
    std::vector<double> travels;
    ContactCandidates candidates;  // filled in this order: poses and radii, margins, contacts
    std::vector<Pose> poses_ahead; // poses for the narrow phase; empty: it uses `candidates.poses`
    double time_step = 0;          // [s]
};

// Whether the swept bounds of two bodies come closer than `reach`.
bool come_near(const ContactSearch& search, const BodyPair& pair, double reach)
{
    Bounds bounds = search.bounds[pair.body1];
    bounds.grow(reach);
    return bounds.overlaps(search.bounds[pair.body2]);
}

// The margin of body i if it may move by `farthest` [m]: this distance, but at most half the
// radius of the body. The limit was chosen by trial; without it, one fast body would give all
// others margins as large as its own path. If a collision moves a body farther than its margin,
// step/missed_contacts searches beyond the margin.
double margin(const ContactSearch& search, int i, double farthest)
{
    constexpr double most = 0.5; // largest margin, divided by the radius of the body
    return std::min(farthest, most * search.candidates.radii[i]);
}

// The distance by which impulses may move a body in this step.
struct PossibleTravel {
    int body = 0;
    double distance = 0; // [m]
};

// Impulses pass from body to body within a step, as along a row of balls. A round visits each body
// whose distance grew in the previous round, and computes how far this body may push its neighbors.
struct ImpulsePropagation {
    const std::vector<ImpulseBody>& bodies;
    std::vector<double> farthest;  // how far each body may move, as found so far [m]
    std::vector<char> has_changed; // whether each body's distance grew in the last round

    std::vector<PossibleTravel> round(const ContactSearch& search,
                                      std::span<const BodyPair> pairs) const
    {
        std::vector<PossibleTravel> farther;
        for (const BodyPair& pair : pairs) {
            auto [slower, faster] = pair;
            if (!has_changed[slower] && !has_changed[faster]) continue;
            if (farthest[slower] > farthest[faster]) std::swap(slower, faster);
            if (farthest[faster] <= farthest[slower]) continue; // equal: no push between them
            if (bodies[slower].is_still || bodies[faster].is_still) continue;
            const double passed = speed_transfer(bodies[slower], bodies[faster]) * farthest[faster];
            if (passed <= farthest[slower]) continue;
            const double reach =
                margin(search, slower, farthest[slower]) + margin(search, faster, farthest[faster]);
            if (come_near(search, pair, reach)) farther.push_back({slower, passed});
        }
        return farther;
    }
};

// The margins of all bodies. Each is how far the body may move in this step, by itself or because
// an impulse passes on a share of another body's speed.
std::vector<double> margins_of(const ContactSearch& search, const std::vector<BodyPair>& pairs,
                               ThreadPool& pool)
{
    std::vector<double> margins(search.travels.size());
    for (int i = 0; i < static_cast<int>(margins.size()); ++i)
        margins[i] = margin(search, i, search.travels[i]);
    const std::vector<RigidBody>& all = search.world.bodies;
    if (std::all_of(pairs.begin(), pairs.end(), [&](const BodyPair& pair) {
            return all[pair.body1].is_still() || all[pair.body2].is_still();
        }))
        return margins; // no two moving bodies are near each other

    std::vector<ImpulseBody> bodies;
    bodies.reserve(all.size());
    for (const RigidBody& body : all)
        bodies.push_back(impulse_body(search.world, body));
    // The largest number of bodies in a row through which an impulse passes in a step. With more
    // rounds, bodies farther along a row would get larger margins, but the rounds would take more
    // time. The number was chosen by trial.
    constexpr int most_rounds = 8;
    constexpr std::size_t grain_size = 1024; // least number of pairs in one parallel task
    ImpulsePropagation propagation{bodies, search.travels, std::vector<char>(bodies.size(), true)};
    bool any = true;
    for (int round = 0; round < most_rounds && any; ++round) {
        const std::vector<std::vector<PossibleTravel>> found =
            pool.collect_ranges(pairs.size(), grain_size, [&](std::size_t first, std::size_t last) {
                return propagation.round(search, std::span(pairs).subspan(first, last - first));
            });
        any = false;
        propagation.has_changed.assign(bodies.size(), false);
        for (const std::vector<PossibleTravel>& of_range : found)
            for (const auto& [body, distance] : of_range) {
                if (distance <= propagation.farthest[body]) continue;
                propagation.farthest[body] = distance;
                propagation.has_changed[body] = any = true;
            }
    }
    for (int i = 0; i < static_cast<int>(margins.size()); ++i)
        margins[i] = margin(search, i, propagation.farthest[i]);
    return margins;
}

// The swept bounds, enlarged by the motion that impulses may add. The assumption is that each body
// is hit by a body with the largest travel and the largest mass in the world. So the enlargement is
// at least as large as any margin that the propagation of impulses could give the body.
std::vector<Bounds> bounds_with_impulses(const ContactSearch& search, ThreadPool& pool)
{
    const double fastest = *std::max_element(search.travels.begin(), search.travels.end());
    ImpulseBody heaviest{0, 1};
    for (const RigidBody& body : search.world.bodies)
        heaviest.mass = std::max(heaviest.mass, impulse_body(search.world, body).mass);
    std::vector<Bounds> wide = search.bounds;
    constexpr std::size_t grain_size = 128; // least number of bodies in one parallel task
    pool.for_each_range(wide.size(), grain_size, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const ImpulseBody body = impulse_body(search.world, search.world.bodies[i]);
            const double hit = body.is_still ? 0 : speed_transfer(body, heaviest) * fastest;
            wide[i].grow(margin(search, static_cast<int>(i), std::max(search.travels[i], hit)));
        }
    });
    return wide;
}

// The margins of the fat bounds in the pair cache. They are so large that a body that slows down or
// rests on others stays within its fat bounds for many steps, and so small that few additional
// pairs are kept. No result depends on them. Both numbers were chosen by trial.
std::vector<double> fat_margins(const ContactSearch& search)
{
    constexpr double radius_share = 0.1; // share of the body's radius
    constexpr double steps_ahead = 3;    // multiple of the body's travel in this step
    std::vector<double> margins(search.travels.size());
    for (std::size_t i = 0; i < margins.size(); ++i)
        margins[i] = radius_share * search.candidates.radii[i] + steps_ahead * search.travels[i];
    return margins;
}

// The result of the narrow phase for some pairs.
struct NarrowPhaseResult {
    std::vector<Contact> contacts;
    std::vector<int> disturbed;
    bool any_may_meet = false;
    Counters counters;
};

NarrowPhaseResult run_narrow_phase(const ContactSearch& search, std::span<const BodyPair> pairs)
{
    NarrowPhaseResult found;
    for (const auto& [i, j] : pairs) {
        if (never_collide(search.world, i, j)) continue;
        const double margin = search.candidates.margins[i] + search.candidates.margins[j];
        if (!come_near(search, {i, j}, margin)) continue;
        ++found.counters.pairs_tested;
        const double path = path_between(search.motions[i], search.motions[j]);
        const std::size_t first = found.contacts.size();
        find_contacts(search.world,
                      search.poses_ahead.empty() ? search.candidates.poses : search.poses_ahead, i,
                      j, path + margin, found.contacts, found.counters, search.time_step);
        bool may_meet = false;
        for (std::size_t k = first; k < found.contacts.size(); ++k)
            may_meet |= found.contacts[k].gap < path;
        found.any_may_meet |= may_meet;
        for (int sleeping : {i, j}) {
            if (!search.world.bodies[sleeping].rest.is_asleep()) continue;
            if (may_meet && path > 0) found.disturbed.push_back(sleeping); // path > 0: a body moves
            found.contacts.resize(first);
        }
    }
    return found;
}

// Makes `search.poses_ahead`: a copy of all poses, where each body that rolls over its facets
// (`turns_over_facets`) gets its orientation at the end of free flight. Without such bodies it
// stays empty.
void turn_ahead(ContactSearch& search, std::span<const RigidState> flown)
{
    for (std::size_t i = 0; i < flown.size(); ++i) {
        if (!turns_over_facets(search.world.bodies[i], flown[i])) continue;
        if (search.poses_ahead.empty()) {
            search.poses_ahead = search.candidates.poses;
            search.candidates.turned_ahead.resize(flown.size(), false);
        }
        search.poses_ahead[i].R = pose_of(flown[i]).R;
        search.candidates.turned_ahead[i] = true;
    }
}

// The poses, radii, swept bounds and travel of all bodies.
ContactSearch start_search(const World& world, std::span<const RigidState> flown, double time_step,
                           ThreadPool& pool)
{
    constexpr std::size_t grain_size = 32; // least number of bodies in one parallel task
    const std::size_t n = flown.size();
    ContactSearch search{
        world,    std::vector<Travel>(n), std::vector<Bounds>(n), std::vector<double>(n), {}, {},
        time_step};
    search.candidates.poses.resize(n);
    search.candidates.radii.resize(n);
    const std::vector<Travel> frames = frames_of(world, flown, time_step);
    const Vector3d frame = frame_of_bounds(world, frames);
    pool.for_each_range(n, grain_size, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const RigidBody& body = world.bodies[i];
            search.candidates.poses[i] = pose_of(body.state);
            search.bounds[i] = body_bounds(body, search.candidates.poses[i]);
            if (!body.is_static) search.candidates.radii[i] = body_radius(body);
            if (body.is_still()) continue;
            Pose end = pose_of(flown[i]);
            end.X -= frame;
            search.bounds[i].include(body_bounds(body, end));
            const double radius = body.is_static ? body_radius(body) : search.candidates.radii[i];
            const double angle = angle_turned(world, body, body.state, time_step);
            // During the step a body may reach farther than at its start and its end. If the body
            // turns by at most a right angle and can be pushed, its margin covers this. A driven
            // body has no margin, so its bounds are enlarged here.
            if (angle > std::numbers::pi / 2)
                for (const Vector3d& X : {search.candidates.poses[i].X, end.X})
                    search.bounds[i].include({X.array() - radius, X.array() + radius});
            else if (body.is_static)
                search.bounds[i].grow(radius * (1 - std::cos(angle / 2)));
            search.motions[i] = travel_of(body.state, flown[i], angle, radius, time_step);
            for (const Travel& given : frames)
                search.travels[i] =
                    std::max(search.travels[i], path_between(search.motions[i], given));
        }
    });
    return search;
}

} // namespace

ContactCandidates contact_candidates(World& world, std::span<const RigidState> flown,
                                     double time_step, ThreadPool& pool)
{
    ContactSearch search = start_search(world, flown, time_step, pool);
    ContactCandidates& candidates = search.candidates;
    const std::vector<BodyPair> pairs = cached_near_pairs(
        world, candidates.poses, bounds_with_impulses(search, pool), fat_margins(search), pool);
    if (pairs.empty()) return std::move(candidates);
    candidates.margins = margins_of(search, pairs, pool);
    turn_ahead(search, flown);

    constexpr std::size_t grain_size = 128; // least number of pairs in one parallel task
    std::vector<NarrowPhaseResult> all =
        pool.collect_ranges(pairs.size(), grain_size, [&](std::size_t first, std::size_t last) {
            return run_narrow_phase(search, std::span(pairs).subspan(first, last - first));
        });
    const std::size_t contacts =
        std::accumulate(all.begin(), all.end(), std::size_t{0},
                        [](std::size_t sum, const NarrowPhaseResult& found) {
                            return sum + found.contacts.size();
                        });
    candidates.contacts = std::move(all[0].contacts); // `candidates.contacts` was empty
    candidates.contacts.reserve(contacts);
    bool any_may_meet = false;
    for (const NarrowPhaseResult& found : all) {
        candidates.contacts.insert(candidates.contacts.end(), found.contacts.begin(),
                                   found.contacts.end());
        candidates.disturbed.insert(candidates.disturbed.end(), found.disturbed.begin(),
                                    found.disturbed.end());
        any_may_meet |= found.any_may_meet;
        world.counters += found.counters;
    }
    if (!any_may_meet) candidates.contacts.clear(); // then no collision formula is called
    return std::move(candidates);
}

} // namespace rigor
