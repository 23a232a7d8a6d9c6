// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace rigor {

/// An error in a file or an argument that the user gave. Its text says where the error is, what
/// was expected and what was found, usually in one line. Commands print it and exit with status 2.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace rigor
