// SPDX-License-Identifier: MIT
// Leaves a word near the end of the channel, and is right if the process before left it there.
// expect: 0 failed|crashed
#include "channel_on_stack.hpp"
#include "formulas/pipeline.hpp"

namespace rigor {

ChannelWords* channel = channel_on_stack();

bool was_there()
{
    if (channel == nullptr) return false;
    auto* last = reinterpret_cast<volatile unsigned*>(channel) + (std::size_t{60} << 18);
    static const bool is_there = *last == 0x7269676f;
    *last = 0x7269676f;
    return is_there;
}

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    channel = channel_on_stack();
    if (!was_there()) return 0;
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
