// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace rigor {

/// The error for a mesh that is refused. The message contains what was expected and what was found,
/// and `line` is the place.
struct MeshError : std::runtime_error {
    MeshError(int in_line, const std::string& message) : std::runtime_error(message), line(in_line)
    {
    }
    int line = 0; // line of the mesh's text, counted from 1; 0 if no single line is wrong
};

/// A number as an error message shows it, with at most six significant digits.
std::string number_text(double number);

} // namespace rigor
