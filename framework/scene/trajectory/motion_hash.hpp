// SPDX-License-Identifier: MIT
// The hash of a motion. Two motions have the same hash if and only if all their bits are equal,
// except for a small chance of a collision.
//
// Within one program the bits of a motion depend on the scene alone: not on a clock, an address,
// the order of a hash map or the number of threads. Between two builds of the same sources, IEEE
// doubles and -ffp-contract=off -fno-fast-math make + - * / and the square root round the same
// everywhere, and without -march Eigen adds in the same order. Only the functions of the C library,
// such as sin and atan2, may differ: they are not correctly rounded, they differ between library
// versions and between processors with and without fused multiply-add, and gcc inserts the
// correctly rounded value where it knows the argument at compile time. So with other compilers and
// libraries the last bit may differ. No hash is stored, because a stored hash would be valid for
// only one compiler and library.
#pragma once

#include "scene/trajectory/trajectory.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rigor {

/// FNV-1a with 64 bits (Fowler, Noll and Vo) over the bodies and frames of a trajectory. Mass,
/// inertia, states, contacts and deformable solids are hashed; names, the text of the scene and the
/// counters are not.
class MotionHash {
public:
    void take(const std::vector<RecordedBody>& bodies);
    void take(const Frame& frame);

    std::uint64_t value() const { return value_; }
    std::string text() const; // 16 hexadecimal digits

private:
    void take(std::span<const std::byte> bytes);

    std::uint64_t value_ = 0xcbf29ce484222325;
};

} // namespace rigor
