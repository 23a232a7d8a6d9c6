// SPDX-License-Identifier: MIT
// The midpoint rule for contacts that move along a curve or along a body (Moreau 1999, "Numerical
// aspects of the sweeping process", Comput. Methods Appl. Mech. Eng. 177). The contact stage has
// found velocities with the contacts at the start of the step. Now the island is solved with the
// contacts in the middle of the step, so that the mean of the velocities at the start and at the
// end obeys the law of contact: it has no part along the normal, and no part along the surface
// where a contact sticks. So only the friction of sliding contacts does work. Errors that earlier
// steps have left are removed.
#include "rigid/step/midpoint/midpoint_contact.hpp"

#include "rigid/contact/blocks.hpp"
#include "rigid/contact/make_problem.hpp"
#include "rigid/contact/solvers/island_solver.hpp"
#include "rigid/step/midpoint/middle_of_step.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace rigor {

namespace {

// v·n of a contact changes by `HeldContact::change` from the start to the middle of a step. If the
// last step was solved with the contacts of its start, it has left a v·n of twice this change. At a
// contact that sticks, it has also left a slip of twice the change of the slip. If v·n is larger
// than its change times `most_changes`, the contact has just been hit. If the slip is larger than
// its change times `most_changes`, the contact has just begun to stick. Chosen by trial between 2
// and 4; tests/classics has bodies that roll.
constexpr double most_changes = 3;
// A v·n below this share of the speed that the forces add in a step is no hit either. Where a body
// reverses its motion, v·n hardly changes from the start to the middle of the step, but the error
// that the last step has left is not small. Chosen by trial, with the same tests as `most_changes`.
constexpr double negligible_share = 0.1;
// The share β of an open gap that a step closes. With β = 1, the gap and v·n of a contact that
// stays for many steps would oscillate without end: the linear map from their values in one step to
// those in the next has the eigenvalues λ with λ² - (1 - β) λ + β = 0, thus |λ| = 1.
// The two eigenvalues are equal, and small, for (1 - β)² = 4 β.
constexpr double closed_share = 0.1716;

// The part of a contact's v at the start of the step that the law of contact does not allow: v·n,
// and the slip of a contact that sticks. This part is the error of the last step [m/s]. In the
// result, v·n points along the normal in the middle of the step, and the slip is perpendicular to
// that normal.
// @return nothing if the contact has just closed, or has just begun to stick
std::optional<Vector3d> error_of(const ContactProblem& problem, const HeldContact& contact)
{
    const ContactConstraint& c = problem.contacts[contact.index];
    const Vector3d &n = c.normal, &n_mid = contact.middle.normal, &v = contact.v_start;
    const double least = negligible_share * std::abs(c.force_speed) + problem.rounding_speed(c);
    const double hit = c.normal_K * c.collision_impulse.norm(); // change of v·n by the collision
    if (std::max(hit, std::abs(v.dot(n))) > most_changes * contact.change + least)
        return std::nullopt;
    if (contact.slides) return v.dot(n) * n_mid;
    const double change = contact.change + (slip(contact.v_middle, n_mid) - slip(v, n)).norm();
    if (slip(v, n).norm() > most_changes * change + least) return std::nullopt;
    return v.dot(n) * n_mid + slip(v, n_mid);
}

// The problem in the middle of the step. Its velocities are the sums of those at the start and at
// the end of the step, so the solver finds impulses with which these sums obey the law of contact.
struct MidpointProblem {
    ContactProblem problem;
    // For each moving body, by its index in the world: its index in `problem.bodies`.
    std::map<int, int> places;
    // The error of each contact at the start of the step (`error_of`) [m/s]. If the sum of the
    // velocities at the start and at the end were 0, the velocity at the end would have the
    // opposite error. So the sum has to equal the error. Therefore each contact with a static body
    // has its own copy of this body, which moves with the error. Between two moving bodies, only
    // the normal part of the error counts, as a target speed.
    std::vector<Vector3d> errors;

    bool is_on_ground(const ContactConstraint& c) const
    {
        return problem.bodies[c.body1].is_static() || problem.bodies[c.body2].is_static();
    }
    // v₁ - v₂ of contact k, summed over the start and the end of the step.
    Vector3d sum_at(std::size_t k) const
    {
        const ContactConstraint& c = problem.contacts[k];
        const Vector3d v = velocity_at(c, problem.bodies[c.body1], problem.bodies[c.body2]);
        return is_on_ground(c) ? Vector3d(v + errors[k]) : v;
    }
};

void add_contact(const ContactProblem& whole, const std::vector<Body>& before_forces,
                 const MiddleOfStep& middle, const HeldContact& contact, const Vector3d& error,
                 MidpointProblem& mid)
{
    ContactProblem& problem = mid.problem;
    const auto place = [&](int i, const Vector3d& error_of_ground) {
        if (const auto found = mid.places.find(i); found != mid.places.end()) return found->second;
        const auto moved = middle.bodies.find(i);
        Body ground = moved == middle.bodies.end() ? before_forces[i] : moved->second;
        ground.velocity = 2 * ground.velocity + error_of_ground;
        ground.angular_velocity *= 2;
        problem.bodies.push_back(ground);
        return static_cast<int>(problem.bodies.size()) - 1;
    };
    ContactConstraint c = whole.contacts[contact.index];
    c.body1 = place(c.body1, -error);
    c.body2 = place(c.body2, error);
    c.point = contact.middle.point;
    c.normal = contact.middle.normal;
    c.target_speed = -2 * closed_share * std::max(c.gap, 0.0) / problem.time_step;
    if (!mid.is_on_ground(c)) c.target_speed += error.dot(c.normal);
    c.initial_impulse = c.contact_impulse;
    c.contact_impulse.setZero();
    problem.set_impulse_matrix(c);

    std::vector<ContactPair>& pairs = problem.islands.front().pairs;
    const int k = static_cast<int>(problem.contacts.size());
    const bool is_same_pair = k > 0 && problem.contacts[k - 1].body1 == c.body1 &&
                              problem.contacts[k - 1].body2 == c.body2;
    if (is_same_pair)
        ++pairs.back().last;
    else
        pairs.push_back({k, k + 1});
    problem.contacts.push_back(c);
    mid.errors.push_back(error);
}

// @param forced  the bodies with their velocities after the forces, in the order of `island.bodies`
MidpointProblem midpoint_problem(const ContactProblem& whole, const Island& island,
                                 const std::vector<Body>& before_forces,
                                 const std::vector<Body>& forced, const MiddleOfStep& middle,
                                 const std::vector<Vector3d>& errors)
{
    MidpointProblem mid;
    ContactProblem& problem = mid.problem;
    problem.time_step = whole.time_step;
    problem.settings = whole.settings;
    problem.optimised = whole.optimised;
    problem.counters = whole.counters;
    problem.pool = whole.pool;
    Island& all = problem.islands.emplace_back();
    for (std::size_t k = 0; k < island.bodies.size(); ++k) {
        Body sum = middle.bodies.at(island.bodies[k]);
        sum.velocity += forced[k].velocity;
        sum.angular_momentum += forced[k].angular_momentum;
        sum.angular_velocity = sum.inverse_inertia * sum.angular_momentum;
        mid.places[island.bodies[k]] = static_cast<int>(k);
        all.bodies.push_back(static_cast<int>(k));
        problem.bodies.push_back(sum);
    }
    for (std::size_t k = 0; k < errors.size(); ++k)
        add_contact(whole, before_forces, middle, middle.contacts[k], errors[k], mid);
    split_into_blocks(problem, all);
    return mid;
}

// A point in the middle of the step, moved back to the start of the step with the bodies that move,
// because the data of a contact belong to the poses at the start of the step.
Vector3d at_start(const Vector3d& x, const Contact& c, const MiddleOfStep& middle,
                  const std::vector<Body>& before_forces)
{
    Vector3d moved = Vector3d::Zero();
    int count = 0;
    for (const int i : {c.body1, c.body2})
        if (const auto found = middle.bodies.find(i);
            found != middle.bodies.end() && !found->second.is_static()) {
            moved += found->second.position - before_forces[i].position;
            ++count;
        }
    return x - moved / count;
}

// Whether a contact of the island that got no impulse would close. For example, a ball that slides
// from one box onto the next one still touches the edge of the first box when it reaches the
// second.
bool any_other_closes(const MidpointProblem& mid, const Island& island,
                      const std::vector<Body>& before_forces, const ContactProblem& problem)
{
    const auto mean = [&](int i) {
        Body body = before_forces[i];
        const auto place = mid.places.find(i);
        if (place == mid.places.end()) return body;
        const Body& sum = mid.problem.bodies[place->second];
        body.velocity = sum.velocity / 2;
        body.angular_velocity = body.inverse_inertia * sum.angular_momentum / 2;
        return body;
    };
    for (const ContactPair& pair : island.pairs) {
        const ContactConstraint& lowest = problem.contacts[pair.first];
        const Body body1 = mean(lowest.body1), body2 = mean(lowest.body2);
        for (int i = pair.first; i < pair.last; ++i) {
            const ContactConstraint& c = problem.contacts[i];
            if (problem.holds(c)) continue;
            const double gap = problem.predicted_gap(c, velocity_at(c, body1, body2).dot(c.normal));
            if (gap < std::min(c.gap, 0.0) - nearly_touching_gap * c.radius) return true;
        }
    }
    return false;
}

// Whether a contact does not slide in the mean of the step: then its slip reverses its direction.
bool any_stops(const ContactProblem& mid)
{
    return std::any_of(mid.contacts.begin(), mid.contacts.end(),
                       [&](const ContactConstraint& c) { return mid.holds(c) && !slides(c); });
}

void take_results(const MidpointProblem& mid, const MiddleOfStep& middle, const Island& island,
                  const std::vector<Body>& before_forces, ContactProblem& problem)
{
    for (const int i : island.bodies) {
        const Body& sum = mid.problem.bodies[mid.places.at(i)];
        Body& body = problem.bodies[i];
        body.velocity = sum.velocity - before_forces[i].velocity;
        body.angular_momentum = sum.angular_momentum - before_forces[i].angular_momentum;
        body.angular_velocity = body.inverse_inertia * body.angular_momentum;
    }
    for (std::size_t k = 0; k < middle.contacts.size(); ++k) {
        const ContactConstraint& solved = mid.problem.contacts[k];
        ContactConstraint& c = problem.contacts[middle.contacts[k].index];
        c.contact_impulse = solved.contact_impulse;
        c.point = at_start(solved.point, c, middle, before_forces);
        c.normal = solved.normal;
        // With this value, `predicted_gap` returns gap + h times the mean of v·n.
        const double mean = mid.sum_at(k).dot(c.normal) / 2;
        c.gap_correction =
            problem.time_step * (mean - problem.velocity_at(c, c.point).dot(c.normal));
    }
}

} // namespace

MidpointResult solve_at_midpoint(const World& world, const std::vector<Body>& before_forces,
                                 const std::vector<RigidState>& flown, const Island& island,
                                 std::vector<Pose>& poses, ContactProblem& problem)
{
    const std::optional<MiddleOfStep> middle =
        middle_of_step(world, problem, island, before_forces, poses);
    if (!middle) return MidpointResult::unchanged;
    std::vector<Vector3d> errors;
    for (const HeldContact& contact : middle->contacts) {
        const std::optional<Vector3d> error = error_of(problem, contact);
        if (!error) return middle->has_curve ? MidpointResult::refused : MidpointResult::unchanged;
        errors.push_back(*error);
    }
    std::vector<Body> forced;
    for (const int i : island.bodies) {
        forced.push_back(with_forces(before_forces[i], world.bodies[i].state, flown[i]));
        forced.back().velocity -= island.frame.change();
    }

    MidpointProblem mid = midpoint_problem(problem, island, before_forces, forced, *middle, errors);
    std::vector<int> active(mid.problem.contacts.size());
    std::iota(active.begin(), active.end(), 0);
    solve_island(mid.problem, mid.problem.islands.front(), active);
    if (any_other_closes(mid, island, before_forces, problem) ||
        (middle->slip_turns && !middle->has_curve && any_stops(mid.problem)))
        return MidpointResult::unchanged;
    take_results(mid, *middle, island, before_forces, problem);
    return MidpointResult::solved;
}

} // namespace rigor
