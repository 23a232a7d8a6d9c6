// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace rigor {

/// The name that is spelt most like `word`, by the number of letters to insert, remove, replace or
/// swap with a neighbour (Damerau 1964, "A technique for computer detection and correction of
/// spelling errors"). Empty if more than 2 letters and more than a third of the word differ.
std::string_view nearest(std::string_view word, std::span<const std::string_view> names);

} // namespace rigor
