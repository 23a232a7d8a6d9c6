// SPDX-License-Identifier: MIT
// A formula that allocates memory without end, a megabyte at a time.
#include "formulas/kinematics.hpp"

#include <list>
#include <vector>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    std::list<std::vector<char>> hoard;
    for (;;)
        hoard.emplace_back(std::size_t{1} << 20, 'x');
}

} // namespace rigor
