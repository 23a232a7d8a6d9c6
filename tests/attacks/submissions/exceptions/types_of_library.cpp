// SPDX-License-Identifier: MIT
// Defines functions of the C++ library that throw and catch exceptions. With them the server would
// catch no exception and end in the middle of a question.
// expect: 0 compile_error|failed|crashed
#include "formulas/pipeline.hpp"

#include <stdexcept>
#include <unistd.h>

extern "C" {
void __cxa_throw(void*, void*, void (*)(void*))
{
    _exit(0);
}
void* __cxa_begin_catch(void* exception) noexcept
{
    return exception;
}
void __cxa_end_catch() {}
int __gxx_personality_v0(...)
{
    return 8; // go on with unwinding
}
}

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    throw std::runtime_error("nobody catches this");
}

} // namespace rigor
