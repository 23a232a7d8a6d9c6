// SPDX-License-Identifier: MIT
#include "rigid/parallel/keep_memory.hpp"

#include "support/catch.hpp"

#include <cstdlib>
#include <cstring>

#ifdef __GLIBC__
#include <malloc.h>
#endif

// Sanitizers have an allocator of their own, which this setting does not reach.
#if defined(__SANITIZE_ADDRESS__)
#define RIGOR_OTHER_ALLOCATOR
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RIGOR_OTHER_ALLOCATOR
#endif
#endif

using namespace rigor;

#if defined(__GLIBC__) && !defined(RIGOR_OTHER_ALLOCATOR)

TEST_CASE("keep memory: megabytes that are freed stay with the process", "[rigid]")
{
    constexpr std::size_t size = 24 << 20; // [byte]
    keep_freed_memory();
    const struct mallinfo2 before = mallinfo2();
    void* block = std::malloc(size);
    REQUIRE(block);
    std::memset(block, 1, size);
    const struct mallinfo2 used = mallinfo2();
    CHECK(used.hblks == before.hblks); // no mapping (mmap), which free would end
    CHECK(used.uordblks >= before.uordblks + size);
    std::free(block);
    const struct mallinfo2 after = mallinfo2();
    CHECK(after.arena == used.arena); // nothing went back to the system
    CHECK(after.fordblks >= size);

    // So a later allocation gets this memory again.
    block = std::malloc(size);
    CHECK(mallinfo2().arena == after.arena);
    std::free(block);
}

#endif
