// SPDX-License-Identifier: MIT
// A constructor takes the place of the worker: it greets, and answers each question itself.
// expect: 0 failed
#include "forged_worker.hpp"
#include "formulas/pipeline.hpp"

namespace {

[[gnu::constructor]] void serve()
{
    serve_forged([](const Asked&) { return Forged{"", bytes_of(1.0)}; });
}

} // namespace

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    return 0;
}

} // namespace rigor
