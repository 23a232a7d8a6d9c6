// SPDX-License-Identifier: MIT
// Lets the kernel mark words of the channel as locks whose owner died.
// expect: 0 crashed|failed|timed_out
#include "channel_on_stack.hpp"
#include "formulas/pipeline.hpp"

#include <sys/syscall.h>
#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    static void* list[3];
    ChannelWords* channel = channel_on_stack();
    list[0] = &list[0];
    list[1] = nullptr;
    list[2] = channel != nullptr ? const_cast<unsigned*>(&channel->reply) : nullptr;
    syscall(SYS_set_robust_list, list, sizeof list);
    syscall(SYS_exit, 0);
    return 1;
}

} // namespace rigor
