// SPDX-License-Identifier: MIT
// Assembles the linear system of backward Euler, A v = M v₀ + h f(x₀). After the solve, the code
// restores the momentum and the angular momentum of each connected piece of the solid that neither
// handles nor contacts hold: its nodes also get the velocities of a rigid motion that has what is
// missing. The forces between nodes add up to no force and no torque in their places x₀. The new
// places are x₀ + h v, so the angular momentum at the end is Σ m x₀ × v.
#include "deformable/motion/velocity_system.hpp"

namespace rigor {

namespace {

// A part that turns by more than this in a step gets no angular momentum back [rad]. Backward Euler
// moves the nodes along tangents, which stretches a part that turns fast; without the loss of
// angular momentum, splinters would spin until they are inside out. Chosen by trial: with 0.2,
// `bench deformable` leaves no element inverted.
constexpr double most_turn = 0.2;

} // namespace

void VelocitySystem::assemble(const Deformable& solid, const ElementWorkspace& elements,
                              const std::vector<HeldNode>& held,
                              const std::vector<Vector3d>& forces, double time_step)
{
    if (!system.is_analysed())
        system.analyse(elements.elements, static_cast<int>(solid.positions.size()));
    tension.find(solid, elements, system.matrix(), held, time_step);
    assemble_matrix(solid, elements, time_step);
    momenta.resize(forces.size());
    for (std::size_t i = 0; i < forces.size(); ++i)
        momenta[i] = solid.masses[i] * solid.velocities[i] + time_step * forces[i];
    velocities = solid.velocities;
}

void VelocitySystem::assemble_matrix(const Deformable& solid, const ElementWorkspace& elements,
                                     double time_step)
{
    system.assemble(elements.elements, elements.strains, solid.masses, solid.material, time_step);
    for (const TurnStiffness& term : tension.terms())
        system.stiffen(elements.elements, term, time_step);
}

void VelocitySystem::restore_momenta(const Deformable& solid, const std::vector<HeldNode>& held,
                                     const std::vector<int>& tied_by, double time_step)
{
    const BlockMatrix& A = system.matrix();
    const std::vector<Vector3d>& x = solid.positions;
    const double slowed = 1 + time_step * solid.material.drag;
    parts_.assign(A.parts(), {});
    for (const HeldNode& h : held)
        parts_[A.part_of(h.node)].is_held = true;
    for (int i = 0; i < static_cast<int>(tied_by.size()); ++i)
        if (tied_by[i] >= 0) parts_[A.part_of(i)].is_held = true;

    for (int i = 0; i < A.nodes(); ++i) {
        Part& part = parts_[A.part_of(i)];
        const double m = solid.masses[i];
        part.mass += m;
        part.X += m * x[i];
        part.start_momentum += m * solid.velocities[i];
        part.momentum += momenta[i] - slowed * m * velocities[i];
    }
    for (Part& part : parts_)
        part.X /= part.mass;
    for (int i = 0; i < A.nodes(); ++i) {
        Part& part = parts_[A.part_of(i)];
        const double m = solid.masses[i];
        const Vector3d d = x[i] - part.X;
        part.whole += d.cross(momenta[i]);
        part.angular_momentum += d.cross(momenta[i] - slowed * m * velocities[i]);
        part.inertia += m * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    for (Part& part : parts_) {
        if (part.is_held) continue;
        part.V = part.momentum / (slowed * part.mass);
        const Eigen::LDLT<Matrix3d> inverse(part.inertia);
        if (time_step * inverse.solve(part.whole).norm() <= most_turn)
            part.omega = inverse.solve(part.angular_momentum) / slowed;
    }
    for (int i = 0; i < A.nodes(); ++i) {
        Part& part = parts_[A.part_of(i)];
        velocities[i] += part.V + part.omega.cross(x[i] - part.X);
        part.end_momentum += solid.masses[i] * velocities[i];
    }
    for (Part& part : parts_)
        if (!part.is_held)
            part.shift = time_step / 2 * (part.start_momentum - part.end_momentum) / part.mass;
}

} // namespace rigor
