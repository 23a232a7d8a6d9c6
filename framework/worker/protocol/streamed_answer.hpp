// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace rigor {

/// What stands before each encoded answer of a formula, in a stream of answers and in those that
/// are given to a scene.
struct StreamedAnswer {
    std::uint32_t formula; // its index in the table
    std::uint32_t size;    // length of the encoded answer [bytes]
};

} // namespace rigor
