// SPDX-License-Identifier: MIT
// A hundred thousand brackets inside each other.
// expect: 0 compile_error|passed
#include "formulas/pipeline.hpp"

#define B10(x) ((((((((((x))))))))))
#define B100(x) B10(B10(B10(B10(B10(B10(B10(B10(B10(B10(x))))))))))
#define B1000(x) B100(B100(B100(B100(B100(B100(B100(B100(B100(B100(x))))))))))
#define B10000(x) B1000(B1000(B1000(B1000(B1000(B1000(B1000(B1000(B1000(B1000(x))))))))))
constexpr int deep =
    B10000(B10000(B10000(B10000(B10000(B10000(B10000(B10000(B10000(B10000(1))))))))));

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
