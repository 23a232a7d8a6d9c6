// SPDX-License-Identifier: MIT
// The words, numbers and signs of a C++ source, without its comments.
#pragma once

#include <string_view>
#include <vector>

namespace rigor::mutants {

/// A token and its place in the text.
struct Token {
    enum class Kind { word, number, sign, literal };
    Kind kind;
    std::size_t begin, end; // offsets in the text
    std::string_view text;
    bool is_spaced; // there is space on both sides, as clang-format puts it around an operator of
                    // two operands and not around the brackets of a template
};

/// The tokens of a text. Comments and lines of the preprocessor are left out.
std::vector<Token> tokens(std::string_view text);

/// The index of the bracket that closes the one at `open`.
std::size_t closing(const std::vector<Token>& tokens, std::size_t open);

} // namespace rigor::mutants
