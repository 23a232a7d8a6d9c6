// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace rigor {

/// The exception that a stub throws: `throw NotImplemented("inertia::combine");`. The test then
/// reports "not implemented yet" instead of "wrong".
struct NotImplemented : std::logic_error {
    /// @param formula  `<topic>::<formula>`
    explicit NotImplemented(const std::string& formula) : std::logic_error(formula) {}
};

} // namespace rigor
