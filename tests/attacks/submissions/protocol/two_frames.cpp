// SPDX-License-Identifier: MIT
// Takes the place of the worker, and answers the question for a scene with a trajectory of two
// frames that differ only in their time, in which nothing has moved: many laws hold for it.
// topic: contact
// tasks: A5.6
// expect: 0 crashed|failed
#include "forged_worker.hpp"

namespace {

// A record for the start with the text of the scene, and two frames that differ in their time.
Forged two_frames(const Asked& asked)
{
    if (!asked.for_scene) return {};
    std::string stream = "rigor trajectory";
    stream += bytes_of(std::uint64_t{asked.payload.size()}) + asked.payload;
    for (const std::uint64_t step : {0, 1}) {
        const std::uint64_t frame = 2;
        stream += bytes_of(frame) + bytes_of(step) + std::string(4096, '\0');
    }
    return {stream, ""};
}

[[gnu::constructor]] void serve()
{
    serve_forged(two_frames);
}

} // namespace
