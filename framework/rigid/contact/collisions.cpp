// SPDX-License-Identifier: MIT
// The collision stage (Guendelman, Bridson and Fedkiw 2003). For each pair of bodies it collects
// the points that would penetrate, lets the formula `deepest_approaching_point` choose one of them,
// averages this point with the points that are about as deep, and applies the impulse of the
// formula `collision_impulse` at their mean.
#include "rigid/contact/collisions.hpp"

#include "formulas/collision.hpp"
#include "geometry/convex/extreme_points.hpp"
#include "rigid/bodies/inlined_product.hpp"
#include "rigid/contact/driven_bodies.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace rigor {

namespace {

// The largest number of sweeps over the pairs of an island, and the largest number of bounces of
// one pair in a sweep. With larger numbers, an impact with restitution would pass through more
// bodies, but the stage would take more time. Contacts that still approach are left to the contact
// stage.
constexpr int most_sweeps = 10;
constexpr int most_rounds = 4;
// Two points are averaged if the smaller of their depths is at least this fraction of the larger
// one. With a larger value, a box that is tilted very little would bounce on one corner. With a
// smaller value, a clearly tilted box would bounce as if it were level.
constexpr double equally_deep = 0.9;
constexpr double same_normal = 1e-9; // normals n, n' count as equal if 1 - n·n' is smaller
// At the front of a rolling wheel, rotation moves a point towards the ground (`turning_speed`, a
// part of v·n), but the point does not reach the ground in this step. `only_turns` leaves out such
// a contact only if the rest of v·n, which is v·n - turning_speed, is above
// -negligible_share |turning_speed|: the bodies separate, or they approach more slowly than this.
// The share is not 0, because `turning_speed` is exact only to first order in the rotation during
// the step.
constexpr double negligible_share = 0.1;
// `only_turns` ignores an approach by v·n - turning_speed that is slower than half this share of
// |turning_speed|. This limit is far above the rounding error of a speed and far below any speed
// that matters.
constexpr double rounding_share = negligible_share * 1e-9;

// The points of a pair at which a collision may happen now.
struct Candidates {
    std::vector<ContactPoint> points;
    std::vector<int> contacts;   // the index of each point in `ContactProblem::contacts`
    bool any_approaches = false; // whether v·n < 0 at one of the points
};

// Whether a contact approaches only by a rotation that does not close its gap, as at the front of a
// rolling wheel. Such a contact is left to the contact stage. `others` is v·n without the part by
// this rotation. All of these conditions have to hold:
// 1. Rotation moves the point towards the other body.
// 2. `others` is above -negligible_share |turning_speed|: no approach, or a slow one.
// 3. After a bounce with the speed `others`, the forces would close the contact again within this
//    step: 2 others ≥ force_speed (see `is_over_in_the_step`). This is so where gravity alone
//    causes `others`. Or `others` is only a rounding error (`rounding_share`).
bool only_turns(const ContactConstraint& c, double v_n)
{
    const double others = v_n - c.turning_speed;
    return c.turning_speed < 0 && others > negligible_share * c.turning_speed &&
           2 * others >= std::min(c.force_speed, rounding_share * c.turning_speed);
}

// Whether a bounce would be over within the step. After it, the contact opens with a speed of at
// most -v_n, while the forces accelerate it by force_speed/h (h: time step). So it closes again
// after at most 2 v_n/force_speed time steps.
bool is_over_in_the_step(const ContactConstraint& c, double v_n)
{
    return v_n < 0 && 2 * v_n > c.force_speed;
}

// The change of v·n at the contact c by the forces of this step, if the contacts on which its
// bodies rest take the part of the forces that they can take [m/s]. Each body is looked at by
// itself, as if the bodies on which it rests could not move.
double unsupported_force_speed(const ContactProblem& problem, const Island& island,
                               const ContactConstraint& c)
{
    // The impulses of the contacts are found by sweeps; with more of them, bodies that rest on many
    // points have less of the forces left over.
    constexpr int sweeps = 10;
    double speed = c.force_speed;
    for (const int i : {c.body1, c.body2}) {
        if (problem.bodies[i].is_static()) continue;
        Body change = problem.bodies[i]; // the change of its velocities by these impulses
        change.velocity = change.angular_velocity = change.angular_momentum = Vector3d::Zero();
        // The part of v·n that the change gives a contact of this body.
        const auto part = [&](const ContactConstraint& at) -> double {
            const Vector3d v =
                change.velocity + change.angular_velocity.cross(at.point - change.position);
            return (at.body1 == i ? 1 : -1) * v.dot(at.normal);
        };
        for (int sweep = 0; sweep < sweeps; ++sweep)
            for (const ContactPair& pair : island.pairs)
                for (int k = pair.first; k < pair.last; ++k) {
                    const ContactConstraint& o = problem.contacts[k];
                    if (o.body1 != i && o.body2 != i) break; // a pair of other bodies
                    const double v_n = problem.velocity_at(o, o.point).dot(o.normal);
                    const bool holds = problem.predicted_gap(o, v_n + o.force_speed) < 0 &&
                                       2 * std::abs(v_n) < -o.force_speed;
                    const double opens = o.force_speed + part(o);
                    if (!holds || !(opens < 0)) continue;
                    const Vector3d j = -opens / o.normal_K * o.normal;
                    problem.push(change, o.point, o.body1 == i ? j : Vector3d(-j));
                }
        speed += part(c);
    }
    return speed;
}

// Whether only the forces of this step would close a contact, and do not close it because the
// bodies rest on other contacts. A ball that slides over the joint between two tiles comes near the
// edge of the second one. It would hit this edge if the first tile did not hold it.
bool closes_by_forces_alone(const ContactProblem& problem, const Island& island,
                            const ContactConstraint& c, double v_n)
{
    if (v_n >= 0 || problem.predicted_gap(c, v_n) < 0) return false;
    return !is_pile(island) &&
           problem.predicted_gap(c, v_n + unsupported_force_speed(problem, island, c)) >= 0;
}

void collect(const ContactProblem& problem, const Island& island, const ContactPair& pair,
             Candidates& candidates)
{
    candidates.points.clear();
    candidates.contacts.clear();
    candidates.any_approaches = false;
    for (int i = pair.first; i < pair.last; ++i) {
        const ContactConstraint& c = problem.contacts[i];
        if (c.restitution == 0 && problem.settings.contact_method == ContactMethod::simultaneous)
            continue;
        const Vector3d v = problem.velocity_at(c, c.point);
        const double v_n = v.dot(c.normal);
        const double depth = -problem.predicted_gap(c, v_n + c.force_speed);
        if (!(depth > 0)) continue;
        if (is_over_in_the_step(c, v_n)) continue;
        if (closes_by_forces_alone(problem, island, c, v_n)) continue;
        if (only_turns(c, v_n)) continue;
        // At a point that has bounced with ε = 0, v_n is only a rounding error. Without this test,
        // `deepest_approaching_point` could choose this point again and again, and the points of
        // the pair that really hit would never bounce.
        if (v_n < 0 && -v_n <= problem.rounding_speed(c)) continue;
        candidates.points.push_back({c.point, c.normal, depth, v});
        candidates.contacts.push_back(i);
        candidates.any_approaches |= v_n < 0;
    }
}

// The index that `deepest_approaching_point` returned. Throws std::out_of_range if it is not valid.
int checked(int index, std::size_t size)
{
    if (index < 0 || static_cast<std::size_t>(index) >= size)
        throw std::out_of_range("deepest_approaching_point returned " + std::to_string(index) +
                                " for " + std::to_string(size) + " contacts");
    return index;
}

// The impulse j, scaled down if it would increase the energy, ΔE = j·v + ½ jᵀKj > 0. With
// restitution and friction together, Newton's law of restitution may increase the energy (Kane and
// Levinson 1985, "Dynamics: theory and applications").
Vector3d without_energy_gain(const Matrix3d& K, const Vector3d& v, const Vector3d& j)
{
    const double work = j.dot(v), stored = j.dot(optimised::product(K, j)) / 2;
    constexpr double rounding = 1e-12; // relative to ½ jᵀKj: some thousand rounding errors
    if (!(work + stored > rounding * stored)) return j; // also if NaN, which is reported later
    return std::max(0.0, -work / stored) * j;
}

// Leaves only the corners of the convex hull of the points. Other points, such as those of a mesh
// with vertices on an edge, would move the mean of the points away from the middle.
void keep_corners(std::vector<Vector3d>& points, std::vector<int>& contacts, const Vector3d& n)
{
    if (points.size() < 3) return;
    std::size_t kept = 0;
    for (const int i : extreme_points(points, n)) { // ascending
        points[kept] = points[i];
        contacts[kept++] = contacts[i];
    }
    points.resize(kept);
    contacts.resize(kept);
}

// Lets the pair bounce once: one impulse acts at the mean of the deepest approaching point and the
// points that are about as deep (`equally_deep`).
// @return whether the pair bounced
bool bounce(ContactProblem& problem, const Candidates& candidates)
{
    const std::optional<int> deepest = deepest_approaching_point(candidates.points);
    if (!deepest) return false;
    const ContactPoint& chosen = candidates.points[checked(*deepest, candidates.points.size())];

    std::vector<int> together;
    std::vector<Vector3d> points;
    for (std::size_t k = 0; k < candidates.points.size(); ++k) {
        const ContactPoint& p = candidates.points[k];
        const bool is_alike =
            p.depth >= equally_deep * chosen.depth && p.depth * equally_deep <= chosen.depth &&
            p.normal.dot(chosen.normal) > 1 - same_normal && p.relative_velocity.dot(p.normal) < 0;
        if (!is_alike && &p != &chosen) continue;
        together.push_back(candidates.contacts[k]);
        points.push_back(p.point);
    }
    keep_corners(points, together, chosen.normal);
    const Vector3d sum = std::accumulate(points.begin(), points.end(), Vector3d(Vector3d::Zero()));
    const double count = static_cast<double>(together.size());
    const ContactConstraint& c = problem.contacts[together.front()];
    const bool is_alone = together.size() == 1;
    const Vector3d x = is_alone ? points.front() : Vector3d(sum / count);
    const Matrix3d K = is_alone ? c.K : problem.impulse_matrix_at(c, x);
    const Vector3d v = is_alone ? chosen.relative_velocity : problem.velocity_at(c, x);
    Vector3d j = collision_impulse(K, v, chosen.normal, c.restitution, c.friction);
    if (c.restitution > 0 && c.friction > 0) j = without_energy_gain(K, v, j);
    if (j.isZero(0)) return false;

    problem.apply(c, x, j);
    ++problem.counters->collision_impulses;
    for (int i : together)
        problem.contacts[i].collision_impulse += j / count;
    return true;
}

void resolve(ContactProblem& problem, const Island& island)
{
    Candidates candidates;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        bool bounced = false;
        for (const ContactPair& pair : island.pairs)
            for (int round = 0; round < most_rounds; ++round) {
                collect(problem, island, pair, candidates);
                if (!candidates.any_approaches || !bounce(problem, candidates)) break;
                bounced = true;
            }
        if (!bounced) return;
    }
}

} // namespace

void process_collisions(ContactProblem& problem)
{
    for (const Island& island : problem.islands) {
        if (island.frame.is_world()) {
            resolve(problem, island);
            continue;
        }
        set_velocities_at_start(problem, island);
        resolve(problem, island);
        reset_velocities(problem, island);
    }
}

} // namespace rigor
