// SPDX-License-Identifier: MIT
// From a scene and its recorded states to pictures.
#pragma once

#include "render/picture.hpp"
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
class Stage {
public:
    /// @throws InputError if scene and record have not the same bodies
    Stage(const Scene& scene, const std::vector<RecordedBody>& bodies, const Overlays& overlays);

    Picture picture(const Frame& frame) const;

    /// Two runs of the scene at one moment in one picture: `frame` as usual, of `other` the bodies
    /// that lie apart as ghosts, and a line from center to center. The legend names both.
    Picture comparison(const Frame& frame, const Frame& other, const std::string& name,
                       const std::string& other_name) const;

private:
    struct Actor {
        std::string name;
        bool is_static = false;
        std::vector<Part> parts;                     // about the center of mass
        std::vector<int> models;                     // of each part; -1: a box, a ball, a plane
        Matrix3d inverse_inertia = Matrix3d::Zero(); // I_body⁻¹ [1/(kg m²)]
        double mass = 0, mean_inertia = 0;           // [kg], [kg m²]
        double radius = 0;                           // around the center of mass [m]
        Vector4f color;
    };

    /// What the colors of solids mean in a picture.
    struct Colors {
        SolidColors kind = SolidColors::color;
        std::array<double, 2> range = {0, 1};
    };

    void add_actor(const BodyDescription& body, const RecordedBody& recorded);
    int model_of(const Shape& shape);
    Picture empty_picture(const Frame& frame) const;
    void add_body(Picture& picture, const Actor& actor, const RigidState& state, bool ghost) const;

    // stage_solids.cpp
    void add_solids();
    Colors solid_colors(const std::vector<std::vector<float>>& values) const;
    void draw_solids(Picture& picture, const Frame& frame) const;
    void add_color_scale(Picture& picture, const Colors& colors) const;
    bool lies_apart(std::size_t solid, const SolidFrame& frame, const SolidFrame& other) const;
    void add_ghost(Picture& picture, const SolidFrame& solid) const;

    // stage_overlays.cpp
    void add_arrows(Picture& picture, const Actor& actor, const RigidState& state) const;
    void add_contacts(Picture& picture, const Frame& frame) const;
    void add_springs(Picture& picture, const Frame& frame) const;
    void add_title(Picture& picture, const Frame& frame) const;
    void add_legend(Picture& picture) const;
    void add_names(Picture& picture, const Frame& frame) const;

    Scene scene_;
    Overlays overlays_;
    std::vector<Actor> actors_;
    std::vector<Vector4f> solid_colors_;      // of each deformable solid
    std::vector<double> solid_radii_;         // around the middle of each, at first [m]
    std::map<SurfaceKey, int> model_numbers_; // among the picture's models
    Picture start_;           // camera and, where the scene has no plane, lines to see motion by
    float thickness_ = 0.01F; // of a rod [m]
};

/// Whether a body is drawn there at all: what flies off is left alone.
bool in_sight(const Vector3d& position);

} // namespace rigor
