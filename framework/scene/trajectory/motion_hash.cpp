// SPDX-License-Identifier: MIT
// Computes the FNV-1a hash of the bytes that the writer makes from bodies and frames.
#include "scene/trajectory/motion_hash.hpp"

#include "scene/trajectory/writer.hpp"

#include <fmt/format.h>

namespace rigor {

void MotionHash::take(std::span<const std::byte> bytes)
{
    for (const std::byte byte : bytes)
        value_ = (value_ ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3;
}

void MotionHash::take(const std::vector<RecordedBody>& bodies)
{
    take(encode_start({}, bodies)); // an empty scene, since name and text are not hashed
}

void MotionHash::take(const Frame& frame)
{
    take(encode_frame(frame));
}

std::string MotionHash::text() const
{
    return fmt::format("{:016x}", value_);
}

} // namespace rigor
