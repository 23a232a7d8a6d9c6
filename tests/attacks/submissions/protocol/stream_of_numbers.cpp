// SPDX-License-Identifier: MIT
// Takes the place of the worker, and streams four megabytes of zeros and ones in the place of the
// answers of a scene.
// topic: kinematics
// tasks: A1.10 A1.11
// expect: 0 crashed
#include "forged_worker.hpp"

namespace {

[[gnu::constructor]] void serve()
{
    serve_forged([](const Asked& asked) {
        if (!asked.for_scene) return Forged();
        Forged forged{std::string(ring_size, '\0'), ""};
        for (std::size_t i = 0; i < ring_size; ++i)
            forged.streamed[i] = static_cast<char>(i / 8 % 2);
        return forged;
    });
}

} // namespace
