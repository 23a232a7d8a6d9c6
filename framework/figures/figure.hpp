// SPDX-License-Identifier: MIT
// A figure of a handout, computed by the formulas of the assignments.
#pragma once

#include "figures/drawing.hpp"

#include <span>
#include <string_view>

namespace rigor::figures {

struct Figure {
    std::string_view handout; // for example "a4-collision"
    std::string_view name;    // for example "friction_cone", in figures/friction_cone.svg
    Drawing (*draw)();
};

} // namespace rigor::figures
