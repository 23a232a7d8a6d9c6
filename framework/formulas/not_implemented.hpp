// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace rigor {

/// Thrown by a stub, `throw NotImplemented("inertia::combine");`. A test then says "not implemented
/// yet", not "wrong".
struct NotImplemented : std::logic_error {
    /// @param formula  `<topic>::<formula>`
    explicit NotImplemented(const std::string& formula) : std::logic_error(formula) {}
};

} // namespace rigor
