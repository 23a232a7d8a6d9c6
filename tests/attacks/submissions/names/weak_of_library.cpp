// SPDX-License-Identifier: MIT
// Weak functions with the names of the C library and of what throws exceptions.
// expect: 0 crashed|failed|compile_error|timed_out|passed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

extern "C" {
[[gnu::weak]] void __cxa_throw(void*, void*, void (*)(void*))
{
    for (;;) {
    }
}
[[gnu::weak]] void* __cxa_begin_catch(void*) noexcept
{
    return nullptr;
}
[[gnu::weak]] void __stack_chk_fail() {}
[[gnu::weak]] int* __errno_location() noexcept
{
    return nullptr;
}
}
