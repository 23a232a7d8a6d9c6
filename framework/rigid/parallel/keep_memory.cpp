// SPDX-License-Identifier: MIT
#include "rigid/parallel/keep_memory.hpp"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace rigor {

void keep_freed_memory()
{
#ifdef __GLIBC__
    constexpr int kept = 1 << 30; // largest amount of freed memory that the process keeps [bytes]
    // Blocks of at least this size go back to the system as soon as they are freed [bytes]. mallopt
    // accepts no larger value.
    constexpr int largest_block = 32 << 20;
    mallopt(M_TRIM_THRESHOLD, kept);
    mallopt(M_MMAP_THRESHOLD, largest_block);
#endif
}

} // namespace rigor
