// SPDX-License-Identifier: MIT
// A formula that replies to this request and, in advance, to the next one.
#include "find_channel.hpp"
#include "formulas/kinematics.hpp"

#include <unistd.h>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    Channel& channel = find_channel();
    channel.status = ReplyStatus::done;
    channel.reply_size = 9 * sizeof(double);
    post(channel.reply, channel.reply_awaited, channel.request);
    post(channel.reply, channel.reply_awaited, channel.request + 1);
    for (;;)
        pause();
}

} // namespace rigor
