// SPDX-License-Identifier: MIT
#include "render/gl/shaders/shader_sources.hpp"

#include "render/gl/shaders/letter_sources.hpp"

#include <stdexcept>

namespace rigor {
namespace {

constexpr const char* sky = R"(
vec3 sky() {
    float down = gl_FragCoord.y / screen.y;
    return mix(vec3(0.70, 0.78, 0.88), vec3(0.93, 0.94, 0.94), smoothstep(0.0, 0.85, down));
}
)";

// Lighting: one sun with soft shadows, light from the sky, and weaker and warmer
// light from the ground.
constexpr const char* lighting = R"(
#ifdef SHADOWS
uniform sampler2DShadow shadow_map;
float sunlight(vec3 point, vec3 normal) {
    vec4 p = to_light * vec4(point + normal * light.w, 1.0);
    // four filtered looks, a pixel to each side of the point: together they cover 4 x 4 pixels
    vec2 d = vec2(screen.z, -screen.z);
    return 0.25 * (texture(shadow_map, vec3(p.xy + d.xx, p.z)) + texture(shadow_map, vec3(p.xy + d.xy, p.z)) +
                   texture(shadow_map, vec3(p.xy + d.yx, p.z)) + texture(shadow_map, vec3(p.xy + d.yy, p.z)));
}
#else
float sunlight(vec3 point, vec3 normal) { return 1.0; }
#endif
vec3 lit(vec3 color, vec3 point, vec3 normal, float gloss) {
    float facing = dot(normal, light.xyz);
    float sun = max(facing, 0.0) * sunlight(point, normal);
    vec3 ambient = mix(vec3(0.30, 0.28, 0.27), vec3(0.50, 0.54, 0.60), 0.5 + 0.5 * normal.y);
    vec3 view = normalize(eye.xyz - point);
    float shine = pow(max(dot(normal, normalize(light.xyz + view)), 0.0), 40.0);
    float rim = 1.0 - max(dot(normal, view), 0.0);
    rim *= rim;
    return color * (ambient + vec3(0.78, 0.75, 0.70) * sun) + gloss * (shine * sun + 0.25 * rim * rim);
}
)";

// How a vertex shader passes its color to the fragment shader. With `flat` a whole triangle has one
// color, that of its instance. Where drawing.cpp defines TINT as `smooth`, the colors of the
// corners are interpolated.
constexpr const char* tint = R"(
#ifndef TINT
#define TINT flat
#endif
)";

constexpr const char* solid_vertex = R"(
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 corner_normal;
layout(location = 2) in vec3 axis_x;
layout(location = 3) in vec3 axis_y;
layout(location = 4) in vec3 axis_z;
layout(location = 5) in vec3 place;
layout(location = 6) in vec4 tint;
#ifdef EDGES
layout(location = 7) in vec3 corner_edges;
out vec3 edges;
#endif
out vec3 point;
out vec3 normal;
out vec3 local;
flat out vec3 side_x, side_y, side_z; // unit
flat out vec3 half_size;
TINT out vec4 color;
void main() {
    point = mat3(axis_x, axis_y, axis_z) * corner + place;
    half_size = vec3(length(axis_x), length(axis_y), length(axis_z));
    side_x = axis_x / half_size.x;
    side_y = axis_y / half_size.y;
    side_z = axis_z / half_size.z;
    normal = mat3(side_x, side_y, side_z) * (corner_normal / half_size); // the columns are orthogonal
    local = corner;
#ifdef EDGES
    edges = corner_edges;
#endif
    color = tint;
    gl_Position = to_clip * vec4(point, 1.0);
}
)";

constexpr const char* solid_inputs = R"(
in vec3 point;
in vec3 normal;
in vec3 local;
flat in vec3 side_x, side_y, side_z;
flat in vec3 half_size;
TINT in vec4 color;
out vec4 pixel;
)";

// Boxes have rounded edges with a thin dark line. Only the normal is rounded, not the silhouette.
constexpr const char* box_fragment = R"(
void main() {
    vec3 p = local * half_size;
    vec3 inside = half_size - abs(p);
    float bevel = 0.14 * min(half_size.x, min(half_size.y, half_size.z));
    vec3 q = max(bevel - inside, 0.0) * sign(p);
    vec3 n = normalize(mat3(side_x, side_y, side_z) * q);
    // a face has one zero here; the next smallest is the way to its nearest edge
    float edge = max(min(inside.x, inside.y), min(max(inside.x, inside.y), inside.z));
    float pixels = edge / max(length(vec2(dFdx(edge), dFdy(edge))), 1e-6);
    float line = 1.0 - smoothstep(0.3, 2.2, pixels);
#ifdef GHOST
    pixel = vec4(lit(color.rgb, point, n, 0.0), mix(color.a, 1.0, 0.8 * line));
#else
    float wide = smoothstep(3.0, 14.0, bevel / 0.07 / max(length(fwidth(p)), 1e-6));
    pixel = vec4(lit(color.rgb, point, n, 0.16) * (1.0 - 0.40 * line * wide), 1.0);
#endif
}
)";

// Balls have octants in two tones, like the symbol for a center of mass in drawings, so that any
// spin shows.
constexpr const char* ball_fragment = R"(
void main() {
    vec3 p = normalize(local);
    vec3 n = normalize(mat3(side_x, side_y, side_z) * (p / half_size));
    vec3 wide = max(1.0 * fwidth(local), 1e-5);
    vec3 octant = clamp(p / wide, -1.0, 1.0);
    float tone = 0.5 + 0.5 * octant.x * octant.y * octant.z;
    vec3 surface = mix(color.rgb, mix(color.rgb, vec3(0.92), 0.70), tone);
#ifdef GHOST
    float edge = 1.0 - abs(dot(n, normalize(eye.xyz - point)));
    pixel = vec4(lit(surface, point, n, 0.0), mix(color.a, 1.0, 0.8 * edge * edge * edge));
#else
    pixel = vec4(lit(surface, point, n, 0.14), 1.0);
#endif
}
)";

// Any other surface has a thin dark line along its sharp edges, and octants in two tones like a
// ball, with the contrast of the surface.
constexpr const char* model_fragment = R"(
in vec3 edges;
void main() {
    vec3 n = normalize(normal);
    vec3 octant = clamp(local / max(fwidth(local), 1e-6), -1.0, 1.0);
    float tone = 0.5 + 0.5 * octant.x * octant.y * octant.z;
    vec3 surface = mix(color.rgb, mix(color.rgb, vec3(0.92), CONTRAST), tone);
    vec3 pixels = edges / max(fwidth(edges), 1e-9);
    float line = 1.0 - smoothstep(0.3, 2.2, min(pixels.x, min(pixels.y, pixels.z)));
#ifdef GHOST
    float rim = 1.0 - abs(dot(n, normalize(eye.xyz - point)));
    pixel = vec4(lit(surface, point, n, 0.0), mix(color.a, 1.0, 0.8 * max(line, rim * rim * rim)));
#else
    pixel = vec4(lit(surface, point, n, 0.14) * (1.0 - 0.40 * line), 1.0);
#endif
}
)";

constexpr const char* overlay_fragment = R"(
void main() {
#ifdef THROUGH
    pixel = color;
#else
    vec3 n = normalize(normal);
    float facing = 0.5 + 0.5 * dot(n, light.xyz);
    pixel = vec4(color.rgb * (0.45 + 0.75 * facing), 1.0);
#endif
}
)";

constexpr const char* ground_vertex = R"(
layout(location = 0) in vec2 spot; // along x and z [m]
uniform vec3 origin, along_x, along_z;
out vec3 point;
out vec2 away;
void main() {
    away = spot;
    point = origin + spot.x * along_x + spot.y * along_z;
    gl_Position = to_clip * vec4(point, 1.0);
}
)";

// The lines of the ground are filtered by their width on the screen, so that thin ones fade and do
// not shimmer (Golus 2022, "The Best Darn Grid Shader (Yet)").
constexpr const char* ground_fragment = R"(
in vec3 point;
in vec2 away;
uniform vec3 up;
uniform vec4 lines;  // 1 / spacing [1/m], 1 / radius of sight [1/m], the origin's place among the lines
uniform bool solid, grid;
out vec4 pixel;
float drawn(vec2 p, vec2 step, float width) {
    vec2 wide = clamp(vec2(width), step, vec2(0.5));
    vec2 side = abs(fract(p + 0.5) - 0.5) * 2.0;
    vec2 line = 1.0 - smoothstep(wide - 1.5 * step, wide + 1.5 * step, side);
    line *= width / wide;
    line = mix(line, vec2(width), clamp(step * 2.0 - 1.0, 0.0, 1.0));
    return mix(line.x, 1.0, line.y);
}
void main() {
    float far = smoothstep(0.12, 1.0, length(away) * lines.y);
    float ink = 0.0;
    if (grid) {
        vec2 p = away * lines.x + lines.zw;
        vec2 x = dFdx(p), y = dFdy(p);
        vec2 step = max(sqrt(x * x + y * y), 1e-6);
        ink = max(0.30 * drawn(p, step, 0.018), 0.50 * drawn(p / 5.0, step / 5.0, 0.007));
    }
    float sun = sunlight(point, up);
    if (solid) {
        vec3 color = vec3(0.80, 0.815, 0.83) * mix(vec3(0.56, 0.60, 0.70), vec3(1.0), sun);
        color = mix(color, vec3(0.30, 0.36, 0.44), ink);
        pixel = vec4(mix(color, sky(), far), 1.0);
    } else {
        float shade = 0.22 * (1.0 - sun);
        pixel = vec4(mix(vec3(0.20, 0.26, 0.36), vec3(0.10, 0.13, 0.2), shade), max(ink, shade) * (1.0 - far));
    }
}
)";

constexpr const char* background_vertex = R"(
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 1.0, 1.0);
}
)";

constexpr const char* background_fragment = R"(
out vec4 pixel;
void main() { pixel = vec4(sky(), 1.0); }
)";

constexpr const char* shadow_vertex = R"(
layout(location = 0) in vec3 corner;
layout(location = 2) in vec3 axis_x;
layout(location = 3) in vec3 axis_y;
layout(location = 4) in vec3 axis_z;
layout(location = 5) in vec3 place;
void main() {
    vec4 p = to_light * vec4(mat3(axis_x, axis_y, axis_z) * corner + place, 1.0);
    gl_Position = vec4(2.0 * p.xyz - 1.0, 1.0);
}
)";

} // namespace

ShaderSource source(Look look)
{
    const std::string solid = std::string(tint) + lighting + solid_inputs;
    const std::string corners = std::string(tint) + solid_vertex;
    switch (look) {
    case Look::box:
        return {corners, solid + box_fragment};
    case Look::ball:
        return {corners, solid + ball_fragment};
    case Look::model:
        return {"#define EDGES\n" + corners, solid + model_fragment};
    case Look::overlay:
        return {corners, std::string(tint) + solid_inputs + overlay_fragment};
    case Look::ground:
        return {ground_vertex, std::string(sky) + lighting + ground_fragment};
    case Look::background:
        return {background_vertex, std::string(sky) + background_fragment};
    case Look::shadow:
        return {shadow_vertex, "void main() {}\n"};
    case Look::text:
    case Look::patch:
        return letter_source(look);
    case Look::count:
        break;
    }
    throw std::logic_error("no such look");
}

} // namespace rigor
