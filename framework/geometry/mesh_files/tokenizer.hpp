// SPDX-License-Identifier: MIT
// The words of a mesh's text, with the line that each is in.
#pragma once

#include "geometry/meshes/mesh_error.hpp"

#include <string>
#include <string_view>

namespace rigor {

class Tokenizer {
public:
    explicit Tokenizer(std::string_view text) : rest_(text) {}

    int line() const { return line_; } // of the word read last, from 1

    std::string_view peek(); // the next word, on whatever line; empty at the end
    std::string_view next();
    void skip_line(); // to the start of the next line

    /// @param what  expected, for the error
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
