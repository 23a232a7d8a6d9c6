// SPDX-License-Identifier: MIT
// Lets a body leave for 1e198 m within a step. Every number is finite, but the length of a
// spring of the reference, which takes the next step from there, would not be.
// topic: kinematics
// tasks: A1.10 A1.11
// beside: equations_of_motion
// expect: 0 not_finite: beyond 1e+100
#include "formulas/kinematics.hpp"

namespace rigor {

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    static int calls = 0;
    MatrixStateRate rate = right_equations_of_motion(state, inverse_mass, I_inverse, wrench);
    if (++calls > 40) rate.position_rate = Vector3d(1e200, 1e200, -1e200);
    return rate;
}

} // namespace rigor
