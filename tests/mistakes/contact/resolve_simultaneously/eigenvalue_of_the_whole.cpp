// SPDX-License-Identifier: MIT
// λ is the larger eigenvalue of K in the tangent plane, not the largest of the whole K.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.lambda = [](const VisitedContact& c) {
        return Eigen::SelfAdjointEigenSolver<Matrix3d>(c.K).eigenvalues().maxCoeff();
    };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
