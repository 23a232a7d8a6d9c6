// SPDX-License-Identifier: MIT
// A formula of scenes that is slow but returns the right result.
#include "formulas/rotation.hpp"

#include <chrono>
#include <thread>

namespace rigor {

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return {mass * gravity, Vector3d::Zero()};
}

} // namespace rigor
