// SPDX-License-Identifier: MIT
// Takes the place of the worker, and answers the question for a scene with a trajectory of two
// equal frames, in which nothing has moved: many laws hold for it.
// topic: contact
// tasks: A5.6
// expect: 0 crashed|failed
#include "forged_worker.hpp"

namespace {

void append(std::string& text, std::uint64_t number)
{
    text.append(reinterpret_cast<const char*>(&number), sizeof number);
}

// A record for the start with the text of the scene, and two frames that differ in their time.
std::string two_frames(const std::string& scene)
{
    std::string stream = "rigor trajectory";
    append(stream, scene.size());
    stream += scene;
    for (const std::uint64_t step : {0, 1}) {
        append(stream, 2); // a frame
        append(stream, step);
        for (int zeros = 0; zeros < 512; ++zeros)
            append(stream, 0);
    }
    return stream;
}

[[gnu::constructor]] void serve()
{
    serve_forged(two_frames);
}

} // namespace
