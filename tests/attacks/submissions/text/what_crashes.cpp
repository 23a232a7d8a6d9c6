// SPDX-License-Identifier: MIT
// Throws an exception whose text is at no address.
// expect: 0 crashed: segmentation fault
#include "formulas/pipeline.hpp"

#include <exception>

namespace {

struct Nowhere : std::exception {
    const char* what() const noexcept override { return reinterpret_cast<const char*>(64); }
};

} // namespace

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    throw Nowhere();
}

} // namespace rigor
