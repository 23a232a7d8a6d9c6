// SPDX-License-Identifier: MIT
// Ends the main thread but not the process.
// expect: 0 crashed|timed_out
#include "formulas/pipeline.hpp"

#include <pthread.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    pthread_exit(nullptr);
}

} // namespace rigor
