// SPDX-License-Identifier: MIT
// Draws deformable solids. With a color scale, the stress or plastic strain of the elements is
// averaged at the nodes and shown by color. The scene's file can give the range of the scale.
// Otherwise a scale of stress ends at the smallest yield stress or strength of the solids; if none
// has one, and for strain, the scale ends at the largest value of the frame, rounded up.
#include "render/solid_visualizer.hpp"

#include "geometry/bounds/bounds.hpp"
#include "render/colors.hpp"
#include "render/deformed_surfaces.hpp"
#include "render/drawn_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor {
namespace {

const std::vector<float>& quantity(const SolidFrame& solid, SolidColors kind)
{
    return kind == SolidColors::stress ? solid.stresses : solid.plastic_strains;
}

bool in_sight(const SolidFrame& solid)
{
    return std::all_of(solid.positions.begin(), solid.positions.end(),
                       [](const Vector3d& x) { return rigor::in_sight(x); });
}

/// The smallest number not below `value` that is 1, 2 or 5 times a power of ten.
double rounded_up(double value)
{
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (value <= factor * power * (1 + 1e-9)) return factor * power;
    return 10 * power;
}

/// A unit in which pressures up to `largest` [Pa] are short to write: its size in Pa and its name.
std::pair<double, const char*> pressure_unit(double largest)
{
    if (largest >= 2e9) return {1e9, "GPa"};
    if (largest >= 2e6) return {1e6, "MPa"};
    if (largest >= 2e3) return {1e3, "kPa"};
    return {1, "Pa"};
}

} // namespace

SolidVisualizer::SolidVisualizer(const std::vector<SolidDescription>& solids,
                                 const Overlays& overlays, std::size_t first_color)
    : overlays_(overlays)
{
    for (const SolidDescription& solid : solids) {
        colors_.push_back(solid.color
                              ? linear_color(solid.color->x(), solid.color->y(), solid.color->z())
                              : colors::palette(first_color + colors_.size()));
        Bounds bounds;
        for (const Vector3d& v : solid.mesh->vertices)
            bounds.include({v, v});
        radii_.push_back((bounds.high - bounds.low).norm() / 2);
        stress_limit_ =
            std::min({stress_limit_, solid.material.yield_stress, solid.material.strength});
    }
}

std::array<double, 2>
SolidVisualizer::color_range(const std::vector<std::vector<float>>& values) const
{
    if (overlays_.solids_range) return *overlays_.solids_range;
    const bool is_stress = overlays_.solids == SolidColors::stress;
    if (is_stress && stress_limit_ < never) return {0, stress_limit_};
    double largest = 0;
    for (const std::vector<float>& of_solid : values)
        for (const float value : of_solid)
            largest = std::max<double>(largest, value);
    // The high end of the range is at least this, so that rounding errors around zero are not drawn
    // in bright colors.
    constexpr double least_stress = 1, least_strain = 1e-3; // [Pa]; strain has no unit
    const double least = is_stress ? least_stress : least_strain;
    return {0, rounded_up(std::max(largest, least))};
}

void SolidVisualizer::draw(Picture& picture, const Frame& frame) const
{
    const bool is_scale = overlays_.solids != SolidColors::color;
    // For each solid, the values at the points of its surface.
    std::vector<std::vector<float>> values(frame.solids.size());
    for (std::size_t i = 0; i < values.size() && is_scale; ++i)
        values[i] =
            at_points(*frame.solids[i].topology, quantity(frame.solids[i], overlays_.solids));
    const std::array<double, 2> range = color_range(values);
    const double low = range[0], high = range[1];
    for (std::size_t i = 0; i < frame.solids.size(); ++i) {
        if (!in_sight(frame.solids[i])) continue;
        add_deformed_surface(picture.deformed, frame.solids[i],
                             [&](const EmbeddedTriangle& triangle, int point) {
                                 if (triangle.is_crack)
                                     return is_scale ? colors::pale_crack : colors::crack;
                                 if (!is_scale) return colors_[i];
                                 return colors::scale((values[i][point] - low) / (high - low));
                             });
    }
    if (is_scale) add_color_scale(picture, range);
}

void SolidVisualizer::add_color_scale(Picture& picture, const std::array<double, 2>& range) const
{
    ColorScale& scale = picture.color_scale.emplace();
    constexpr int steps = 128; // number of colors in the bar; with fewer, one would see bands
    for (int i = 0; i < steps; ++i)
        scale.colors.push_back(colors::scale((i + 0.5) / steps));
    const auto [low, high] = range;
    const bool is_stress = overlays_.solids == SolidColors::stress;
    const auto [unit, name] = is_stress ? pressure_unit(high) : std::pair{1.0, ""};
    scale.title = is_stress ? fmt::format("von Mises stress [{}]", name) : "plastic strain";
    // The ticks are at round numbers, at least three of them.
    const double step = rounded_up((high - low) / unit / 8);
    const auto last = std::llround(std::floor(high / unit / step + 1e-9));
    for (auto n = std::llround(std::ceil(low / unit / step - 1e-9)); n <= last; ++n) {
        const double value = static_cast<double>(n) * step;
        scale.ticks.push_back({static_cast<float>((value * unit - low) / (high - low)),
                               fmt::format("{:.6g}", value)});
    }
}

bool SolidVisualizer::lies_apart(std::size_t solid, const SolidFrame& frame,
                                 const SolidFrame& other) const
{
    if (frame.topology->elements != other.topology->elements ||
        frame.positions.size() != other.positions.size())
        return true;
    for (std::size_t i = 0; i < frame.positions.size(); ++i)
        if (!((frame.positions[i] - other.positions[i]).norm() <= visible_distance * radii_[solid]))
            return true;
    return false;
}

void SolidVisualizer::draw_ghost(Picture& picture, const SolidFrame& solid) const
{
    if (!in_sight(solid)) return;
    add_deformed_surface(picture.ghost_deformed, solid,
                         [](const EmbeddedTriangle&, int) { return colors::ghostly; });
}

} // namespace rigor
