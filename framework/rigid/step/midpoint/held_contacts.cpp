// SPDX-License-Identifier: MIT
// Matches contacts of the start of a step with those of its middle, pair by pair. Most contacts are
// found near the point that moves with the bodies. The contacts of a plank on a log, or of a pebble
// that rocks, move farther than any point of the bodies; they are accepted if they move at a nearly
// constant velocity.
#include "rigid/step/midpoint/held_contacts.hpp"

#include "rigid/detection/narrow_phase.hpp"

#include <algorithm>
#include <optional>
#include <span>

namespace rigor {

namespace {

// Smallest cosine of the angle between the normals of a contact at the start and in the middle of
// the step; the largest angle is 60°. At a larger angle, the two count as different contacts.
constexpr double same_side = 0.5;

// Takes from `found` the contact nearest to `point`, if it lies within `reach` and its normal
// differs from `normal` by at most 60°.
// @param point  the point of a contact at the start of the step, moved for half of the step with
//               the mean velocity of the two bodies at this point
// @return whether a contact was taken
bool take_nearest(const Vector3d& point, const Vector3d& normal, double reach,
                  std::vector<Contact>& found, Contact& nearest)
{
    const auto distance = [&](const Contact& c) { return (c.point - point).norm(); };
    const auto best =
        std::min_element(found.begin(), found.end(), [&](const Contact& a, const Contact& b) {
            return distance(a) < distance(b);
        });
    if (best == found.end() || distance(*best) > reach || best->normal.dot(normal) < same_side)
        return false;
    nearest = *best;
    found.erase(best);
    return true;
}

// Whether the contact in the middle of the step is with an edge towards which the bodies move: they
// are farther apart there than at the start, and its normal has turned against their motion. This
// is so where a body comes from one tile to the next. At the start, its contact with the second
// tile has the normal of the tile's face, since the search for contacts looks ahead. (On a convex
// surface, the bodies move apart in the middle of the step. On a concave surface, they overlap.)
// @param V  velocity of the center of body 1 relative to that of body 2. It counts instead of
//           v₁ - v₂, because the shape of a round body that rolls moves with its center.
bool is_edge_ahead(const HeldContact& contact, const ContactConstraint& start, const Vector3d& V)
{
    return contact.middle.gap > start.gap + nearly_touching_gap * start.radius &&
           V.dot(contact.middle.normal - start.normal) < -contact.negligible;
}

// Where a contact would be after `time` if it moved with the mean velocity of the two bodies at its
// point.
Vector3d carried(const HeldContact& contact, const ContactConstraint& c, const Body& body1,
                 double time)
{
    const Vector3d v1 = body1.velocity + body1.angular_velocity.cross(c.point - body1.position);
    return c.point + time * (v1 - contact.v_start / 2);
}

// Sets `middle` of the held contacts of one pair of bodies to the contacts that are found in the
// middle of the step: to the nearest ones. Where this is the edge of a tile (`is_edge_ahead`), the
// contact keeps its normal and gap.
// @param found  the contacts in the middle of the step
// @param shift  by how much the contacts move beyond their bodies [m]
// @param reach  the largest distance of a contact from where it is expected [m]
// @return whether each contact with an impulse was found again
bool match(const ContactProblem& problem, const std::vector<Body>& before_forces,
           std::span<HeldContact> contacts, std::vector<Contact> found, const Vector3d& shift,
           double reach)
{
    for (HeldContact& contact : contacts) {
        const ContactConstraint& c = problem.contacts[contact.index];
        const Body &body1 = before_forces[c.body1], &body2 = before_forces[c.body2];
        const Vector3d moved = carried(contact, c, body1, problem.time_step / 2) + shift;
        const bool is_found = take_nearest(moved, c.normal, reach, found, contact.middle);
        if (!is_found && contact.has_impulse) return false;
        if (is_found && is_edge_ahead(contact, c, body1.velocity - body2.velocity)) {
            contact.middle.point = moved;
            contact.middle.normal = c.normal;
            contact.middle.gap = c.gap;
        }
        const double closer = c.gap - contact.middle.gap;
        contact.is_left_out =
            !contact.has_impulse && !(is_found && closer > touching_gap * c.radius);
    }
    return true;
}

// The pose halfway between two poses.
Pose halfway(const Pose& a, const Pose& b)
{
    const Eigen::Quaterniond q = Eigen::Quaterniond(a.R).slerp(0.5, Eigen::Quaterniond(b.R));
    return {q.toRotationMatrix(), (a.X + b.X) / 2};
}

// The search for contacts of one pair of bodies during the first half of a step.
struct PairSearch {
    const World& world;
    const ContactProblem& problem;
    const std::vector<Body>& before_forces;
    std::span<const HeldContact> held;
    double reach; // the largest gap that counts [m]

    const ContactConstraint& lowest() const { return problem.contacts[held.front().index]; }

    std::vector<Contact> found(const std::vector<Pose>& poses, double time) const
    {
        std::vector<Contact> contacts;
        Counters uncounted;
        find_contacts(world, poses, lowest().body1, lowest().body2, reach, contacts, uncounted,
                      time);
        return contacts;
    }
    // By how much the contacts move beyond their bodies, if they are those that were found after
    // `time`, which must be equally many [m].
    Vector3d shift(const std::vector<Contact>& contacts, double time) const
    {
        Vector3d sum = Vector3d::Zero();
        for (std::size_t k = 0; k < held.size(); ++k)
            sum += contacts[k].point - carried(held[k], problem.contacts[held[k].index],
                                               before_forces[lowest().body1], time);
        return sum / static_cast<double>(held.size());
    }
};

// By how much the contacts of a pair move beyond their bodies until the middle of the step, for
// contacts that move evenly and farther than any point of the bodies: below a flat pebble that
// rocks, or a plank on a log. In a quarter of the step they move half as far; where a box rocks
// over from one edge to the other, contacts jump instead.
std::optional<Vector3d> even_shift(const PairSearch& search, const std::vector<Contact>& found,
                                   const std::vector<Pose>& poses)
{
    constexpr double uneven = 0.25; // the largest difference, as a share of the shift
    const std::size_t count = search.held.size();
    if (found.size() != count) return std::nullopt;
    const double half = search.problem.time_step / 2;
    const Vector3d shift = search.shift(found, half);
    if (count == 1) return shift;
    std::vector<Pose> quarter = poses;
    for (const int i : {search.lowest().body1, search.lowest().body2}) {
        const RigidBody& body = search.world.bodies[i];
        if (!body.is_static || body.changes_place())
            quarter[i] = halfway(pose_of(body.state), poses[i]);
    }
    const std::vector<Contact> before = search.found(quarter, half / 2);
    if (before.size() != count) return std::nullopt;
    const Vector3d difference = search.shift(before, half / 2) - shift / 2;
    return difference.norm() <= uneven * shift.norm() ? std::optional(shift) : std::nullopt;
}

// Finds the held contacts of one pair of bodies again in the middle of the step: near where their
// bodies carry them, or where they have moved evenly.
// @return whether each contact with an impulse was found again
bool find_middle(const World& world, const ContactProblem& problem,
                 const std::vector<Body>& before_forces, const std::vector<Pose>& poses,
                 std::span<HeldContact> contacts)
{
    const ContactConstraint& lowest = problem.contacts[contacts.front().index];
    const double h = problem.time_step;
    const double path =
        h * speed_at(lowest, before_forces[lowest.body1], before_forces[lowest.body2]) +
        nearly_touching_gap * lowest.radius;
    const PairSearch search{world, problem, before_forces, contacts, std::abs(lowest.gap) + path};
    const std::vector<Contact> found = search.found(poses, h / 2);
    if (match(problem, before_forces, contacts, found, Vector3d::Zero(), path)) return true;
    const std::optional<Vector3d> shift = even_shift(search, found, poses);
    return shift && match(problem, before_forces, contacts, found, *shift, path);
}

// Sets `is_left_out` of contacts that the bodies leave behind in the first half of the step. Where
// a ball crosses the joint between two tiles, both tiles hold it at the same point at the start,
// but only one of them does so in the middle of the step.
void mark_left_behind(const ContactProblem& problem, std::span<HeldContact> held)
{
    const auto is_left_behind = [&](const HeldContact& contact, const HeldContact& other) {
        if (contact.is_left_out || other.is_left_out) return false;
        const ContactConstraint &c = problem.contacts[contact.index],
                                &o = problem.contacts[other.index];
        const double negligible = nearly_touching_gap * c.radius;
        const bool is_same = (c.normal - o.normal).norm() <= nearly_touching_gap &&
                             (c.point - o.point).norm() <= negligible;
        return is_same && contact.middle.gap > other.middle.gap + negligible;
    };
    for (HeldContact& contact : held)
        if (std::any_of(held.begin(), held.end(),
                        [&](const HeldContact& other) { return is_left_behind(contact, other); }))
            contact.is_left_out = true;
}

} // namespace

double speed_at(const Contact& c, const Body& body1, const Body& body2)
{
    return (body1.velocity - body2.velocity).norm() +
           body1.angular_velocity.norm() * (c.point - body1.position).norm() +
           body2.angular_velocity.norm() * (c.point - body2.position).norm();
}

bool find_middles(const World& world, const ContactProblem& problem,
                  const std::vector<Body>& before_forces, const std::vector<Pose>& poses,
                  std::vector<HeldContact>& held)
{
    const auto bodies_of = [&](const HeldContact& contact) {
        const ContactConstraint& c = problem.contacts[contact.index];
        return std::pair(c.body1, c.body2);
    };
    for (auto begin = held.begin(), end = begin; begin != held.end(); begin = end) {
        const std::pair<int, int> pair = bodies_of(*begin);
        end = std::find_if(begin, held.end(),
                           [&](const HeldContact& other) { return bodies_of(other) != pair; });
        if (!find_middle(world, problem, before_forces, poses, {begin, end})) return false;
    }
    mark_left_behind(problem, held);
    std::erase_if(held, [](const HeldContact& contact) { return contact.is_left_out; });
    return true;
}

} // namespace rigor
