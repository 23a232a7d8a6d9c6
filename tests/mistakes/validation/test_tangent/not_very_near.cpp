// SPDX-License-Identifier: MIT
// Tries directions near the axes and diagonals, but none nearer than 1e-8.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_tangent(const Tangent& tangent)
{
    return right_tests::judged(1e-8, tangent);
}

} // namespace rigor
