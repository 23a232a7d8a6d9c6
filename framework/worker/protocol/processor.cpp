// SPDX-License-Identifier: MIT
#include "worker/protocol/processor.hpp"

#include <cstdio>
#include <memory>
#include <sched.h>
#include <unistd.h>

namespace rigor {

bool has_one_processor()
{
    cpu_set_t allowed;
    return sched_getaffinity(0, sizeof allowed, &allowed) == 0 && CPU_COUNT(&allowed) == 1;
}

bool has_idle_processor()
{
    // "0.42 0.37 0.29 2/345 6789": 2 of 345 threads run or wait for a processor
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> load(std::fopen("/proc/loadavg", "r"),
                                                               std::fclose);
    int threads = 0;
    if (!load || std::fscanf(load.get(), "%*f %*f %*f %d/", &threads) != 1) return false;
    return threads <= sysconf(_SC_NPROCESSORS_ONLN);
}

bool leave_processor()
{
    cpu_set_t allowed;
    const int here = sched_getcpu();
    if (here < 0 || sched_getaffinity(0, sizeof allowed, &allowed) != 0) return false;
    cpu_set_t others = allowed;
    CPU_CLR(here, &others);
    if (CPU_COUNT(&others) == 0 || sched_setaffinity(0, sizeof others, &others) != 0) return false;
    sched_setaffinity(0, sizeof allowed, &allowed);
    return true;
}

} // namespace rigor
