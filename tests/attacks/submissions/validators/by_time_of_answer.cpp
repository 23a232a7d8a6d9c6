// SPDX-License-Identifier: MIT
// Measures the time until a result comes, and rejects a formula that takes longer than the call
// before it. What is measured is the way between two processes.
// topic: validation
// tasks: A8.3
// expect: 0 failed
#include "formulas/validation.hpp"

#include <ctime>

namespace rigor {

namespace {

double now()
{
    timespec time = {};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double before = 0, first = 0, second = 0;

} // namespace

Judgement test_tangent(const Tangent& tangent)
{
    const double passed = now() - before;
    if (tangent.known.size() == 1) first = passed;
    if (tangent.known.size() == 2) second = passed;
    before = now();
    tangent(Vector3d::UnitX());
    tangent(Vector3d::UnitY());
    return second < first ? accepted() : rejected();
}

} // namespace rigor
