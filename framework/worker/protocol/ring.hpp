// SPDX-License-Identifier: MIT
// A ring buffer of bytes in shared memory: one process writes, the other one reads. This header
// only says where the bytes lie. The two processes wait for each other in different ways, so the
// code that waits is in worker/session.cpp and in worker/main/server.cpp.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

namespace rigor {

struct Ring {
    static constexpr std::uint32_t size = std::uint32_t{4} << 20; // [bytes], a power of two

    // `written`, `read`: bytes so far, modulo 2^32. Both are 0 when a scene starts.
    alignas(64) std::atomic<std::uint32_t> written;
    std::atomic<std::uint32_t>
        written_awaited; // not 0 while the reader may sleep until `written` changes
    alignas(64) std::atomic<std::uint32_t> read;
    std::atomic<std::uint32_t> read_awaited; // not 0 while the writer may sleep
    alignas(64) std::byte bytes[size];       // byte n is bytes[n % size]

    /// Copies `from`, which has at most `size` bytes, into the ring. The first byte of `from`
    /// becomes byte `at` of the ring.
    void copy_in(std::span<const std::byte> from, std::uint32_t at)
    {
        const std::uint32_t start = at % size;
        const std::size_t before_end = std::min<std::size_t>(from.size(), size - start);
        std::ranges::copy(from.first(before_end), bytes + start);
        std::ranges::copy(from.subspan(before_end), bytes);
    }

    /// Fills `to`, which has at most `size` bytes, with the bytes of the ring from byte `at` on.
    void copy_out(std::uint32_t at, std::span<std::byte> to) const
    {
        const std::uint32_t start = at % size;
        const std::size_t before_end = std::min<std::size_t>(to.size(), size - start);
        std::copy_n(bytes + start, before_end, to.begin());
        std::copy_n(bytes, to.size() - before_end, to.begin() + before_end);
    }
};

} // namespace rigor
