// SPDX-License-Identifier: MIT
// Raises the number of the reply without end.
// expect: 0 crashed|failed
#include "channel_on_stack.hpp"
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    if (ChannelWords* channel = channel_on_stack())
        for (;;)
            channel->reply = channel->reply + 1;
    return 1;
}

} // namespace rigor
