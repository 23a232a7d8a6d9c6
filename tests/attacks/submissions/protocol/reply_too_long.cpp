// SPDX-License-Identifier: MIT
// Answers with more bytes than the channel has.
// expect: 0 crashed: bytes where an answer has at most
#include "channel_on_stack.hpp"
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    if (ChannelWords* channel = channel_on_stack()) {
        channel->status = 0;
        channel->reply_size = ~std::uint64_t{0};
        channel->reply = channel->request;
        for (;;)
            pause();
    }
    return 1;
}

} // namespace rigor
