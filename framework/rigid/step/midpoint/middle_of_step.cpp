// SPDX-License-Identifier: MIT
// The middle of a step, for contacts that move along a curve or along a body. The bodies of an
// island move for half of the step, with the means of their velocities at the start and after the
// contact stage. With these poses the narrow phase finds the contacts again, and each contact with
// an impulse is matched with one of those that it finds. A contact moves along a curve if its v·n
// has changed, and along a body if its lever arm has changed.
#include "rigid/step/midpoint/middle_of_step.hpp"

#include "rigid/bodies/orientation.hpp"
#include "rigid/contact/driven_bodies.hpp"
#include "rigid/motion/free_flight.hpp"
#include "rigid/step/midpoint/held_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// Islands with more contacts than this, or with more than `few_bodies` bodies, are left out: to
// find and solve their contacts twice would cost too much.
constexpr std::size_t most_contacts = 32;
// A contact moves along a curve if its v·n changes by more than this share of `speed_at`; a smaller
// change is only an error of the sweeps. In mean_velocity.cpp, a contact is held along a fixed
// normal if its v·n stays below the share `opens`, which is 1e-6. The share here must be well below
// that one, so that each contact counts as one or the other; the step of an island with a contact
// that is neither would be of first order.
constexpr double least_change = 1e-7;
bool has_mesh(const RigidBody& body)
{
    return std::any_of(body.parts.begin(), body.parts.end(),
                       [](const Part& part) { return std::holds_alternative<Mesh>(part.shape); });
}

// Whether a drive starts or ends within the step.
bool changes_within(const Drive& drive, double time, double time_step)
{
    const auto is_within = [&](double t) { return t > time && t < time + time_step; };
    return is_within(drive.start) || is_within(drive.end);
}

// Whether the contacts of an island with a static or driven body can be moved to the middle of the
// step. In the frame of the island, this body moves along a line or turns at a constant velocity.
bool is_steady(const World& world, const ContactProblem& problem, const Island& island, int ground)
{
    const auto& drive = world.bodies[ground].drive;
    return is_steady_in_frame(problem, island, ground) &&
           !(drive && changes_within(*drive, world.time, problem.time_step));
}

bool is_suitable(const World& world, const ContactProblem& problem, const Island& island)
{
    const ContactMethod method = problem.settings.contact_method;
    const bool solves_at_once =
        method == ContactMethod::built_in || method == ContactMethod::simultaneous;
    if (!solves_at_once || island.bodies.size() > few_bodies ||
        contact_count(island.pairs) > most_contacts)
        return false;
    bool is_grounded = false;
    for (const ContactPair& pair : island.pairs) {
        const ContactConstraint& lowest = problem.contacts[pair.first];
        for (const int i : {lowest.body1, lowest.body2}) {
            const RigidBody& body = world.bodies[i];
            if (has_mesh(body)) return false;
            if (body.is_static && !is_steady(world, problem, island, i)) return false;
            is_grounded |= body.is_static;
        }
    }
    return is_grounded;
}

// Whether a contact touches a driven body that turns.
bool touches_a_turning_drive(const World& world, const ContactConstraint& c)
{
    const auto turns = [&](int i) {
        const auto& drive = world.bodies[i].drive;
        return drive && !drive->angular_velocity.isZero(0);
    };
    return turns(c.body1) || turns(c.body2);
}

// The contacts of the island that got an impulse, and those that a driven body that turns may close
// within the step. The list is empty if each of them moves by at most `least_change` times its
// radius in this step, because then its path is practically straight.
std::vector<HeldContact> held_contacts(const World& world, const ContactProblem& problem,
                                       const Island& island, const std::vector<Body>& before_forces)
{
    const auto may_close = [&](const ContactConstraint& c) {
        return touches_a_turning_drive(world, c) &&
               c.gap <= nearly_touching_gap * c.radius + problem.bend_of_drives(c);
    };
    std::vector<HeldContact> held;
    bool any_moves = false;
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i) {
            const ContactConstraint& c = problem.contacts[i];
            const bool has_impulse = problem.holds(c);
            if (!has_impulse && !may_close(c)) continue;
            const double speed = speed_at(c, before_forces[c.body1], before_forces[c.body2]);
            any_moves |= problem.time_step * speed > least_change * c.radius;
            HeldContact& contact = held.emplace_back();
            contact.index = i;
            contact.v_start = velocity_at(c, before_forces[c.body1], before_forces[c.body2]);
            contact.negligible = least_change * speed + problem.rounding_speed(c);
            contact.has_impulse = has_impulse;
            contact.slides = slides(c);
        }
    if (!any_moves) held.clear();
    return held;
}

// Sets the poses of the island's bodies, and of driven bodies that it touches, to those in the
// middle of the step, as seen from the frame of the island.
// @return these bodies in these poses with their velocities at the start of the step, by their
//         indices in the world
std::map<int, Body> moved_to_the_middle(const World& world, const ContactProblem& problem,
                                        const Island& island,
                                        const std::vector<Body>& before_forces,
                                        std::vector<Pose>& poses)
{
    const double half = problem.time_step / 2;
    std::map<int, Body> moved;
    Counters uncounted;
    for (const int i : island.bodies) {
        const RigidBody& rigid = world.bodies[i];
        const Body& last = problem.bodies[i];
        RigidState state = rigid.state;
        state.velocity = (before_forces[i].velocity + last.velocity) / 2;
        state.angular_momentum = (before_forces[i].angular_momentum + last.angular_momentum) / 2;
        state = fly(world.settings, rigid, state, half, uncounted, Gravity::left_out);
        poses[i] = pose_of(state);
        Body& body = moved[i] = before_forces[i];
        body.position = state.position;
        body.inverse_inertia = inverse_inertia(world.settings.integrator, rigid, state);
        body.angular_velocity = body.inverse_inertia * body.angular_momentum;
    }
    for (const ContactPair& pair : island.pairs) {
        const ContactConstraint& c = problem.contacts[pair.first];
        for (const int i : {c.body1, c.body2}) {
            const auto& drive = world.bodies[i].drive;
            if (!drive || drive->is_belt || moved.contains(i)) continue;
            Body& body = moved[i] = before_forces[i];
            body.position += half * problem.drive_of(i)->mean.linear;
            poses[i] = {pose_of(driven_state(*drive, world.time + half)).R, body.position};
        }
    }
    return moved;
}

// Whether a contact moves along one of the bodies of the island from the start to the middle of the
// step, so that the load of this body on the contact changes: both in world space and in object
// space, the lever arm changes by more than `least_change` times the radius. (The lever arm of a
// wheel that spins on the spot changes in object space alone, and that of a corner of a body that
// turns in world space alone.)
// @param poses  those in the middle of the step
bool moves_along_a_body(const ContactConstraint& start, const Contact& middle, const World& world,
                        const std::vector<Pose>& poses, const std::map<int, Body>& moved)
{
    const double least = least_change * start.radius;
    return std::any_of(moved.begin(), moved.end(), [&](const auto& entry) {
        const auto& [i, body] = entry;
        if (body.is_static() || (i != start.body1 && i != start.body2)) return false;
        const auto& [R, X] = poses[i];
        const Pose first = pose_of(world.bodies[i].state);
        const Vector3d r = start.point - first.X, r_mid = middle.point - X;
        return (r_mid - r).norm() > least &&
               (R.transpose() * r_mid - first.R.transpose() * r).norm() > least;
    });
}

// Sets `v_middle` and `change` of a held contact.
// @param moved  the bodies in the middle of the step, see `MiddleOfStep`
// @return v₁ - v₂ at the contact point of the start of the step, with the velocities after the
//         contact stage [m/s]
Vector3d set_velocities(const ContactProblem& problem, const std::vector<Body>& before_forces,
                        const std::map<int, Body>& moved, HeldContact& contact)
{
    // Body i at mid-step: `starting` has its first velocities, `ending` its last ones.
    const auto starting = [&](int i) -> const Body& {
        const auto found = moved.find(i);
        return found == moved.end() ? before_forces[i] : found->second;
    };
    const auto ending = [&](int i) {
        Body body = starting(i);
        body.velocity = problem.bodies[i].velocity;
        body.angular_momentum = problem.bodies[i].angular_momentum;
        if (!body.is_static()) body.angular_velocity = body.inverse_inertia * body.angular_momentum;
        return body;
    };
    const ContactConstraint& c = problem.contacts[contact.index];
    const Vector3d& n = contact.middle.normal;
    contact.v_middle = velocity_at(contact.middle, starting(c.body1), starting(c.body2));
    const Vector3d v_last = velocity_at(c, problem.bodies[c.body1], problem.bodies[c.body2]),
                   v_last_middle = velocity_at(contact.middle, ending(c.body1), ending(c.body2));
    contact.change = std::max(std::abs(contact.v_middle.dot(n) - contact.v_start.dot(c.normal)),
                              std::abs(v_last_middle.dot(n) - v_last.dot(c.normal)));
    return v_last;
}

// Whether the slip at a contact has another direction at the end of the step than at its start.
bool turns(const Vector3d& first, const Vector3d& last, double negligible)
{
    return first.cross(last).norm() > negligible * std::max(first.norm(), last.norm());
}

} // namespace

bool slides(const ContactConstraint& c)
{
    return is_at_friction_limit(c, c.contact_impulse);
}

Vector3d velocity_at(const Contact& c, const Body& body1, const Body& body2)
{
    return body1.velocity + body1.angular_velocity.cross(c.point - body1.position) -
           body2.velocity - body2.angular_velocity.cross(c.point - body2.position);
}

std::optional<MiddleOfStep> middle_of_step(const World& world, const ContactProblem& problem,
                                           const Island& island,
                                           const std::vector<Body>& before_forces,
                                           std::vector<Pose>& poses)
{
    if (!is_suitable(world, problem, island)) return std::nullopt;
    MiddleOfStep middle;
    std::vector<HeldContact>& held = middle.contacts =
        held_contacts(world, problem, island, before_forces);
    if (held.empty()) return std::nullopt;
    middle.bodies = moved_to_the_middle(world, problem, island, before_forces, poses);
    if (!find_middles(world, problem, before_forces, poses, held)) return std::nullopt;

    bool any_shift = false, any_turning_drive = false, all_slide = true, all_stay = true;
    for (HeldContact& contact : held) {
        const ContactConstraint& c = problem.contacts[contact.index];
        const Vector3d v_last = set_velocities(problem, before_forces, middle.bodies, contact);
        middle.has_curve |= contact.change > contact.negligible;
        any_shift |= moves_along_a_body(c, contact.middle, world, poses, middle.bodies);
        any_turning_drive |= touches_a_turning_drive(world, c);
        const Vector3d slip_first = slip(contact.v_start, c.normal);
        all_slide &= contact.slides && slip_first.norm() > contact.negligible;
        middle.slip_turns |= turns(slip_first, slip(v_last, c.normal), contact.negligible);
        all_stay &= std::max(std::abs(contact.v_start.dot(c.normal)),
                             std::abs(v_last.dot(c.normal))) <= contact.negligible;
    }
    const bool loads_change = any_shift && all_slide && all_stay && held.size() > 1;
    middle.slip_turns &= all_slide && all_stay;
    const bool is_solved_again =
        middle.has_curve || (any_turning_drive && loads_change) || middle.slip_turns;
    return is_solved_again ? std::optional(middle) : std::nullopt;
}

} // namespace rigor
