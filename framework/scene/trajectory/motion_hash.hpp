// SPDX-License-Identifier: MIT
// A motion as one number: equal if and only if (but for chance) every bit of it is.
//
// What makes a motion the same bits. For one program nothing else than its scene: no clock,
// address, order of a hash map or number of threads has a part in it. For two builds of the same
// tree: IEEE doubles and -ffp-contract=off -fno-fast-math round + - * / and the square root the
// same everywhere, and no -march lets Eigen add in another order. What is left are the functions of
// the C library (sin, cos, atan2, ...): they are not rounded correctly, differ between its versions
// and between processors with and without fused multiply-add, and where an argument is known while
// compiling, gcc puts in the correctly rounded value. So other compilers and libraries may part in
// the last bit, and a stored hash would be a promise about them; nobody stores one.
#pragma once

#include "scene/trajectory/trajectory.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rigor {

/// FNV-1a with 64 bits (Fowler, Noll and Vo) over the bodies and frames of a trajectory. Names and
/// the text of the scene are no part of it; mass, inertia, states and contacts are.
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
