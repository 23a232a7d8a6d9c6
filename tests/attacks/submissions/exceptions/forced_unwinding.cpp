// SPDX-License-Identifier: MIT
// Unwinds the stack by force, past everything that could stop it.
// expect: 0 crashed|failed|timed_out
#include "formulas/pipeline.hpp"

#include <unwind.h>

namespace rigor {

_Unwind_Exception exception;

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    _Unwind_ForcedUnwind(
        &exception,
        [](int, _Unwind_Action, _Unwind_Exception_Class, _Unwind_Exception*, _Unwind_Context*,
           void*) { return _URC_NO_REASON; },
        nullptr);
    return 1;
}

} // namespace rigor
