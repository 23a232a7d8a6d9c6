// SPDX-License-Identifier: MIT
// A formula that, in the middle of a scene, writes a stream of its own and says that the scene is
// over.
#include "find_channel.hpp"
#include "formulas/rotation.hpp"

#include <unistd.h>

namespace rigor {

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    static int calls = 0;
    if (++calls < 100) return {mass * gravity, Vector3d::Zero()};
    Channel& channel = find_channel();
    std::memset(channel.stream.bytes, 1, Ring::size);
    channel.stream.written = channel.stream.written + 4096;
    channel.status = ReplyStatus::done;
    channel.reply_size = 0;
    post(channel.reply, channel.reply_awaited, channel.request);
    for (;;)
        pause();
}

} // namespace rigor
