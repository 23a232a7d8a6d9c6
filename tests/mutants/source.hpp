// SPDX-License-Identifier: MIT
// A source of formulas, taken apart into what can be mutated: its functions and its constants.
#pragma once

#include "mutants/tokens.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rigor::mutants {

/// A function with its body. The numbers are indices of tokens.
struct Function {
    std::string name;
    std::size_t declaration; // its first token
    std::size_t name_token;
    std::size_t open, close;            // the braces of its body
    std::vector<std::string> arguments; // their names
    std::vector<std::string> types;     // the types of the arguments
    bool is_member = false;
};

/// A number with a name outside of functions: `constexpr double name = value;`
struct Constant {
    std::string name;
    std::size_t declaration; // its first token
    std::size_t value, end;  // the first token of the value, and the semicolon after it
};

/// A source and its parts, in the order of the text.
struct Source {
    std::string text;
    std::vector<Token> tokens;
    std::vector<Function> functions;
    std::vector<Constant> constants;

    Source() = default;
    Source(const Source&) = delete; // the tokens refer to the text
    Source& operator=(const Source&) = delete;

    /// The text from the begin of token `first` to the end of token `last`.
    std::string between(std::size_t first, std::size_t last) const
    {
        return text.substr(tokens[first].begin, tokens[last].end - tokens[first].begin);
    }
};

void read_source(Source& source, const std::filesystem::path& file);

} // namespace rigor::mutants
