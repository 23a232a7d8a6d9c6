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

/// `bytes` with the bytes at `at` replaced by `value`.
template <class T> Bytes with(Bytes bytes, std::size_t at, T value)
{
    REQUIRE(at + sizeof value <= bytes.size());
    std::memcpy(bytes.data() + at, &value, sizeof value);
    return bytes;
}

/// The trajectory that a reader gets from bytes that arrive in chunks of `piece` bytes.
inline Trajectory read(std::span<const std::byte> bytes, std::size_t piece)
{
    Trajectory trajectory;
    TrajectoryReader reader(trajectory);
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(piece, bytes.size())))
        reader.feed(bytes.first(std::min(piece, bytes.size())));
    return trajectory;
}

/// The one-line message with which bytes are refused, or "accepted" if they are not.
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

/// Checks that `bytes`, cut off anywhere, contain the run up to that place: the number of frames
/// only increases with the length, up to all `frames`.
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

/// Flips each byte from `first` on. The result must be refused, or be a trajectory that `check`
/// accepts as harmless.
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
