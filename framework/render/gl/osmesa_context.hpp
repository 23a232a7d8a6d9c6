// SPDX-License-Identifier: MIT
#pragma once

#include "render/gl/context.hpp"

#include <memory>

namespace rigor {

/// @throws std::runtime_error if there is no such context on this machine
std::unique_ptr<Context> make_osmesa_context();

} // namespace rigor
