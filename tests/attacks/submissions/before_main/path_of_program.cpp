// SPDX-License-Identifier: MIT
// Prints what the kernel tells a program when it starts: its path, its user, its variables. In the
// sandbox, the path of a program does not tell where the source tree is.
// expect: 0 failed
#include "formulas/pipeline.hpp"

#include <cstdio>
#include <sys/auxv.h>

namespace {

[[gnu::constructor]] void tell(int arguments, char** argument, char** variable)
{
    const char* name = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
    std::printf("%s %s\n", name ? name : "", arguments > 0 ? argument[0] : "");
    for (; *variable; ++variable)
        std::puts(*variable);
}

} // namespace

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    return 0;
}

} // namespace rigor
