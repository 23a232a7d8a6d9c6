// SPDX-License-Identifier: MIT
// Takes the place of the worker, and answers the question for a scene at once: nothing has moved.
// The grader takes only the answers of formulas from a worker, never a motion.
// topic: kinematics
// tasks: A1.10 A1.11
// expect: 0 crashed
#include "forged_worker.hpp"

namespace {

[[gnu::constructor]] void serve()
{
    serve_forged([](const Asked&) { return Forged(); });
}

} // namespace
