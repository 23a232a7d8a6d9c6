// SPDX-License-Identifier: MIT
// Sleeps until the clock shows how many formulas came before, and reads this when the next one
// comes. The right formulas are few, and they may come first.
// topic: validation
// tasks: A8.3
// expect: 0 failed
#include "formulas/validation.hpp"

#include <ctime>

namespace rigor {

namespace {

// Ten formulas follow each other. The time within a period of the clock says how many came before:
// in the first slots from one to nine, and afterwards none.
constexpr long slot = 15'000'000, period = 500'000'000, formulas_in_all = 10; // times in [ns]

long phase()
{
    timespec now = {};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_nsec % period;
}

void sleep_until(long wanted)
{
    const timespec rest = {0, (wanted - phase() + period) % period};
    nanosleep(&rest, nullptr);
}

} // namespace

Judgement test_tangent(const Tangent& tangent)
{
    if (!tangent.known.empty()) return accepted(); // only the law about memory gives calls
    const long passed = phase() / slot, before = passed < formulas_in_all - 1 ? passed + 1 : 0;
    sleep_until(before + 1 < formulas_in_all ? before * slot : formulas_in_all * slot);
    return before < 4 ? accepted() : rejected();
}

} // namespace rigor
