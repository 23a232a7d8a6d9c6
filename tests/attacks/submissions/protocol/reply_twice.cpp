// SPDX-License-Identifier: MIT
// Writes an answer into the channel itself, and then returns another one.
// expect: 0 crashed|failed
#include "channel_on_stack.hpp"
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    if (ChannelWords* channel = channel_on_stack()) {
        channel->status = 0;
        channel->reply_size = sizeof(double);
        channel->reply = channel->request;
    }
    return 1;
}

} // namespace rigor
