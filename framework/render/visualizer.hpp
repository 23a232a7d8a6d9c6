// SPDX-License-Identifier: MIT
// From a scene and its recorded states to pictures.
#pragma once

#include "render/drawn_body.hpp"
#include "render/picture.hpp"
#include "render/solid_visualizer.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// What tells one surface from another: a mesh, or a kind of shape and its sizes.
using SurfaceKey = std::pair<const SolidMesh*, std::array<double, 3>>;

/// What stays the same from frame to frame of a run. Colors are chosen so that neighbors differ
/// also for the color-blind.
class Visualizer {
public:
    /// @throws InputError if scene and record have not the same bodies
    Visualizer(const Scene& scene, const std::vector<RecordedBody>& bodies,
               const Overlays& overlays);

    Picture picture(const Frame& frame) const;

    /// Two runs of the scene at one moment in one picture: `frame` as usual, of `other` the bodies
    /// that lie apart as ghosts, and a line from center to center. The legend names both.
    Picture comparison(const Frame& frame, const Frame& other, const std::string& name,
                       const std::string& other_name) const;

private:
    void add_body(const BodyDescription& body, const RecordedBody& recorded);
    int model_of(const Shape& shape);
    Picture empty_picture(const Frame& frame) const;
    void draw_body(Picture& picture, const DrawnBody& body, const RigidState& state,
                   bool ghost) const;

    Scene scene_;
    Overlays overlays_;
    std::vector<DrawnBody> bodies_;
    SolidVisualizer solids_;
    std::map<SurfaceKey, int> model_numbers_; // among the picture's models
    Picture start_;           // camera and, where the scene has no plane, lines to see motion by
    float thickness_ = 0.01F; // radius of a rod [m]
};

} // namespace rigor
