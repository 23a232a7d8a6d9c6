// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace rigor {

/// Why a submission cannot be taken: one line without the submission's name, for its author.
struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace rigor
