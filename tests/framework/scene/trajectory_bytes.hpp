// SPDX-License-Identifier: MIT
// Bytes of a trajectory: joined, damaged, read back.
#pragma once

#include "errors/input_error.hpp"
#include "scene/trajectory/reader.hpp"
#include "scene/trajectory/writer.hpp"
#include "support/close.hpp"

#include <cstring>
#include <span>

namespace rigor::testing {

inline void append(Bytes& bytes, const Bytes& more)
{
    bytes.insert(bytes.end(), more.begin(), more.end());
}

/// `bytes` with `value` in place of what is at `at`.
template <class T> Bytes with(Bytes bytes, std::size_t at, T value)
{
    REQUIRE(at + sizeof value <= bytes.size());
    std::memcpy(bytes.data() + at, &value, sizeof value);
    return bytes;
}

/// What a reader makes of bytes that arrive in pieces of `piece` bytes.
inline Trajectory read(std::span<const std::byte> bytes, std::size_t piece)
{
    Trajectory trajectory;
    TrajectoryReader reader(trajectory);
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(piece, bytes.size())))
        reader.feed(bytes.first(std::min(piece, bytes.size())));
    return trajectory;
}

/// The one line that bytes are refused with; "accepted" if they are not.
inline std::string refusal(const Bytes& bytes)
{
    try {
        read(bytes, bytes.size());
    } catch (const InputError& error) {
        const std::string message = error.what();
        CHECK(message.find('\n') == std::string::npos);
        return message;
    }
    return "accepted";
}

/// Cut off anywhere, `bytes` are the run up to there: ever more frames, up to all `frames`.
inline void check_cut_off_anywhere(const Bytes& bytes, std::size_t frames)
{
    std::size_t frames_before = 0;
    for (std::size_t size = 1; size < bytes.size(); ++size) {
        const Trajectory trajectory = read(std::span(bytes).first(size), size);
        REQUIRE(!trajectory.complete);
        REQUIRE(trajectory.frames.size() >= frames_before);
        frames_before = trajectory.frames.size();
    }
    CHECK(frames_before == frames);
}

/// Every flip in a byte from `first` on is refused, or leaves a trajectory that `check` finds harmless.
/// @return how many are refused
template <class Check>
int flipped_bytes_refused(const Bytes& bytes, std::size_t first, const Check& check)
{
    int refused = 0;
    for (std::size_t i = first; i < bytes.size(); ++i)
        for (const int mask : {0x01, 0x80, 0xFF}) {
            Bytes flipped = bytes;
            flipped[i] ^= static_cast<std::byte>(mask);
            try {
                check(read(flipped, flipped.size()));
            } catch (const InputError&) {
                ++refused;
            }
        }
    return refused;
}

} // namespace rigor::testing
