// SPDX-License-Identifier: MIT
// The text of a mesh as tokens between blanks, each with its line.
#pragma once

#include "geometry/meshes/mesh_error.hpp"

#include <string>
#include <string_view>

namespace rigor {

/// Reads a text token by token. It refuses an unexpected token with a MeshError.
class Tokenizer {
public:
    explicit Tokenizer(std::string_view text) : rest_(text) {}

    /// Line of the token that the latest call of `next` or `peek` returned, counted from 1.
    int line() const { return line_; }

    /// The next token, on this line or a later one; empty at the end of the text. `next` also goes
    /// past this token, `peek` does not.
    std::string_view peek();
    std::string_view next();
    void skip_line(); // goes to the start of the next line

    /// Each of these functions reads a token and checks it, except for `refuse`, which only throws
    /// the error.
    /// @param what  what is expected, as the message of the error names it
    /// @throws MeshError
    double coordinate();
    long long integer(long long low, long long high, const char* what);
    std::size_t count(std::size_t most, const char* what);
    void expect(std::string_view word);
    [[noreturn]] void refuse(const std::string& expected, std::string_view found) const;

private:
    std::string_view rest_;
    int line_ = 1;
};

} // namespace rigor
