// SPDX-License-Identifier: MIT
// Wakes those who wait for a word of the channel, or moves them to another word, 100 000 times.
// expect: 0 failed|crashed|timed_out
#include "channel_on_stack.hpp"
#include "formulas/pipeline.hpp"

#include <sys/syscall.h>
#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    ChannelWords* channel = channel_on_stack();
    for (int i = 0; channel != nullptr && i < 100'000; ++i)
        syscall(SYS_futex, &channel->reply, i % 2 == 0 ? 1 : 3, 1000, 1000, &channel->request, 0);
    return 1;
}

} // namespace rigor
