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
    serve_forged([](const std::string&) {
        std::string stream(ring, '\0');
        for (std::size_t i = 0; i < ring; ++i)
            stream[i] = static_cast<char>(i / 8 % 2);
        return stream;
    });
}

} // namespace
