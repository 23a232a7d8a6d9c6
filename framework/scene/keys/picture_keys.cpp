// SPDX-License-Identifier: MIT
// The keys for the camera and for what is drawn in addition to the bodies.
#include "scene/keys/picture_keys.hpp"

#include "scene/language/values.hpp"

#include <fmt/format.h>

namespace rigor {

namespace {

constexpr Key<Camera> camera_keys[] = {
    {"position", "of the eye, default [4, 3, 6] [m]",
     [](Camera& c, const Value& v) { c.position = vector3(v); }},
    {"target", "what it looks at, default [0, 0, 0] [m]",
     [](Camera& c, const Value& v) { c.target = vector3(v); }},
    {"field_of_view", "vertical, from 1 to 170, default 40 [degrees]",
     [](Camera& c, const Value& v) { c.field_of_view = in_range(v, "a field of view", 1, 170); }},
};

constexpr std::string_view solid_colors[] = {"color", "stress", "plastic_strain"};

std::array<double, 2> read_range(const Value& value)
{
    constexpr std::string_view what = "a range [low, high]";
    if (array(value, what).size() != 2) expected(what, value);
    const double low = not_negative(value.items[0], "a low end"),
                 high = positive(value.items[1], "a high end");
    if (!(low < high)) expected(fmt::format("a high end > {}", low), value.items[1]);
    return {low, high};
}

constexpr Key<Overlays> overlay_keys[] = {
    {"axes", "the axes of each body's frame, default false",
     [](Overlays& o, const Value& v) { o.axes = boolean(v); }},
    {"angular_velocity", "ω of each body, default false",
     [](Overlays& o, const Value& v) { o.angular_velocity = boolean(v); }},
    {"angular_momentum", "L of each body, default false",
     [](Overlays& o, const Value& v) { o.angular_momentum = boolean(v); }},
    {"contacts", "contact points and impulses, default false",
     [](Overlays& o, const Value& v) { o.contacts = boolean(v); }},
    {"labels", "the names of the bodies, default false",
     [](Overlays& o, const Value& v) { o.labels = boolean(v); }},
    {"grid", "the grid of the ground, default true",
     [](Overlays& o, const Value& v) { o.grid = boolean(v); }},
    {"solids",
     "what the colors of solids say: \"color\", \"stress\" (of von Mises) or "
     "\"plastic_strain\" (equivalent), default the first",
     [](Overlays& o, const Value& v) {
         o.solids = enumerator<SolidColors::plastic_strain>(v, solid_colors);
     }},
    {"solids_range",
     "[low, high] that those colors span [Pa, or none]; default from 0 to the least yield stress "
     "or "
     "strength, else to the largest value in the picture",
     [](Overlays& o, const Value& v) { o.solids_range = read_range(v); }},
};

} // namespace

Camera read_camera(const Value& value)
{
    Camera camera;
    read_object<Camera>(value, "a camera {\"position\": …, \"target\": …}", camera_keys, camera);
    // At a smaller distance [m], rounding errors would decide the direction of the view.
    constexpr double least_distance = 1e-9;
    if (!((camera.position - camera.target).norm() > least_distance))
        expected("a camera whose position is not its target", value);
    return camera;
}

Overlays read_overlays(const Value& value)
{
    Overlays overlays;
    read_object<Overlays>(value, "what to draw {\"axes\": true}", overlay_keys, overlays);
    return overlays;
}

void picture_meanings(std::vector<KeyMeaning>& meanings)
{
    add_meanings<Camera>("camera", camera_keys, meanings);
    add_meanings<Overlays>("draw", overlay_keys, meanings);
}

} // namespace rigor
