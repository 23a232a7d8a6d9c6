// SPDX-License-Identifier: MIT
#pragma once

#include "render/gl/context.hpp"

#include <memory>

namespace rigor {

/// A context by OSMesa. @throws std::runtime_error if this machine cannot make one
std::unique_ptr<Context> make_osmesa_context();

} // namespace rigor
