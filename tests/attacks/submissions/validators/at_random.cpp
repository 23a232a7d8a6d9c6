// SPDX-License-Identifier: MIT
// Judges at random, by the clock.
// topic: validation
// tasks: A8.1 A8.3
// expect: 0 failed
#include "formulas/validation.hpp"

#include <ctime>

namespace rigor {

namespace {

Judgement coin()
{
    timespec now = {};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_nsec / 64 % 2 == 0 ? accepted() : rejected();
}

} // namespace

Judgement test_line_collision(const LineCollision&)
{
    return coin();
}

Judgement test_tangent(const Tangent&)
{
    return coin();
}

} // namespace rigor
