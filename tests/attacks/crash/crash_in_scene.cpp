// SPDX-License-Identifier: MIT
// A formula that crashes in the middle of a scene, at its hundredth call.
#include "formulas/rotation.hpp"

#include <cstdint>

namespace rigor {

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    static int calls = 0;
    if (++calls < 100) return {mass * gravity, Vector3d::Zero()};
    *reinterpret_cast<volatile int*>(std::uintptr_t{64}) = 1;
    return {};
}

} // namespace rigor
