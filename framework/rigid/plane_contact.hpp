// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/narrow_phase.hpp"

namespace rigor {

/// Appends where a shape is nearer to a plane than `reach`, exactly: the vertices of a box, of a mesh
/// at most eight; the ends of a capsule; the lowest point of an ellipsoid; of a rim (cylinder, cone) or
/// ring (torus) the lowest point and eight fixed ones.
void touch_plane(const Shape& shape, const Pose& pose, const Pose& plane, double reach,
                 std::vector<Touch>& touches);

} // namespace rigor
