// SPDX-License-Identifier: MIT
// A section that says it is compressed, and has the size of the whole address space.
// expect: 0 compile_error|passed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

asm(".section .debug_attack, \"0x800\", @progbits\n"
    ".long 1, 0\n.quad 0x7fffffffffffff00, 1\n.ascii \"zlib\"\n.text");
