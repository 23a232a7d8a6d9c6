// SPDX-License-Identifier: MIT
// Bytes come out of a ring buffer as they went in, wherever its end lies among them.
#include "support/catch.hpp"
#include "worker/protocol/ring.hpp"

#include <memory>
#include <vector>

namespace rigor {

TEST_CASE("what is copied into a ring is copied out, across its end and past 2^32")
{
    const auto ring = std::make_unique<Ring>();
    const std::uint32_t sizes[] = {0, 1, 5000, Ring::size - 1, Ring::size};
    const std::uint32_t starts[] = {0, 1, Ring::size - 1, Ring::size, 3 * Ring::size - 7, 0u - 3};
    for (const std::uint32_t size : sizes)
        for (const std::uint32_t start : starts) {
            std::vector<std::byte> in(size), out(size);
            for (std::uint32_t i = 0; i < size; ++i)
                in[i] = static_cast<std::byte>((start + i) * 2654435761u >> 24);
            ring->copy_in(in, start);
            ring->copy_out(start, out);
            CHECK(in == out);
            if (size > 0) CHECK(ring->bytes[start % Ring::size] == in[0]);
        }
}

TEST_CASE("a copy into a ring leaves the other bytes as they are")
{
    const auto ring = std::make_unique<Ring>();
    const std::vector<std::byte> ones(10, std::byte{1});
    ring->copy_in(ones, Ring::size - 4);
    for (std::uint32_t i = 0; i < Ring::size; ++i) {
        const bool is_set = i < 6 || i >= Ring::size - 4;
        if ((ring->bytes[i] == std::byte{1}) != is_set) FAIL("byte " << i);
    }
}

} // namespace rigor
