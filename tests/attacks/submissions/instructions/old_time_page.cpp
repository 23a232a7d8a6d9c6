// SPDX-License-Identifier: MIT
// Calls the old page of system calls (vsyscall), which is at the same address in every process.
// expect: 0 crashed|failed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    auto old_time = reinterpret_cast<long (*)(long*)>(0xffffffffff600400UL);
    return static_cast<double>(old_time(nullptr));
}

} // namespace rigor
