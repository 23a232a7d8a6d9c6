// SPDX-License-Identifier: MIT
// A formula of scenes that is slow but returns the right result. While it computes, it streams its
// answer byte by byte, so that no wait for the next byte is long.
#include "find_channel.hpp"
#include "formulas/rotation.hpp"
#include "formulas/table.hpp"
#include "worker/protocol/streamed_answer.hpp"

#include <array>
#include <chrono>

namespace rigor {

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    const Wrench right = {mass * gravity, Vector3d::Zero()};
    const StreamedAnswer header = {static_cast<std::uint32_t>(FormulaIndex::gravity_wrench),
                                   sizeof right};
    std::array<std::byte, sizeof header + sizeof right> bytes;
    std::memcpy(bytes.data(), &header, sizeof header);
    std::memcpy(bytes.data() + sizeof header, &right, sizeof right);

    using Clock = std::chrono::steady_clock;
    Ring& stream = find_channel().stream;
    std::uint32_t written = stream.written;
    stream.copy_in(bytes, written);
    for (const std::byte& byte [[maybe_unused]] : bytes) {
        const Clock::time_point start = Clock::now();
        while (Clock::now() - start < std::chrono::microseconds(100)) {
        }
        stream.written = ++written;
    }
    return right; // which the worker streams again, to the same place
}

} // namespace rigor
