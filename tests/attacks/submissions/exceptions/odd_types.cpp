// SPDX-License-Identifier: MIT
// Throws a function object, a null pointer, a pointer to a member, and an object of a megabyte.
// expect: 0 crashed
#include "formulas/pipeline.hpp"

namespace rigor {

struct Large {
    char bytes[1 << 20];
};

int calls = 0;

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    switch (++calls % 4) {
    case 0:
        throw nullptr;
    case 1:
        throw Large();
    case 2:
        throw &Large::bytes;
    default:
        throw [](int) { return 1; };
    }
}

} // namespace rigor
