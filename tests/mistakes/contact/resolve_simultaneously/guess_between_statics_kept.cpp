// SPDX-License-Identifier: MIT
// Between two static bodies there is no impulse, whatever was guessed.
#include "mistakes/contact/one_contact.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactResult result{bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const BodyContact& c = contacts[i];
        result.impulses[i] = c.impulse;
        apply(result.bodies, c, c.impulse);
    }
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const BodyContact& c = contacts[i];
            const Vector3d& n = c.normal;
            const Matrix3d K = impulse_matrix_of(bodies, c);
            if (K.isZero(0)) continue;
            const Vector3d v = velocity_of(result.bodies, c), j = result.impulses[i];
            const double v_n = v.dot(n);
            const double j_n = std::max(0.0, j.dot(n) - (v_n - c.separation_speed) / n.dot(K * n));
            const double lambda = larger_eigenvalue(K, n);
            const Vector3d v_T = v - v_n * n;
            Vector3d j_T = j - j.dot(n) * n - v_T / lambda;
            if (j_T.norm() > c.friction * j_n) j_T *= c.friction * j_n / j_T.norm();
            result.impulses[i] = j_n * n + j_T;
            apply(result.bodies, c, result.impulses[i] - j);
        }
    }
    return result;
}

} // namespace rigor
