// SPDX-License-Identifier: MIT
// Judges by the addresses that it gets: they are those of copies, in its own process.
// topic: validation
// tasks: A8.1 A8.3
// expect: 0 failed
#include "formulas/validation.hpp"

#include <cstdint>

namespace rigor {

namespace {

template <class Formula> Judgement by_address(const Formula& formula)
{
    const auto address = reinterpret_cast<std::uintptr_t>(&formula);
    const auto calls = reinterpret_cast<std::uintptr_t>(formula.known.data());
    return (address / 64 + calls / 64) % 2 == 0 ? accepted() : rejected();
}

} // namespace

Judgement test_line_collision(const LineCollision& collide)
{
    return by_address(collide);
}

Judgement test_tangent(const Tangent& tangent)
{
    return by_address(tangent);
}

} // namespace rigor
