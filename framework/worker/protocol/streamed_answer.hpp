// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace rigor {

/// The header before each encoded answer of a formula, both in the stream of a worker and among the
/// answers that the client gives to a scene.
struct StreamedAnswer {
    std::uint32_t formula; // index of the formula in the table of formulas/table.hpp
    std::uint32_t size;    // length of the encoded answer [bytes]
};

} // namespace rigor
