// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

namespace rigor {

Action declare_render(Options&)
{
    return [] { return 0; };
}

} // namespace rigor
