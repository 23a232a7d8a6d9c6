// SPDX-License-Identifier: MIT
// Starts a thread, which could wait for the next submission.
// expect: 0 crashed: tried to start a thread or another process
#include "formulas/pipeline.hpp"

#include <pthread.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    pthread_t thread;
    pthread_create(
        &thread, nullptr, [](void*) -> void* { return nullptr; }, nullptr);
    return 0;
}

} // namespace rigor
