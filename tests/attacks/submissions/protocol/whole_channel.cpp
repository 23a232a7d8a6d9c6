// SPDX-License-Identifier: MIT
// Fills the channel with ones, from its first word to its last.
// expect: 0 failed|crashed|timed_out
#include "channel_on_stack.hpp"
#include "formulas/pipeline.hpp"

#include <cstring>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    if (ChannelWords* channel = channel_on_stack())
        std::memset(static_cast<void*>(channel), 1, channel_size);
    return 1;
}

} // namespace rigor
