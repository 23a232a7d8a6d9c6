// SPDX-License-Identifier: MIT
// Looks for contacts that a step has missed. The search for contacts covers the motion of free
// flight and, around it, a margin for each body (contact_candidates.hpp). So only a body that ends
// farther from its free flight than its margin can meet a body that the search left out. The swept
// bounds of each such body are compared with those of the bodies near it, and where these overlap,
// the contacts of the two bodies are tested. A body that turns far may also pass through a contact
// that was found; its center is then on the other side. If few bodies move, the code also looks for
// overlaps of bodies that flew freely because their contact was not expected to close.
#include "rigid/step/missed_contacts.hpp"

#include "geometry/shapes/shape_bounds.hpp"
#include "rigid/bodies/orientation.hpp"
#include "rigid/detection/overlap_depth.hpp"
#include "rigid/detection/travel.hpp"
#include "rigid/motion/free_flight.hpp"
#include "rigid/step/impact.hpp"
#include "rigid/step/substeps/divisions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rigor {

namespace {

bool has(const Island& island, int body)
{
    return std::binary_search(island.bodies.begin(), island.bodies.end(), body);
}

// The motion of a body in a step.
struct Path {
    Vector3d X = Vector3d::Zero();     // center of mass at the start of the step [m]
    Vector3d moved = Vector3d::Zero(); // displacement of the center [m]
    double angle = 0;                  // angle by which the body turns [rad]
    double radius = 0;                 // largest distance from X to a point of the body [m]
    Bounds swept;                      // bounds of the body over the step

    // How far rotation may move a point of the body [m]: by at most 2 radii. (The radius of a plane
    // is infinite.)
    double turning_path() const { return angle == 0 ? 0 : radius * std::min(angle, 2.0); }

    // A bound of how far a point of the body moves [m].
    double length() const { return moved.norm() + turning_path(); }

    // A lower bound of the distance by which the body recedes along n from another body [m]. `gap`
    // is the distance of the two bodies at the contact point x. If the bound is negative, the body
    // may approach. However the body turns, its points stay within its radius about its center.
    double recedes(const Vector3d& x, const Vector3d& n, double gap) const
    {
        const double height = n.dot(X - x) - gap; // least height of the center above the surface
        return n.dot(moved) - std::min(std::max(radius - height, 0.0), radius * angle);
    }
};

class MissedContacts {
public:
    MissedContacts(const World& world, const ContactProblem& problem,
                   const ContactCandidates& candidates, const std::vector<RigidState>& flown,
                   const std::vector<RigidState>& states)
        : world_(world), problem_(problem), candidates_(candidates), flown_(flown), states_(states),
          overlap_(world, states)
    {
    }

    bool any()
    {
        if (std::any_of(candidates_.contacts.begin(), candidates_.contacts.end(),
                        [&](const Contact& c) { return is_passed(c); }))
            return true;
        if (is_small(world_) &&
            std::any_of(candidates_.contacts.begin(), candidates_.contacts.end(),
                        [&](const Contact& c) { return is_turned_in(c); }))
            return true;
        const std::vector<int> far = far_bodies();
        if (far.empty()) return false;
        find_paths();
        const std::vector<BodyPair> pairs = pairs_near(far);
        return std::any_of(pairs.begin(), pairs.end(), [&](const BodyPair& pair) {
            const auto [i, j] = pair;
            return paths_[i].swept.overlaps(paths_[j].swept) && !never_collide(world_, i, j) &&
                   would_meet(i, j) && !(is_crowded(i, j) && stays_apart(i, j));
        });
    }

private:
    Vector3d moved(int i) const { return states_[i].position - candidates_.poses[i].X; }

    // Whether a body turns so far that the paths of its points are not nearly straight.
    bool turns_far(int i) const
    {
        constexpr double far = 0.5; // [rad]; a chord is then 1 % shorter than its arc
        const RigidBody& body = world_.bodies[i];
        return !body.is_still() && !body.is_ball() && angle_of(i) > far;
    }

    // The angle by which a moving body turns [rad]: the larger of the angles that follow from its
    // angular velocities at the start and at the end.
    double angle_of(int i) const
    {
        const RigidBody& body = world_.bodies[i];
        return std::max(angle_turned(world_, body, body.state, problem_.time_step),
                        angle_turned(world_, body, states_[i], problem_.time_step));
    }

    // Whether one of the two bodies of a contact turns far, and the center of a body comes to the
    // other side of the contact.
    bool is_passed(const Contact& c) const
    {
        const double n_moved = c.normal.dot(moved(c.body1) - moved(c.body2));
        if (n_moved >= 0) return false;
        // @param height  height of the center above the contact point, along the normal [m]
        const auto passes = [&](int i, double height) {
            return height > 0 && height + c.gap / 2 + n_moved < 0 && !world_.bodies[i].is_static;
        };
        return (passes(c.body1, c.normal.dot(candidates_.poses[c.body1].X - c.point)) ||
                passes(c.body2, c.normal.dot(c.point - candidates_.poses[c.body2].X))) &&
               (turns_far(c.body1) || turns_far(c.body2));
    }

    // Whether a body that flies freely turns into another one although the contact was not expected
    // to close, because its points move along curves. The two bodies are tested in the middle and
    // at the end of the step.
    bool is_turned_in(const Contact& c)
    {
        double size = 0, bend = 0; // how far a point leaves its tangent, at most [m]
        for (const int i : {c.body1, c.body2}) {
            const RigidBody& body = world_.bodies[i];
            if (body.changes_place() && !problem_.bodies[i].angular_velocity.isZero(0))
                return false; // a driven body that turns is not in free flight
            if (body.is_static) continue;
            size += candidates_.radii[i];
            if (!body.is_ball()) bend += std::pow(angle_of(i), 2) / 2 * candidates_.radii[i];
        }
        const double least = nearly_touching_gap * size;
        if (c.gap <= least || c.gap > bend || is_in_island(c.body1) || is_in_island(c.body2))
            return false;
        std::vector<RigidState> middle = states_;
        Counters uncounted;
        const double half = problem_.time_step / 2;
        for (const int i : {c.body1, c.body2}) {
            const RigidBody& body = world_.bodies[i];
            if (body.changes_place())
                middle[i] = driven_state(*body.drive, world_.time + half);
            else if (!body.is_static)
                middle[i] = fly(world_.settings, body, body.state, half, uncounted);
        }
        return overlap_.depth(c.body1, c.body2) > least ||
               Overlap(world_, middle).depth(c.body1, c.body2) > least;
    }

    bool is_in_island(int i) const
    {
        return std::any_of(problem_.islands.begin(), problem_.islands.end(),
                           [&](const Island& island) { return has(island, i); });
    }

    // The bodies that end farther from their free flight than their margin.
    std::vector<int> far_bodies() const
    {
        std::vector<int> far;
        for (int i = 0; i < static_cast<int>(states_.size()); ++i) {
            const auto is_beyond_margin = [&](double radius) {
                const Travel missed = travel_of(flown_[i], states_[i], 0, radius, 0);
                return path_between(missed, {}) > candidates_.margins[i];
            };
            if (!is_beyond_margin(candidates_.radii[i])) continue; // true for most bodies
            const RigidBody& body = world_.bodies[i];
            if (!body.is_static && (!body.is_ball() || is_beyond_margin(0))) far.push_back(i);
        }
        return far;
    }

    void find_paths()
    {
        paths_.reserve(world_.bodies.size());
        for (int i = 0; i < static_cast<int>(world_.bodies.size()); ++i)
            paths_.push_back(path_of(i));
    }

    // All pairs of a body of the list and another body whose swept bounds may overlap. If all
    // bodies stay within their fat bounds, the pair cache has these pairs.
    std::vector<BodyPair> pairs_near(const std::vector<int>& far) const
    {
        const int n = static_cast<int>(paths_.size());
        std::vector<char> is_far(n, false);
        for (int i : far)
            is_far[i] = true;
        std::vector<BodyPair> pairs;
        const PairCache& cache = world_.memory.pairs;
        if (covers_paths(cache)) {
            std::copy_if(
                cache.pairs.begin(), cache.pairs.end(), std::back_inserter(pairs),
                [&](const BodyPair& pair) { return is_far[pair.body1] || is_far[pair.body2]; });
            return pairs;
        }
        for (int i : far)
            for (int j = 0; j < n; ++j)
                if (j != i && !(j < i && is_far[j]))
                    pairs.push_back({std::min(i, j), std::max(i, j)});
        return pairs;
    }

    bool covers_paths(const PairCache& cache) const
    {
        return std::equal(
            paths_.begin(), paths_.end(), cache.fat_bounds.begin(), cache.fat_bounds.end(),
            [](const Path& path, const Bounds& fat) { return fat.contains(path.swept); });
    }

    Path path_of(int i) const
    {
        const RigidBody& body = world_.bodies[i];
        Path path;
        path.X = body.state.position;
        for (const Part& part : body.parts)
            path.swept.include(bounds_of(part.shape, part_pose(candidates_.poses[i], part)));
        if (body.is_still()) return path;
        path.moved = moved(i);
        if (!body.is_ball()) path.angle = angle_of(i);
        path.radius = body.is_static // driven
                          ? (path.swept.high - path.X).cwiseMax(path.X - path.swept.low).norm()
                          : candidates_.radii[i];
        // Until a body is hit, it moves along its free flight, so the swept bounds also cover this
        // path.
        const Bounds start = path.swept;
        for (const Vector3d& d : {path.moved, Vector3d(flown_[i].position - path.X)})
            path.swept.include({start.low + d, start.high + d});
        path.swept.grow(path.turning_path());
        return path;
    }

    // Whether a contact of bodies i < j that is not in the problem may close.
    bool would_meet(int i, int j) const
    {
        const Path &path1 = paths_[i], &path2 = paths_[j];
        const double reach = path1.length() + path2.length();
        std::vector<Contact> contacts;
        find_contacts(world_, candidates_.poses, i, j, reach, contacts);
        return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& c) {
            const double end_gap = c.gap + path1.recedes(c.point, c.normal, c.gap) +
                                   path2.recedes(c.point, -c.normal, c.gap);
            return end_gap < 0 && !is_in_problem({i, j}, c.normal);
        });
    }

    // Whether one of the two bodies belongs to an island that is too large for a step in halves
    // whenever `would_meet` is true, since it is often true for bodies that do not meet.
    bool is_crowded(int i, int j) const
    {
        return std::any_of(
            problem_.islands.begin(), problem_.islands.end(), [&](const Island& island) {
                return island.bodies.size() > most_refined && (has(island, i) || has(island, j));
            });
    }

    // Whether the two bodies do not overlap at the end of the step, and move too little to have
    // passed through each other.
    bool stays_apart(int i, int j)
    {
        // The longest path, as a fraction of the thinner body's thickness. A body that passes
        // through another one moves by more than its thickness.
        constexpr double short_path = 0.5;
        const double thinner = std::min(thickness(world_.bodies[i]), thickness(world_.bodies[j]));
        return paths_[i].length() + paths_[j].length() < short_path * thinner &&
               overlap_.depth(i, j) == 0;
    }

    // Whether the problem has a contact of the pair on the same side, which keeps the bodies apart
    // on this side. (A body that is a whole room also has walls on other sides.) A contact of two
    // balls with `gap_correction` does not count, because it is correct only if the balls fly past
    // each other as in free flight.
    bool is_in_problem(const BodyPair& pair, const Vector3d& normal) const
    {
        const bool are_balls =
            world_.bodies[pair.body1].is_ball() && world_.bodies[pair.body2].is_ball();
        const auto pair_of = [](const ContactConstraint& c) { return BodyPair{c.body1, c.body2}; };
        const auto is_before = [&](const ContactConstraint& c, const BodyPair& other) {
            return pair_of(c) < other;
        };
        const UninitializedVector<ContactConstraint>& contacts = problem_.contacts;
        for (auto c = std::lower_bound(contacts.begin(), contacts.end(), pair, is_before);
             c != contacts.end() && pair_of(*c) == pair; ++c)
            if (are_on_one_side(c->normal, normal) && !(are_balls && c->gap_correction > 0))
                return true;
        return false;
    }

    const World& world_;
    const ContactProblem& problem_;
    const ContactCandidates& candidates_;
    const std::vector<RigidState>&flown_, &states_;
    Overlap overlap_;         // at the end of the step
    std::vector<Path> paths_; // one for each body
};

} // namespace

bool has_missed_contact(const World& world, const ContactProblem& problem,
                        const ContactCandidates& candidates, const std::vector<RigidState>& flown,
                        const std::vector<RigidState>& states)
{
    return MissedContacts(world, problem, candidates, flown, states).any();
}

} // namespace rigor
