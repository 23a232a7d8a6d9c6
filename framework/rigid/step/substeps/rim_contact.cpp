// SPDX-License-Identifier: MIT
// Looks at the direction from the axis of a cylinder, cone or torus to its lowest point, which is
// -d with d = n - (n·a) a, where n is the normal of the contact and a the axis. The direction of d
// says where on the rim the contact is, and its length is the sine of the tilt.
#include "rigid/step/substeps/rim_contact.hpp"

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/orientation.hpp"

#include <algorithm>

namespace rigor {

namespace {

// The contact may run round the rim by this angle in a step, and the sine of the tilt may fall to
// this share. Chosen by trial: a can that rocks keeps 99 % of its energy (tests/classics).
constexpr double most_angle = 0.05; // [rad]
constexpr double least_share = 0.8;
// A body with a smaller tilt counts as flat [rad].
constexpr double flat = 1e-4;

bool has_rim(const Part& part)
{
    return std::holds_alternative<Cylinder>(part.shape) ||
           std::holds_alternative<Cone>(part.shape) || std::holds_alternative<Torus>(part.shape);
}

bool is_long_way(const Vector3d& first, const Vector3d& last)
{
    const double tilt = first.norm();
    if (std::max(tilt, last.norm()) < flat) return false;
    return last.norm() < least_share * tilt || first.dot(last) < 0 ||
           first.cross(last).norm() > most_angle * tilt * last.norm();
}

} // namespace

bool runs_round_rim(const World& world, const ContactProblem& problem,
                    const std::vector<RigidState>& states, const ContactPair& pair)
{
    const auto runs = [&](int i, const Vector3d& n) {
        const RigidBody& body = world.bodies[i];
        return !body.is_static &&
               std::any_of(body.parts.begin(), body.parts.end(), [&](const Part& part) {
                   if (!has_rim(part)) return false;
                   const auto d = [&](const RigidState& state) -> Vector3d {
                       const Vector3d a = part_pose(pose_of(state), part).R.col(1);
                       return n - n.dot(a) * a;
                   };
                   return is_long_way(d(body.state), d(states[i]));
               });
    };
    return std::any_of(
        problem.contacts.begin() + pair.first, problem.contacts.begin() + pair.last,
        [&](const ContactConstraint& c) {
            const bool has_impulse = !c.collision_impulse.isZero(0) || !c.contact_impulse.isZero(0);
            return has_impulse && (runs(c.body1, c.normal) || runs(c.body2, c.normal));
        });
}

} // namespace rigor
