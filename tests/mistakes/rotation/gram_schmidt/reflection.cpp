// SPDX-License-Identifier: MIT
// The third column keeps its side, so that a left-handed R stays a reflection, with det -1.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d gram_schmidt(const Matrix3d& R)
{
    Matrix3d Q = R;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < i; ++j)
            Q.col(i) -= Q.col(j).dot(Q.col(i)) * Q.col(j);
        Q.col(i).normalize();
    }
    return Q;
}

} // namespace rigor
