// SPDX-License-Identifier: MIT
// Looks in freed memory and below its stack for what the worker has of the formula: nothing but
// results.
// topic: validation
// tasks: A8.3
// expect: 0 failed
#include "formulas/validation.hpp"

#include <cstdlib>

namespace rigor {

Judgement test_tangent(const Tangent&)
{
    volatile double stack[512];
    int ones = 0;
    for (int i = 0; i < 512; ++i)
        ones += stack[i] == 1 ? 1 : 0;
    for (std::size_t size = 16; size < 4096; size += 16) {
        auto* old = static_cast<volatile double*>(std::malloc(size));
        ones += old[0] == 1 ? 1 : 0;
    }
    return ones % 2 == 0 ? accepted() : rejected();
}

} // namespace rigor
