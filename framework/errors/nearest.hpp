// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rigor {

/// The name that is spelt most like `word`, by the number of letters to insert, remove, replace or
/// swap with a neighbor (Damerau 1964, "A technique for computer detection and correction of
/// spelling errors"). If every name differs
/// 1. in all letters, or
/// 2. in more than 2 letters, and in more than a third of the letters of `word`,
/// it is the only name that begins with `word`, of at least three letters. The result is empty if
/// there is none, or if `word` is longer than 64 bytes.
std::string_view nearest(std::string_view word, std::span<const std::string_view> names);

/// The end of an error message about a word that is not among the known `names`: `; did you mean
/// "inertia"?` with the nearest of the names. If no name is near, it is `; ` and `otherwise`, or
/// empty if `otherwise` is empty.
std::string suggestion(std::string_view word, std::span<const std::string_view> names,
                       std::string_view otherwise = {});
std::string suggestion(std::string_view word, std::span<const std::string> names,
                       std::string_view otherwise = {});

} // namespace rigor
