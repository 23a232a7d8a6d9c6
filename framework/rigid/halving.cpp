// SPDX-License-Identifier: MIT
#include "rigid/halving.hpp"

#include "geometry/shapes/shape_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace rigor {

namespace {

constexpr std::size_t most_bodies = 32;
constexpr double turned_in = 0.005, pressed_in = 0.05; // overlap that is allowed, of the thickness

// The least extent of a body's thinnest part [m].
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

// A ball is where it is, however it turns.
bool is_ball(const RigidBody& body)
{
    return body.parts.size() == 1 && std::holds_alternative<Sphere>(body.parts[0].shape);
}

// How far a body's turn may take it from the planes of its contacts [m].
double leaves_by(const World& world, const ContactProblem& problem, int i, double radius)
{
    const RigidBody& body = world.bodies[i];
    if (body.is_still() || is_ball(body)) return 0;
    const double angle = problem.time_step * problem.bodies[i].angular_velocity.norm();
    return angle * angle / 2 * radius;
}

double deepest(const std::vector<Contact>& contacts)
{
    double depth = 0;
    for (const Contact& c : contacts)
        depth = std::max(depth, -c.gap);
    return depth;
}

// The bodies of an island in a world of their own, with what is fixed near them.
struct IslandWorld {
    World world;
    std::vector<int> bodies; // their indices in the whole world, ascending
};

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
    part.world.gravity = world.gravity;
    part.world.integrator = world.integrator;
    part.world.contact_method = world.contact_method;
    part.world.skips = world.skips;
    part.world.skips.sleep = false;
    part.world.formulas_are_reference = world.formulas_are_reference;
    part.world.time = world.time;
    part.world.counters = world.counters;
    for (WarmContact warm : world.warm_contacts) {
        const auto body1 = index.find(warm.body1), body2 = index.find(warm.body2);
        if (body1 == index.end() || body2 == index.end()) continue;
        warm.body1 = body1->second;
        warm.body2 = body2->second;
        part.world.warm_contacts.push_back(warm);
    }
    return part;
}

} // namespace

bool Halving::overlaps_anew(const ContactProblem& problem, const Island& island,
                            const std::vector<RigidState>& states)
{
    if (island.bodies.size() > most_bodies) return false;
    if (std::any_of(island.bodies.begin(), island.bodies.end(), [&](int i) { return pulled_[i]; }))
        return false;
    return std::any_of(island.pairs.begin(), island.pairs.end(), [&](const ContactPair& pair) {
        return overlaps_anew(problem, pair, states);
    });
}

bool Halving::overlaps_anew(const ContactProblem& problem, const ContactPair& pair,
                            const std::vector<RigidState>& states)
{
    const int i = problem.contacts[pair.first].body1, j = problem.contacts[pair.first].body2;
    const double thinner = std::min(thickness(world_.bodies[i]), thickness(world_.bodies[j]));
    double before = 0, pressed = 0;
    for (int k = pair.first; k < pair.last; ++k) {
        const SolvedContact& c = problem.contacts[k];
        const double v_n = problem.velocity_at(c, c.point).dot(c.normal);
        before = std::max(before, -c.gap);
        pressed = std::max(pressed, -problem.predicted_gap(c, v_n));
    }
    const double turned = leaves_by(world_, problem, i, near_.radii[i]) +
                          leaves_by(world_, problem, j, near_.radii[j]);
    const bool is_turned = turned > turned_in * thinner;
    if (!is_turned && !(pressed > before + pressed_in * thinner)) return false;
    poses_.resize(states.size());
    for (int body : {i, j})
        poses_[body] = pose_of(states[body]);
    std::vector<Contact> after;
    find_contacts(world_, poses_, i, j, 0, after);
    return deepest(after) > before + (is_turned ? turned_in : pressed_in) * thinner;
}

void Halving::step_in_halves(ContactProblem& problem, std::vector<RigidState>& states,
                             const Step& step)
{
    for (const Island& island : problem.islands) {
        if (!overlaps_anew(problem, island, states)) continue;
        IslandWorld part = part_of(world_, island, near_.contacts);
        for (int half = 0; half < 2; ++half)
            for (ContactRecord record : step(part.world, problem.time_step / 2)) {
                record.body1 = part.bodies[record.body1];
                record.body2 = part.bodies[record.body2];
                records.push_back(record);
            }
        for (std::size_t k = 0; k < part.bodies.size(); ++k)
            if (!part.world.bodies[k].is_static)
                states[part.bodies[k]] = part.world.bodies[k].state;
        for (WarmContact contact : part.world.warm_contacts) {
            contact.body1 = part.bodies[contact.body1];
            contact.body2 = part.bodies[contact.body2];
            warm.push_back(contact);
        }
        const std::uint64_t steps = problem.counters->steps;
        *problem.counters = part.world.counters;
        problem.counters->steps = steps;
        for (const ContactPair& pair : island.pairs)
            for (int i = pair.first; i < pair.last; ++i) {
                problem.contacts[i].bounce.setZero();
                problem.contacts[i].holding.setZero();
            }
    }
}

} // namespace rigor
