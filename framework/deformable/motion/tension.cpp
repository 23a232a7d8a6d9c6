// SPDX-License-Identifier: MIT
// Computes the geometric stiffness of elements under tension from their principal stresses (Smith,
// de Goes and Kim 2019; Teran et al. 2005). A first pass over the elements finds those whose stress
// is large for the mass of their corners. In most scenes there are none. If there are any, the code
// finds for each part the share of the stress that may be left out although the whole part turns,
// and then the terms of these elements.
#include "deformable/motion/tension.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// What is left out is at most m/h² + k, with the letters of the header: a quarter of the mass term
// in the limit 4 m/h² + k. The rest covers the estimates below, and a stress that grows within a
// step.
constexpr double most_left_out = 1;

// The stress at the end of the step [Pa], in world space. A step moves nodes along straight lines.
// So an element that turned by h W in the last step was strained by ½ h² Wᵀ W too much. This step
// removes that strain.
Matrix3d stress_at_end(const Deformable& solid, const ElementWorkspace& work, int e, double h)
{
    const auto [R, elastic] = work.strains[e];
    const auto nodes = work.elements.nodes(e);
    const auto gradients = work.elements.gradients(e);
    Matrix3d L = Matrix3d::Zero(); // ∂v/∂x
    for (int i = 0; i < 4; ++i)
        L += solid.velocities[nodes[i]] * (R * gradients[i]).transpose();
    const Matrix3d W = 0.5 * (L - L.transpose());
    const Matrix3d strain = R * elastic * R.transpose() - 0.5 * h * h * W.transpose() * W;
    const SolidMaterial& m = solid.material;
    Matrix3d stress = 2 * m.shear_modulus() * strain; // σ = λ Tr(ε) δ + 2 G ε
    stress.diagonal().array() += m.lame_lambda() * strain.trace();
    return stress;
}

// Σ |∇Nᵢ|² of an element [1/m²]
double squared_gradients(const Elements& elements, int e)
{
    double sum = 0;
    for (const Vector3d& g : elements.gradients(e))
        sum += g.squaredNorm();
    return sum;
}

// The largest q that may be left out because the corners have mass. The energy of q is at most
// V q |a|²/4, and |a|² ≤ Σ |∇Nᵢ|²/mᵢ Σ mᵢ |uᵢ|², where the element gives each corner the mass
// mᵢ = ρ V/4. So g/m ≤ 2 q Σ |∇Nᵢ|² / ρ.
double left_out_by_mass(double density, double gradients, double time_step)
{
    return most_left_out * density / (2 * time_step * time_step * gradients);
}

// The largest q that may be left out because bending has a stiffness. A bar under the tension σ
// that bends into a wave of the wave number κ has per mass g = σ κ²/ρ and k = E r² κ⁴/ρ, with the
// radius of gyration r of its section (Rayleigh 1877, "The theory of sound", § 189). g - k is at
// most σ²/(4 ρ E r²), and this is 1/h² for σ = 2 r √(ρ E)/h. In a bar that is one or two cells
// thick, r is about half the length l of an element. It is longer in others. The q of σ is σ/2.
double left_out_by_bending(const SolidMaterial& m, double gradients, double time_step)
{
    const double l = 2 / std::sqrt(gradients);
    return 0.5 * l * std::sqrt(most_left_out * m.density * m.youngs_modulus) / time_step;
}

} // namespace

void Tension::find(const Deformable& solid, const ElementWorkspace& work, const BlockMatrix& matrix,
                   const std::vector<HeldNode>& held, double time_step)
{
    const SolidMaterial& m = solid.material;
    const double lambda = m.lame_lambda(), G = m.shear_modulus();
    tense_.clear();
    terms_.clear();
    tense_.reserve(work.elements.size()); // so that only steps with terms need more memory later
    parts_.reserve(matrix.parts());
    for (int e = 0; e < work.elements.size(); ++e) {
        const Matrix3d& strain = work.strains[e].elastic;
        // A sum of two principal stresses is at most √2 ‖σ‖, where ‖σ‖² is 4 G² ‖ε‖² and the part
        // λ (3 λ + 4 G) Tr² ε.
        const double trace = strain.trace(),
                     stress2 = 4 * G * G * strain.squaredNorm() +
                               lambda * (3 * lambda + 4 * G) * trace * trace;
        const double q0 =
            left_out_by_mass(m.density, squared_gradients(work.elements, e), time_step);
        if (0.5 * stress2 > q0 * q0) tense_.push_back(e);
    }
    if (tense_.empty()) return;
    find_shares(solid, work, matrix, held, time_step);
    for (const int e : tense_)
        add_terms(solid, work, e, parts_[matrix.part_of(work.elements.nodes(e)[0])].share,
                  time_step);
}

// A part may turn as a whole, about a hinge, and then nothing bends: k = 0. A turn by the angle ω
// has a = 2 ω in all elements and the stiffness ωᵀ Σ V (Tr σ δ - σ) ω. What is left out of it is at
// most the inertia ωᵀ I ω, divided by h².
void Tension::find_shares(const Deformable& solid, const ElementWorkspace& work,
                          const BlockMatrix& matrix, const std::vector<HeldNode>& held,
                          double time_step)
{
    const std::vector<Vector3d>& x = solid.positions;
    parts_.assign(matrix.parts(), {});
    for (const HeldNode& h : held) {
        Part& part = parts_[matrix.part_of(h.node)];
        part.center += x[h.node];
        ++part.held_nodes;
    }
    for (int i = 0; i < matrix.nodes(); ++i) {
        Part& part = parts_[matrix.part_of(i)];
        part.mass += solid.masses[i];
        if (part.held_nodes == 0) part.center += solid.masses[i] * x[i];
    }
    for (Part& part : parts_)
        part.center /= part.held_nodes > 0 ? part.held_nodes : part.mass;
    for (int i = 0; i < matrix.nodes(); ++i) {
        Part& part = parts_[matrix.part_of(i)];
        const Vector3d d = x[i] - part.center;
        part.inertia +=
            solid.masses[i] * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    for (int e = 0; e < work.elements.size(); ++e) {
        const Matrix3d stress = stress_at_end(solid, work, e, time_step);
        parts_[matrix.part_of(work.elements.nodes(e)[0])].turn +=
            work.elements.volume(e) * (stress.trace() * Matrix3d::Identity() - stress);
    }
    for (Part& part : parts_) {
        const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix3d> turns(part.turn, part.inertia,
                                                                       Eigen::EigenvaluesOnly);
        const double most = time_step * time_step * turns.eigenvalues()[2];
        part.share = most > most_left_out ? most_left_out / most : 1;
    }
}

void Tension::add_terms(const Deformable& solid, const ElementWorkspace& work, int element,
                        double share, double time_step)
{
    const SolidMaterial& m = solid.material;
    const double g2 = squared_gradients(work.elements, element);
    const double by_mass = left_out_by_mass(m.density, g2, time_step),
                 by_bending = left_out_by_bending(m, g2, time_step);
    const Matrix3d stress = stress_at_end(solid, work, element, time_step);
    // No q is larger than ‖σ‖/√2.
    if (share == 1 && 0.5 * stress.squaredNorm() <= by_bending * by_bending) return;
    const Eigen::SelfAdjointEigenSolver<Matrix3d> principal(stress);
    const auto gradients = work.elements.gradients(element);
    for (int k = 0; k < 3; ++k) {
        const double whole = 0.5 * (stress.trace() - principal.eigenvalues()[k]);
        const double q = whole - std::max(by_mass, std::min(by_bending, share * whole));
        if (!(q > 0)) continue;
        const Vector3d n =
            std::sqrt(work.elements.volume(element) * q / 2) * principal.eigenvectors().col(k);
        TurnStiffness term{element, {}};
        for (int i = 0; i < 4; ++i)
            term.c[i] = n.cross(work.strains[element].R * gradients[i]);
        terms_.push_back(term);
    }
}

} // namespace rigor
