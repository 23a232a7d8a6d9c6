// SPDX-License-Identifier: MIT
// A function that runs before `main` takes the channel to the grader, and answers before the first
// question.
// expect: 0 crashed
#include "formulas/pipeline.hpp"

#include <sys/mman.h>

namespace {

[[gnu::constructor]] void answer_first()
{
    void* memory = mmap(nullptr, 1 << 20, PROT_READ | PROT_WRITE, MAP_SHARED, 3, 0);
    if (memory == MAP_FAILED) return;
    auto* words = static_cast<volatile unsigned*>(memory);
    for (int i = 0; i < 64; ++i)
        words[i] = 7;
}

} // namespace

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
