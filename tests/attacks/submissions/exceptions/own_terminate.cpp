// SPDX-License-Identifier: MIT
// Goes on with a wrong value where the program should end.
// expect: 0 failed|crashed|exited
#include "formulas/pipeline.hpp"

#include <csetjmp>
#include <exception>

namespace rigor {

std::jmp_buf before;

void fails() noexcept
{
    throw 1;
}

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    std::set_terminate([] { std::longjmp(before, 1); });
    if (setjmp(before) == 0) fails();
    return 1;
}

} // namespace rigor
