// SPDX-License-Identifier: MIT
// A formula that, in the middle of a scene, says that its worker has used more of the given answers
// than there are.
#include "find_channel.hpp"
#include "formulas/rotation.hpp"

namespace rigor {

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    static int calls = 0;
    if (++calls == 100) {
        Channel& channel = find_channel();
        channel.answers.read = channel.answers.written + 1;
    }
    return {mass * gravity, Vector3d::Zero()};
}

} // namespace rigor
