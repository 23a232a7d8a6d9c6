// SPDX-License-Identifier: MIT
// Calls the engine of the worker by its name, which nothing outside of it can see.
// expect: 0 crashed
#include "formulas/pipeline.hpp"

extern "C" void rigor_run_scenes(const void*, const void*, void*);

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    rigor_run_scenes(nullptr, nullptr, nullptr);
    return 0;
}

} // namespace rigor
