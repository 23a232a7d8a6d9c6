// SPDX-License-Identifier: MIT
// Answers with a status that does not exist.
// expect: 0 crashed: an answer of no known kind
#include "channel_on_stack.hpp"
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    if (ChannelWords* channel = channel_on_stack()) {
        channel->status = 99;
        channel->reply = channel->request;
        for (;;)
            pause();
    }
    return 1;
}

} // namespace rigor
