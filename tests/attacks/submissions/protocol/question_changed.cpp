// SPDX-License-Identifier: MIT
// Changes the question in the channel while it is answered.
// expect: 0 crashed|failed
#include "channel_on_stack.hpp"
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    if (ChannelWords* channel = channel_on_stack()) {
        channel->request = channel->request + 1;
        channel->request_size = 0;
    }
    return 1;
}

} // namespace rigor
