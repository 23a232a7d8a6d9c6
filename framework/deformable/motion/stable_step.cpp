// SPDX-License-Identifier: MIT
// Computes the longest stable substep of symplectic Euler from a bound on the highest frequency of
// each element (Irons and Treharne 1971). The code shares the mass of each node among its elements
// in proportion to their stiffness, bounds the largest eigenvalue of each element, and converts the
// largest of these bounds to a substep.
#include "deformable/motion/stable_step.hpp"

#include <cmath>

namespace rigor {

namespace {

// The matrix B of a node of an element: a displacement u of this node alone strains the element by
// ε = B u = ½ (u gᵀ + g uᵀ), written as (xx, yy, zz, √2 xy, √2 xz, √2 yz), a vector of norm ‖ε‖.
// @param g  ∇N, the gradient of the node's shape function in the element [1/m]
Eigen::Matrix<double, 6, 3> strain_of_motion(const Vector3d& g)
{
    const double r = std::sqrt(0.5);
    Eigen::Matrix<double, 6, 3> B;
    B << g.x(), 0, 0, 0, g.y(), 0, 0, 0, g.z(), r * g.y(), r * g.x(), 0, r * g.z(), 0, r * g.x(), 0,
        r * g.z(), r * g.y();
    return B;
}

// C^½, the square root of the elastic stiffness C with C ε = λ Tr(ε) δ + 2 G ε.
Matrix6d stiffness_root(const SolidMaterial& material)
{
    const double G2 = 2 * material.shear_modulus(), bulk = 3 * material.lame_lambda() + G2;
    Matrix6d root = std::sqrt(G2) * Matrix6d::Identity();
    root.topLeftCorner<3, 3>().array() += (std::sqrt(bulk) - std::sqrt(G2)) / 3;
    return root;
}

// An upper bound of the largest eigenvalue of a symmetric, positive semi-definite matrix, at most
// 3 % above it: (Tr A⁶⁴)^(1/64).
double eigenvalue_bound(Matrix6d A)
{
    double log_scale = 0;
    int power = 1;
    for (; power < 64; power *= 2) {
        const double trace = A.trace();
        if (!(trace > 0)) return 0;
        A /= trace;
        log_scale += std::log(trace) / power;
        A = (A * A).eval();
    }
    return std::exp(log_scale + std::log(A.trace()) / power);
}

} // namespace

double stable_step(const Deformable& solid, const Elements& elements)
{
    std::vector<double> stiffness(solid.rest.vertices.size(), 0.0);
    for (int e = 0; e < elements.size(); ++e) {
        const auto nodes = elements.nodes(e);
        const auto gradients = elements.gradients(e);
        for (int i = 0; i < 4; ++i)
            stiffness[nodes[i]] += elements.volume(e) * gradients[i].squaredNorm();
    }
    const Matrix6d root = stiffness_root(solid.material);
    double omega2 = 0;
    for (int e = 0; e < elements.size(); ++e) {
        const auto nodes = elements.nodes(e);
        const auto gradients = elements.gradients(e);
        Matrix6d A = Matrix6d::Zero(); // Σ V/m_i B_i B_iᵀ over the corners i of the element
        for (int i = 0; i < 4; ++i) {
            // m_i = m V|∇N|² / s: the element's share of the mass m of its node. Here s
            // (`stiffness`) is V|∇N|², summed over all elements of the node. V cancels in V/m_i.
            const double inverse_mass =
                stiffness[nodes[i]] / (solid.masses[nodes[i]] * gradients[i].squaredNorm());
            const Eigen::Matrix<double, 6, 3> B = strain_of_motion(gradients[i]);
            A += inverse_mass * (B * B.transpose());
        }
        omega2 = std::max(omega2, eigenvalue_bound(root * A * root));
    }
    const double beta = solid.material.damping;
    if (omega2 == 0) return never;
    // √(β² + 4/ω²) - β, in a form without cancellation
    return 4 / omega2 / (std::sqrt(beta * beta + 4 / omega2) + beta);
}

} // namespace rigor
