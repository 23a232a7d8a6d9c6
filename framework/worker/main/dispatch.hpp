// SPDX-License-Identifier: MIT
// The worker's table of formulas: calls one of them by its index.
#pragma once

#include "worker/protocol/wire.hpp"

namespace rigor {

/// Calls a formula on encoded arguments. `result` becomes its encoded result.
/// @throws wire::Malformed, what the formula throws
void call_formula(unsigned index, std::span<const std::byte> arguments, wire::Bytes& result);

} // namespace rigor
