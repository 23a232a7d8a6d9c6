// SPDX-License-Identifier: MIT
// A program that sleeps at each start, before main.
#include <ctime>

namespace {

int sleep_a_little()
{
    const timespec time = {0, 300'000'000};
    nanosleep(&time, nullptr);
    return 0;
}

[[maybe_unused]] const int slept = sleep_a_little();

} // namespace
