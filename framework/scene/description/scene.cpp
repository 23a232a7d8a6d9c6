// SPDX-License-Identifier: MIT
#include "scene/description/scene.hpp"

#include <cmath>

namespace rigor {

std::int64_t step_count(const Scene& scene)
{
    return std::llround(scene.end / scene.time_step);
}

std::int64_t frame_step(const Scene& scene, std::int64_t frame)
{
    return std::llround(static_cast<double>(frame) / (scene.frames_per_second * scene.time_step));
}

std::int64_t frame_count(const Scene& scene)
{
    std::int64_t last = std::llround(scene.end * scene.frames_per_second) + 1;
    while (last > 0 && frame_step(scene, last) > step_count(scene))
        --last;
    return last + 1;
}

} // namespace rigor
