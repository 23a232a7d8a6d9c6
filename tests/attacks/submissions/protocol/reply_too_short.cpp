// SPDX-License-Identifier: MIT
// Answers with less than a number.
// expect: 0 crashed: it ends in the middle of a value
#include "channel_on_stack.hpp"
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    if (ChannelWords* channel = channel_on_stack()) {
        channel->status = 0;
        channel->reply_size = 3;
        channel->reply = channel->request;
        for (;;)
            pause();
    }
    return 1;
}

} // namespace rigor
