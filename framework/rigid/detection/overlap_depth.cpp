// SPDX-License-Identifier: MIT
#include "rigid/detection/overlap_depth.hpp"

#include "geometry/bounds/bounds.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "rigid/detection/narrow_phase.hpp"

#include <algorithm>
#include <limits>

namespace rigor {

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

double Overlap::depth(int i, int j)
{
    poses_.resize(states_.size());
    for (int body : {i, j})
        poses_[body] = pose_of(states_[body]);
    std::vector<Contact> contacts;
    find_contacts(world_, poses_, i, j, 0, contacts);
    double depth = 0;
    for (const Contact& c : contacts)
        depth = std::max(depth, -c.gap);
    return depth;
}

} // namespace rigor
