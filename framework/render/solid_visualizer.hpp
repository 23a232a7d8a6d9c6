// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture.hpp"
#include "scene/description/scene.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <array>
#include <limits>
#include <vector>

namespace rigor {

/// Draws the deformable solids of a scene, in their own colors or colored by stress or strain.
class SolidVisualizer {
public:
    SolidVisualizer() = default;

    /// @param first_color  index of the first solid's color in the palette; a solid for which the
    ///                     scene gives a color has the color of the scene instead
    SolidVisualizer(const std::vector<SolidDescription>& solids, const Overlays& overlays,
                    std::size_t first_color);

    std::size_t count() const { return colors_.size(); }

    /// Half the diagonal of the bounding box of a solid's mesh at rest [m].
    double radius(std::size_t solid) const { return radii_[solid]; }

    void draw(Picture& picture, const Frame& frame) const;

    /// Whether two states of a solid look different.
    bool lies_apart(std::size_t solid, const SolidFrame& frame, const SolidFrame& other) const;

    void draw_ghost(Picture& picture, const SolidFrame& solid) const;

private:
    std::array<double, 2> color_range(const std::vector<std::vector<float>>& values) const;
    void add_color_scale(Picture& picture, const std::array<double, 2>& range) const;

    Overlays overlays_;
    std::vector<Vector4f> colors_;
    std::vector<double> radii_;   // [m]
    double stress_limit_ = never; // smallest yield stress or strength of all solids [Pa]
};

} // namespace rigor
