// SPDX-License-Identifier: MIT
#include "rigid/keep_memory.hpp"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace rigor {

void keep_freed_memory()
{
#ifdef __GLIBC__
    constexpr int most = 1 << 30, largest = 32 << 20; // [byte]
    mallopt(M_TRIM_THRESHOLD, most);
    mallopt(M_MMAP_THRESHOLD, largest); // the largest that it takes
#endif
}

} // namespace rigor
