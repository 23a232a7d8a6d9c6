// SPDX-License-Identifier: MIT
// Makes pictures from a scene and its recorded states.
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

/// Identifies a surface: a mesh, or a kind of shape with its sizes.
using SurfaceKey = std::pair<const SolidMesh*, std::array<double, 3>>;

/// Draws the frames of a run. It keeps what stays the same from frame to frame. Bodies that follow
/// each other in the scene have colors that the color-blind can tell apart too.
class Visualizer {
public:
    /// @throws InputError if scene and record do not have the same number of bodies
    Visualizer(const Scene& scene, const std::vector<RecordedBody>& bodies,
               const Overlays& overlays);

    Picture picture(const Frame& frame) const;

    /// Two runs of the scene at one time in one picture: `frame` as `picture` draws it, and as
    /// ghosts (translucent) the bodies and solids of `other` whose states visibly differ from those
    /// in `frame`. A line joins the two centers of such a body. The legend names both runs.
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
    std::map<SurfaceKey, int> model_numbers_; // indices in the picture's models
    // What every picture starts with: the camera, empty models, and a grid as ground if the scene
    // has no plane.
    Picture start_;
    float thickness_ = 0.01F; // radius of a rod [m]
};

} // namespace rigor
