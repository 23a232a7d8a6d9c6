// SPDX-License-Identifier: MIT
// Sets the clock of the machine.
// expect: 0 crashed: tried to change the time
#include "formulas/pipeline.hpp"

#include <ctime>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    const timespec past = {0, 0};
    clock_settime(CLOCK_REALTIME, &past);
    return 0;
}

} // namespace rigor
