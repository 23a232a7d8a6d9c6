// SPDX-License-Identifier: MIT
// How deformable solids are drawn.
#include "geometry/bounds/bounds.hpp"
#include "render/colors.hpp"
#include "render/skins.hpp"
#include "render/stage.hpp"

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

/// 1, 2 or 5 times a power of ten: the next such number from `value` on.
double rounded_up(double value)
{
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (value <= factor * power * (1 + 1e-9)) return factor * power;
    return 10 * power;
}

/// The unit that makes numbers of this size short.
std::pair<double, const char*> pressure_unit(double largest)
{
    if (largest >= 2e9) return {1e9, "GPa"};
    if (largest >= 2e6) return {1e6, "MPa"};
    if (largest >= 2e3) return {1e3, "kPa"};
    return {1, "Pa"};
}

} // namespace

void Stage::add_solids()
{
    const auto moving = std::count_if(actors_.begin(), actors_.end(),
                                      [](const Actor& actor) { return !actor.is_static; });
    for (const SolidDescription& solid : scene_.solids) {
        const std::size_t n = static_cast<std::size_t>(moving) + solid_colors_.size();
        solid_colors_.push_back(
            solid.color ? linear_color(solid.color->x(), solid.color->y(), solid.color->z())
                        : colors::palette(n));
        Bounds bounds;
        for (const Vector3d& v : solid.mesh->vertices)
            bounds.include({v, v});
        solid_radii_.push_back((bounds.high - bounds.low).norm() / 2);
    }
}

Stage::Colors Stage::solid_colors(const std::vector<std::vector<float>>& values) const
{
    Colors result{overlays_.solids, {0, 0}};
    if (overlays_.solids_range) {
        result.range = *overlays_.solids_range;
        return result;
    }
    double limit = never, largest = 0;
    for (const SolidDescription& solid : scene_.solids)
        limit = std::min({limit, solid.material.yield_stress, solid.material.strength});
    if (result.kind == SolidColors::stress && limit < never) {
        result.range[1] = limit;
        return result;
    }
    for (const std::vector<float>& of_solid : values)
        for (const float value : of_solid)
            largest = std::max<double>(largest, value);
    // where there is nothing, rounding is not drawn as if it were something
    const double least = result.kind == SolidColors::stress ? 1 : 1e-3;
    result.range[1] = rounded_up(std::max(largest, least));
    return result;
}

void Stage::draw_solids(Picture& picture, const Frame& frame) const
{
    const bool is_scale = overlays_.solids != SolidColors::color;
    std::vector<std::vector<float>> values(frame.solids.size()); // at the points of the surfaces
    for (std::size_t i = 0; i < values.size() && is_scale; ++i)
        values[i] =
            at_points(*frame.solids[i].topology, quantity(frame.solids[i], overlays_.solids));
    const Colors colors = solid_colors(values);
    const double low = colors.range[0], high = colors.range[1];
    for (std::size_t i = 0; i < frame.solids.size(); ++i) {
        if (!in_sight(frame.solids[i])) continue;
        add_skin(picture.skins, frame.solids[i], [&](const EmbeddedTriangle& triangle, int point) {
            if (triangle.is_crack) return is_scale ? colors::pale_crack : colors::crack;
            if (!is_scale) return solid_colors_[i];
            return colors::scale((values[i][point] - low) / (high - low));
        });
    }
    if (is_scale) add_color_scale(picture, colors);
}

void Stage::add_color_scale(Picture& picture, const Colors& colors) const
{
    ColorScale& scale = picture.color_scale.emplace();
    constexpr int steps = 128;
    for (int i = 0; i < steps; ++i)
        scale.colors.push_back(colors::scale((i + 0.5) / steps));
    const auto [low, high] = colors.range;
    const bool is_stress = colors.kind == SolidColors::stress;
    const auto [unit, name] = is_stress ? pressure_unit(high) : std::pair{1.0, ""};
    scale.title = is_stress ? fmt::format("von Mises stress [{}]", name) : "plastic strain";
    // ticks at round numbers, four or more of them
    const double step = rounded_up((high - low) / unit / 8);
    const auto last = std::llround(std::floor(high / unit / step + 1e-9));
    for (auto n = std::llround(std::ceil(low / unit / step - 1e-9)); n <= last; ++n) {
        const double value = static_cast<double>(n) * step;
        scale.ticks.push_back({static_cast<float>((value * unit - low) / (high - low)),
                               fmt::format("{:.6g}", value)});
    }
}

bool Stage::lies_apart(std::size_t solid, const SolidFrame& frame, const SolidFrame& other) const
{
    if (frame.topology->elements != other.topology->elements ||
        frame.positions.size() != other.positions.size())
        return true;
    constexpr double seen = 0.004; // of the solid's radius: less cannot be seen
    for (std::size_t i = 0; i < frame.positions.size(); ++i)
        if (!((frame.positions[i] - other.positions[i]).norm() <= seen * solid_radii_[solid]))
            return true;
    return false;
}

void Stage::add_ghost(Picture& picture, const SolidFrame& solid) const
{
    if (!in_sight(solid)) return;
    add_skin(picture.ghost_skins, solid,
             [](const EmbeddedTriangle&, int) { return colors::ghostly; });
}

} // namespace rigor
