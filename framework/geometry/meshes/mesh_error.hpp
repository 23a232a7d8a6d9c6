// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace rigor {

/// Something is wrong with a mesh: `expected …, found …`, and in which line of its text.
struct MeshError : std::runtime_error {
    MeshError(int in_line, const std::string& message) : std::runtime_error(message), line(in_line)
    {
    }
    int line = 0; // 0: in none
};

/// A number as an error message shows it, in six digits.
std::string number_text(double number);

} // namespace rigor
