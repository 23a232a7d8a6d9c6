// SPDX-License-Identifier: MIT
// A formula that exits the program, in which a static destructor never ends.
#include "formulas/kinematics.hpp"

#include <cstdlib>
#include <unistd.h>

namespace {

struct Sleeper {
    ~Sleeper()
    {
        for (;;)
            pause();
    }
} sleeper;

} // namespace

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    std::exit(0);
}

} // namespace rigor
