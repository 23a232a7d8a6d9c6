// SPDX-License-Identifier: MIT
// A ground in two pieces: one where shadows can fall, and the rest, which needs no shadow map.
#pragma once

#include "render/gl/shaders/program.hpp"
#include "render/picture.hpp"

#include <vector>

namespace rigor {

using Spot = Eigen::Vector2f; // a point of a ground: its x and z, relative to the middle [m]

struct GroundPieces {
    std::vector<Spot> shaded, plain; // triangles, counter-clockwise seen from above
};

/// @param origin  the middle of the square of ground that is drawn
/// @param half    half of its side [m]
GroundPieces ground_pieces(const Ground& ground, const Vector3f& origin, float half,
                           const View& view, bool shadows);

} // namespace rigor
