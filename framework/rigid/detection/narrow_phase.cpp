// SPDX-License-Identifier: MIT
// The narrow phase: finds the contacts of two bodies, part by part, and sorts them by height.
#include "rigid/detection/narrow_phase.hpp"

#include "geometry/shapes/shape_bounds.hpp"
#include "rigid/bodies/height_order.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "rigid/detection/look_ahead.hpp"
#include "rigid/detection/shape_contacts.hpp"
#include "rigid/detection/shapes/distance_field.hpp"

#include <algorithm>
#include <span>

namespace rigor {

namespace {

void sort_by_height(const Vector3d& gravity, std::span<Contact> contacts)
{
    const HeightOrder key_of(gravity, contacts,
                             [](const Contact& t) -> const Vector3d& { return t.point; });
    std::sort(contacts.begin(), contacts.end(), [&](const Contact& a, const Contact& b) {
        return key_of(a.point) < key_of(b.point);
    });
}

Vector3d velocity_of(const RigidBody& body)
{
    return body.is_still() ? Vector3d(0, 0, 0) : body.state.velocity;
}

// The name of the body to which the shape belongs.
const std::string& owner(const RigidBody& body1, const RigidBody& body2, const Shape* shape)
{
    for (const Part& part : body1.parts)
        if (&part.shape == shape) return body1.name;
    return body2.name;
}

} // namespace

void find_contacts(const World& world, const std::vector<Pose>& poses, int body1, int body2,
                   double reach, std::vector<Contact>& contacts)
{
    Counters counters;
    find_contacts(world, poses, body1, body2, reach, contacts, counters);
}

void find_contacts(const World& world, const std::vector<Pose>& poses, int body1, int body2,
                   double reach, std::vector<Contact>& contacts, Counters& counters,
                   double time_step)
{
    const RigidBody &first_body = world.bodies[body1], &second_body = world.bodies[body2];
    const MovingPair pair{first_body.is_still(), second_body.is_still(),
                          time_step * (velocity_of(first_body) - velocity_of(second_body))};
    const std::vector<Part>& parts1 = world.bodies[body1].parts;
    const std::vector<Part>& parts2 = world.bodies[body2].parts;
    const bool is_compound = parts1.size() * parts2.size() > 1;
    const std::size_t first = contacts.size();
    for (const Part& part1 : parts1) {
        const Pose pose1 = part_pose(poses[body1], part1);
        Bounds bounds1;
        if (is_compound) bounds1 = bounds_of(part1.shape, pose1);
        bounds1.grow(reach);
        for (const Part& part2 : parts2) {
            const Pose pose2 = part_pose(poses[body2], part2);
            if (is_compound && !bounds1.overlaps(bounds_of(part2.shape, pose2))) continue;
            try {
                const std::size_t first_of_parts = contacts.size();
                find_shape_contacts(part1.shape, pose1, part2.shape, pose2, pair.move, reach,
                                    counters, contacts);
                look_ahead(part1.shape, pose1, part2.shape, pose2, pair, reach, counters,
                           first_of_parts, contacts);
            } catch (const NonFiniteLevelSet& e) {
                throw NonFiniteState(owner(world.bodies[body1], world.bodies[body2], e.shape),
                                     std::string(e.quantity) + " of the level set", world.time);
            }
        }
    }
    const std::span<Contact> found = std::span(contacts).subspan(first);
    for (Contact& contact : found) {
        contact.body1 = body1;
        contact.body2 = body2;
    }
    if (found.size() > 1) sort_by_height(world.settings.gravity, found);
}

} // namespace rigor
