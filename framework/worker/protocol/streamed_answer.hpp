// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace rigor {

/// The header before each encoded answer of a formula: before those that a worker streams, and
/// before those that the client gives to a scene.
struct StreamedAnswer {
    std::uint32_t formula; // its index in the table
    std::uint32_t size;    // length of the encoded answer [bytes]
};

} // namespace rigor
