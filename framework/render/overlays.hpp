// SPDX-License-Identifier: MIT
// Adds to a picture what is drawn besides the bodies. `thickness` is about the radius of a rod [m].
#pragma once

#include "render/drawn_body.hpp"
#include "render/picture.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <string>
#include <vector>

namespace rigor {

/// The axes of a body, its angular velocity and its angular momentum, as `overlays` selects.
void add_arrows(Picture& picture, const DrawnBody& body, const RigidState& state,
                const Overlays& overlays, float thickness);

/// A dot at each contact, and an arrow for the impulse on body 1, or on body 2 if body 1 is static.
void add_contacts(Picture& picture, const Frame& frame, const std::vector<DrawnBody>& bodies,
                  float thickness);

/// Each spring as a coil with a fixed number of turns.
void add_springs(Picture& picture, const Frame& frame, const std::vector<DrawnBody>& bodies,
                 const std::vector<Spring>& springs, float thickness);

/// The name of the scene and the time [s].
void add_title(Picture& picture, const std::string& scene, double time);

/// A legend for the colors of arrows and dots.
void add_legend(Picture& picture, const Overlays& overlays);

/// The names of bodies and solids. A name is above its body or solid; a static body has it at its
/// center of mass. A body that consists of planes only has none.
void add_names(Picture& picture, const Frame& frame, const std::vector<DrawnBody>& bodies,
               const std::vector<SolidDescription>& solids, float thickness);

} // namespace rigor
