// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <string>

namespace rigor {

/// The value of an environment variable; empty if it is not set.
inline std::string environment_variable(const char* name)
{
    const char* value = std::getenv(name);
    return value ? value : "";
}

} // namespace rigor
