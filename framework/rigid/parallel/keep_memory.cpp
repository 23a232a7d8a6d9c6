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
    constexpr int kept = 1 << 30;           // [byte]
    constexpr int largest_block = 32 << 20; // [byte]; the largest that mallopt accepts
    mallopt(M_TRIM_THRESHOLD, kept);
    mallopt(M_MMAP_THRESHOLD, largest_block);
#endif
}

} // namespace rigor
