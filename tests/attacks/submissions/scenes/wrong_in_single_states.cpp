// SPDX-License-Identifier: MIT
// Wrong by far in one of sixteen states, which a hash of the state's bits chooses. A neighboring
// state, some rounding errors away, has another hash, so the formula is right in nearly all of
// these. If a test let the formula step from neighbors too, to see whether rounding alone decides
// a step, it would excuse the wrong steps. It does not help: only the reference is asked there.
// topic: kinematics
// tasks: A1.11
// beside: equations_of_motion
// expect: 0 failed
#include "formulas/kinematics.hpp"

#include <bit>
#include <cstdint>

namespace rigor {

namespace {

bool is_drawn(const MatrixState& state)
{
    std::uint64_t hash = 0x9e3779b97f4a7c15;
    for (const double x : {state.position.x(), state.position.y(), state.velocity.x(),
                           state.velocity.y(), state.rotation(0, 1), state.rotation(1, 2)}) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0xbf58476d1ce4e5b9;
        hash ^= hash >> 31;
    }
    return hash % 16 == 0;
}

} // namespace

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    MatrixStateRate rate = right_equations_of_motion(state, inverse_mass, I_inverse, wrench);
    if (is_drawn(state)) rate.velocity_rate = 1000 * rate.position_rate;
    return rate;
}

} // namespace rigor
