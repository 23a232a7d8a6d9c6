// SPDX-License-Identifier: MIT
// Calls a formula by its index in the table of formulas (formulas/table.hpp).
#pragma once

#include "worker/protocol/wire.hpp"

namespace rigor {

/// Calls a formula on encoded arguments. `result` becomes its encoded result.
/// @throws wire::Malformed, what the formula throws
void call_formula(unsigned index, std::span<const std::byte> arguments, wire::Bytes& result);

} // namespace rigor
