// SPDX-License-Identifier: MIT
// The small numbers beside the derivations of the handouts.
#include "formulas/kinematics.hpp"
#include "formulas/plasticity.hpp"
#include "formulas/rotation.hpp"
#include "handouts/numbers.hpp"
#include "support/catch.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::handouts;

TEST_CASE("A1: steps of the derivation", "[numbers]")
{
    const Vector3d X = Vector3d::Zero(), V = Vector3d::Zero(), w(0, 0, 2), x(0, 3, 0);
    check_shown("A1", "gets $(-6, 0, 0)$ besides $V$", listed(point_velocity(V, w, X, x)));
}

TEST_CASE("A3: steps of the derivation", "[numbers]")
{
    // a third of a turn about (1, 1, 1)
    Quaternion third;
    third.s = 0.5;
    third.v = Vector3d::Constant(0.5);
    check_shown("A3", "it is $(0, 1, 0)$: the x axis", listed(to_matrix(third).col(0)));

    // Euler's equations of the box, near a spin of 2 rad/s about its middle axis
    const Vector3d J(13, 10, 5);
    const auto rate = [&](const Vector3d& w) {
        return Vector3d(-w.cross(Vector3d(J.cwiseProduct(w))));
    };
    const double of_x = rate({0, 2, 1}).x(), of_z = rate({1, 2, 0}).z();
    check_shown("A3",
                R"($13\, \dot\omega_x = 10\, \omega_z$ and $5\, \dot\omega_z = 6\, \omega_x$)",
                {J.x(), of_x, J.z(), of_z});
    const double square = of_x / J.x() * of_z / J.z();
    check_shown("A3", R"($\lambda = \sqrt{12/13} = 0.9608$ per second)",
                {square, std::sqrt(square)});
}

TEST_CASE("A6: steps of the derivation", "[numbers]")
{
    const Matrix3d stress = Vector3d(3, 2, 1).asDiagonal();
    check_shown("A6", "and half of their sum is 3.", {std::pow(von_mises_principal(3, 2, 1), 2)});
    check_shown("A6", "which is 3 too.", {std::pow(von_mises_frobenius(stress), 2)});

    const double E = 200e9, nu = 0.3, sigma_Y = 250e6;
    const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), G = E / (2 * (1 + nu));
    Matrix3d plastic = Matrix3d::Zero(), total = Matrix3d::Zero();
    const auto stretched = [&](double e) {
        total(0, 0) = e;
        plastic = plastic_flow(plastic, isotropic_stress(total - plastic, lambda, G), sigma_Y, G);
    };
    stretched(0.005);
    const double mean = isotropic_stress(total - plastic, lambda, G).trace() / 3;
    check_shown("A6", "times $e$: 833.333333 MPa at 0.005.", {mean / 1e6, total(0, 0)});
    const double out = plastic(0, 0);
    check_shown("A6", "= 0.00225$. On the way back", {out});
    stretched(0);
    const double back = out - plastic(0, 0);
    check_shown("A6", "250 MPa times these two, 562500 and 291666.6667 J/m³",
                {sigma_Y / 1e6, sigma_Y * out, sigma_Y * back});
}
