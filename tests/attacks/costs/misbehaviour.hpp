// SPDX-License-Identifier: MIT
// What one formula of `worker_misbehaving` does. The choice is written into a copy of the program
// file, so that one program serves for all formulas.
#pragma once

#include <cstdint>

namespace rigor::costs {

enum class Kind : std::uint32_t {
    nothing, // it answers as the reference does
    ends,    // it ends the program
    crashes, // by a segmentation fault
    loops,   // it does not return
    lingers, // it computes for 1.9 s, which is just not too long, and then answers
};

/// The choice as it lies in the program file.
struct Choice {
    char mark[24]; // by which it is found there
    std::uint32_t formula;
    Kind kind;
};

inline constexpr char mark[] = "rigor: what misbehaves:";

} // namespace rigor::costs
