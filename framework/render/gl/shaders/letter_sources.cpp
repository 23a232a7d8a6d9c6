// SPDX-License-Identifier: MIT
// The shaders of texts and patches (rectangles of one color), which are drawn on the finished
// picture.
#include "render/gl/shaders/letter_sources.hpp"

namespace rigor {
namespace {

constexpr const char* text_vertex = R"(
layout(location = 0) in vec4 place; // on the screen, in the atlas [pixels]
layout(location = 1) in vec4 ink;
out vec2 at;
flat out vec4 color;
void main() {
    at = place.zw;
    color = ink;
    gl_Position = vec4(place.xy / screen.xy * 2.0 - 1.0, 0.0, 1.0);
}
)";

// Letters have a pale rim, so that they can be read on any color.
constexpr const char* text_fragment = R"(
uniform sampler2D atlas;
in vec2 at;
flat in vec4 color;
out vec4 pixel;
void main() {
    ivec2 here = ivec2(floor(at));
    float rim = 0.0;
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
            rim = max(rim, texelFetch(atlas, here + ivec2(i, j), 0).r * (i * j == 0 ? 1.0 : 0.7));
    float letter = texelFetch(atlas, here, 0).r;
    float alpha = max(letter, 0.75 * rim) * color.a;
    pixel = vec4(mix(vec3(0.98), color.rgb, letter), alpha);
}
)";

constexpr const char* patch_vertex = R"(
layout(location = 0) in vec2 place; // on the screen [pixels]
layout(location = 1) in vec4 ink;
flat out vec4 color;
void main() {
    color = ink;
    gl_Position = vec4(place / screen.xy * 2.0 - 1.0, 0.0, 1.0);
}
)";

constexpr const char* patch_fragment = R"(
flat in vec4 color;
out vec4 pixel;
void main() { pixel = color; }
)";

} // namespace

ShaderSource letter_source(Look look)
{
    if (look == Look::text) return {text_vertex, text_fragment};
    return {patch_vertex, patch_fragment};
}

} // namespace rigor
