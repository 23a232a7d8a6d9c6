// SPDX-License-Identifier: MIT
// Makes the contact problem of a step from the contact candidates. The code first copies the bodies
// that have contacts, then selects the contacts that may close in this step. It groups the contacts
// into pairs of bodies and islands, while other threads set the warm-start impulses. Last, it
// computes the impulse matrices of the contacts and splits large islands into blocks.
#include "rigid/contact/make_problem.hpp"

#include "rigid/bodies/orientation.hpp"
#include "rigid/contact/blocks.hpp"
#include "rigid/contact/islands.hpp"
#include "rigid/contact/warm_start.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace rigor {

namespace {

// A static body in world space. If it is driven, its velocity is the mean over this step.
Body static_in_world(const RigidBody& rigid, double time, double time_step)
{
    Body body;
    body.position = rigid.state.position;
    if (rigid.drive) {
        const DriveVelocity mean = mean_drive_velocity(*rigid.drive, time, time_step);
        body.velocity = mean.linear;
        body.angular_velocity = mean.angular;
    }
    return body;
}

// Copies the bodies that have contacts twice. `problem.bodies` gets their state at the start of the
// step. `after_forces` gets the same poses with the velocities that the forces would give the
// bodies in this step. Also lists the driven bodies in `problem.driven`.
void take_bodies(const World& world, std::span<const RigidState> flown,
                 std::span<const Contact> contacts, ContactProblem& problem,
                 UninitializedVector<Body>& after_forces)
{
    std::vector<char> touches(world.bodies.size(), false);
    for (const Contact& contact : contacts)
        touches[contact.body1] = touches[contact.body2] = true;
    std::vector<int> touching;
    for (int i = 0; i < static_cast<int>(touches.size()); ++i)
        if (touches[i]) touching.push_back(i);
    for (int i : touching)
        if (const auto& drive = world.bodies[i].drive)
            problem.driven.push_back({i, drive_velocity(*drive, world.time),
                                      mean_drive_velocity(*drive, world.time, problem.time_step),
                                      drive_velocity(*drive, world.time + problem.time_step)});
    problem.bodies.resize(world.bodies.size());
    after_forces.resize(world.bodies.size());
    constexpr std::size_t grain_size = 64; // a thread takes at least this many bodies at a time
    problem.pool->for_each_range(
        touching.size(), grain_size, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) {
                const int i = touching[k];
                const RigidBody& rigid = world.bodies[i];
                problem.bodies[i] = rigid.is_static
                                        ? static_in_world(rigid, world.time, problem.time_step)
                                        : body_in_world(world.settings.integrator, rigid);
                after_forces[i] = with_forces(problem.bodies[i], world.bodies[i].state, flown[i]);
            }
        });
}

// The displacement of the end of a lever arm r by the rotation vector α (`turn`), without its
// first-order part α × r. By Rodrigues' formula (1840) it is
// (sin |α|/|α| - 1) α × r + (1 - cos |α|)/|α|² α × (α × r).
Vector3d bend_of_path(const Vector3d& turn, const Vector3d& r)
{
    const double angle = turn.norm();
    if (!(angle > 0)) return Vector3d::Zero();
    const Vector3d line = turn.cross(r);
    const double half = std::sin(angle / 2) / angle;
    return (std::sin(angle) / angle - 1) * line + 2 * half * half * turn.cross(line);
}

// Whether a body can move and all its shapes have a curved side or rim, on which the body may roll.
// Spheres do not count, because the rotation of a ball about its center moves none of its contacts
// along the normal.
bool rolls(const RigidBody& body)
{
    return !body.is_static && !body.parts.empty() &&
           std::all_of(body.parts.begin(), body.parts.end(), [](const Part& part) {
               return std::holds_alternative<Capsule>(part.shape) ||
                      std::holds_alternative<Torus>(part.shape) ||
                      std::holds_alternative<Cylinder>(part.shape) ||
                      std::holds_alternative<Cone>(part.shape) ||
                      std::holds_alternative<Ellipsoid>(part.shape);
           });
}

// The sum of the radii of two balls; 0 if one of the bodies is no ball [m].
double sum_of_radii(const RigidBody& body1, const RigidBody& body2)
{
    const auto radius = [](const RigidBody& ball) {
        return std::get<Sphere>(ball.parts[0].shape).radius;
    };
    return body1.is_ball() && body2.is_ball() ? radius(body1) + radius(body2) : 0;
}

// Sets `turning_speed` to the part of v·n by which the rotation of rolling bodies moves the point
// towards the other body. The solver moves the point along a straight line. On this line the point
// may reach the other body, although its real path, an arc of a circle, does not; then
// `gap_correction` is set too. If the point also reaches the other body on the arc, both values
// stay 0.
void set_turning(const ContactProblem& problem, bool rolls1, bool rolls2, ContactConstraint& c)
{
    // The real path of a point bends away from the straight line. The bend is computed for a fixed
    // normal, but on a curved surface the normal turns within the step. So the computed distance to
    // the other body may be wrong by this share of the bend. Chosen by trial; tests/classics has
    // wheels that roll.
    constexpr double bend_tolerance = 0.1;
    // The time over which the rotation of each body counts. It is the time step if the body rolls.
    // Otherwise it is 0, because for example the corners of a box do hit the other body.
    const Body &body1 = problem.bodies[c.body1], &body2 = problem.bodies[c.body2];
    const double h1 = rolls1 ? problem.time_step : 0, h2 = rolls2 ? problem.time_step : 0;
    // The rotation about the normal does not count. It turns the path along which the body rolls,
    // with the axis about which it rolls, and leaves all heights as they are.
    const auto rolling = [&](const Vector3d& w) -> Vector3d {
        return w - w.dot(c.normal) * c.normal;
    };
    const Vector3d turn1 = h1 * rolling(body1.angular_velocity),
                   turn2 = h2 * rolling(body2.angular_velocity);
    const Vector3d r1 = c.point - body1.position, r2 = c.point - body2.position;
    const double turned = c.normal.dot(Vector3d(turn1.cross(r1) - turn2.cross(r2)));
    if (turned >= 0) return;
    const double by_line = std::max(c.gap, 0.0) + turned;
    if (by_line < 0) {
        const double most_bend =
            (turn1.squaredNorm() * r1.norm() + turn2.squaredNorm() * r2.norm()) / 2;
        if (-by_line > (1 + bend_tolerance) * most_bend) return;
        const Vector3d bend1 = bend_of_path(turn1, r1), bend2 = bend_of_path(turn2, r2);
        const double bend = c.normal.dot(Vector3d(bend1 - bend2));
        if (by_line + bend < -bend_tolerance * bend) return;
        // If the point comes to the lowest place on its path within the step, other points of the
        // round body follow it, so the gap at this place stays as it is. Otherwise the gap at the
        // end is the one at the end of the arc.
        const Vector3d end1 = turn1.cross(r1 + turn1.cross(r1) + bend1),
                       end2 = turn2.cross(r2 + turn2.cross(r2) + bend2);
        const bool still_descends = c.normal.dot(Vector3d(end1 - end2)) < 0;
        c.gap_correction = still_descends ? (1 + bend_tolerance) * bend : -turned;
    }
    c.turning_speed = turned / problem.time_step;
}

// The values that all contacts of a pair of bodies share.
struct PairValues {
    int body1 = -1, body2 = -1;
    // Sum of both bodies' margins, and the radius as in `ContactConstraint` [m].
    double margin = 0, radius = 0;
    bool rolls1 = false, rolls2 = false;
    double both_radii = 0; // if both bodies are balls: the sum of their radii, otherwise 0 [m]
    // For each of the two bodies, whether the gaps belong to the orientation of this body at the
    // end of free flight (`ContactCandidates::turned_ahead`).
    bool turned1 = false, turned2 = false;
    Material material;

    bool is_of(const Contact& contact) const
    {
        return contact.body1 == body1 && contact.body2 == body2;
    }
};

// Sets `gap_correction` if two balls are apart and only pass by each other in free flight. If the
// distance of their centers went on falling as fast as at the start of the step, the balls would
// meet. But in a straight flight the distance falls more and more slowly.
// @param displacement  of ball 1 relative to ball 2 in the step [m]
void set_passing(const Vector3d& displacement, const PairValues& pair, ContactConstraint& c)
{
    const double apart = nearly_touching_gap * pair.radius;
    if (c.gap <= apart) return;
    const Vector3d d = (pair.both_radii + c.gap) * c.normal; // from center 2 to center 1
    const double length = displacement.norm();
    const double nearest = std::clamp(-d.dot(displacement) / (length * length), 0.0, 1.0);
    if ((d + nearest * displacement).norm() - pair.both_radii <= apart) return;
    const double end_gap = (d + displacement).norm() - pair.both_radii;
    c.gap_correction = end_gap - (c.gap + displacement.dot(c.normal));
}

// Decides which candidates become contacts of the problem.
struct Filter {
    const World& world;
    const ContactProblem& problem;
    const ContactCandidates& candidates;
    std::span<const Body> after_forces;

    PairValues pair_values(int body1, int body2) const
    {
        const double r1 = candidates.radii[body1], r2 = candidates.radii[body2];
        return {body1,
                body2,
                candidates.margins[body1] + candidates.margins[body2],
                r1 > 0 && r2 > 0 ? std::min(r1, r2) : std::max(r1, r2),
                rolls(world.bodies[body1]),
                rolls(world.bodies[body2]),
                sum_of_radii(world.bodies[body1], world.bodies[body2]),
                has_turned(body1),
                has_turned(body2),
                material_between(world.pair_laws, world.bodies, body1, body2)};
    }

    bool has_turned(int body) const
    {
        return !candidates.turned_ahead.empty() && candidates.turned_ahead[body];
    }

    // The part of v·n by rotation [m/s]. It includes the rotation of a body only if the contacts
    // belong to the orientation of this body at the end of free flight, so that the gap already
    // includes this rotation.
    double turning_speed(const Contact& contact, const PairValues& pair) const
    {
        const auto speed = [&](int i, bool turned) {
            const Body& body = problem.bodies[i];
            const Vector3d r = contact.point - body.position;
            return turned ? contact.normal.dot(body.angular_velocity.cross(r)) : 0.0;
        };
        return speed(contact.body1, pair.turned1) - speed(contact.body2, pair.turned2);
    }

    // Appends the contact to `taken` if it may close in this step.
    void take(const Contact& contact, const PairValues& pair,
              UninitializedVector<ContactConstraint>& taken) const
    {
        const Vector3d &n = contact.normal, &x = contact.point;
        const double free_speed = problem.velocity_between(after_forces, contact, x).dot(n);
        const double turning = pair.turned1 || pair.turned2 ? turning_speed(contact, pair) : 0;
        const double end_gap = contact.gap + problem.time_step * (free_speed - turning);
        if (end_gap >= pair.margin) return;

        ContactConstraint& c = taken.emplace_back(ContactConstraint{contact});
        if (pair.turned1 || pair.turned2) {
            c.turning_speed = std::min(turning, 0.0);
            c.gap_correction = -problem.time_step * turning;
        } else if (pair.rolls1 || pair.rolls2) {
            set_turning(problem, pair.rolls1, pair.rolls2, c);
        } else if (pair.both_radii > 0 && end_gap < 0) {
            const Vector3d v = after_forces[c.body1].velocity - after_forces[c.body2].velocity;
            set_passing(problem.time_step * v, pair, c);
        }
        c.free_speed = free_speed;
        c.force_speed = free_speed - problem.velocity_at(c, x).dot(n);
        c.restitution = pair.material.restitution;
        c.friction = pair.material.friction;
        c.radius = pair.radius;
    }

    // The contacts of the list that may close in this step. The contacts of a pair of bodies should
    // be neighbors in the list; otherwise the values of the pair are computed more than once.
    UninitializedVector<ContactConstraint> take(std::span<const Contact> contacts) const
    {
        UninitializedVector<ContactConstraint> taken;
        taken.reserve(contacts.size());
        PairValues pair;
        for (const Contact& contact : contacts) {
            if (!pair.is_of(contact)) pair = pair_values(contact.body1, contact.body2);
            take(contact, pair, taken);
        }
        return taken;
    }
};

void take_contacts(const Filter& filter, ContactProblem& problem)
{
    const std::vector<Contact>& contacts = filter.candidates.contacts;
    constexpr std::size_t grain_size = 256; // a thread takes at least this many contacts at a time
    problem.contacts = concatenate_ranges(
        *problem.pool, contacts.size(), grain_size, [&](std::size_t first, std::size_t last) {
            return filter.take(std::span(contacts).subspan(first, last - first));
        });
}

// Finds the islands, while other threads find the impulses from which the sweeps start (warm
// start). The methods `one_at_a_time` and `shock_propagation` use no such impulses. No method uses
// them if the optimization `warm_start` is off.
void find_islands(const World& world, const ContactCandidates& candidates, ContactProblem& problem)
{
    const std::vector<ContactPair> pairs = pairs_of(problem.contacts);
    const auto find = [&] {
        std::vector<ContactPair> by_height = pairs;
        sort_by_height(problem, by_height);
        problem.islands = islands_of(world, problem, by_height);
    };
    const ContactMethod method = problem.settings.contact_method;
    const bool is_iterative =
        method == ContactMethod::built_in || method == ContactMethod::simultaneous;
    if (!is_iterative || !problem.settings.optimisations.warm_start) return find();

    constexpr std::size_t grain_size = 128; // a thread takes at least this many pairs at a time
    std::atomic<std::uint64_t> started = 0;
    problem.pool->for_each_range_beside(
        find, pairs.size(), grain_size, [&](std::size_t first, std::size_t last) {
            started += start_warm(world.memory.warm_contacts, candidates.poses, problem.time_step,
                                  std::span(pairs).subspan(first, last - first), problem.contacts);
        });
    problem.counters->warm_starts += started;
}

// Computes the impulse matrices of the contacts, while another thread splits the island into
// blocks.
void prepare(ContactProblem& problem, Island& island)
{
    constexpr std::size_t grain_size = 64; // a thread takes at least this many pairs at a time
    const std::span<const ContactPair> pairs = island.pairs;
    std::vector<ContactPair> replaced; // the old `island.pairs`, to which the span `pairs` points
    problem.pool->for_each_range_beside(
        [&] { replaced = split_into_blocks(problem, island); }, pairs.size(), grain_size,
        [&](std::size_t first, std::size_t last) {
            for (const ContactPair& pair : pairs.subspan(first, last - first))
                for (int i = pair.first; i < pair.last; ++i)
                    problem.set_impulse_matrix(problem.contacts[i]);
        });
}

} // namespace

Body with_forces(Body body, const RigidState& start, const RigidState& flown)
{
    if (body.is_static()) return body;
    const Vector3d dL = flown.angular_momentum - start.angular_momentum;
    body.velocity += flown.velocity - start.velocity;
    body.angular_momentum += dL;
    body.angular_velocity += body.inverse_inertia * dL;
    return body;
}

ContactProblem make_problem(World& world, std::span<const RigidState> flown,
                            const ContactCandidates& candidates, double time_step, ThreadPool& pool)
{
    ContactProblem problem;
    problem.time_step = time_step;
    problem.settings = world.settings;
    problem.optimised = world.settings.uses_optimised_formulas();
    problem.counters = &world.counters;
    problem.pool = &pool;
    UninitializedVector<Body> after_forces; // one for each body; set only for those with contacts
    take_bodies(world, flown, candidates.contacts, problem, after_forces);
    take_contacts({world, problem, candidates, after_forces}, problem);
    find_islands(world, candidates, problem);
    for (Island& island : problem.islands)
        prepare(problem, island);
    return problem;
}

} // namespace rigor
