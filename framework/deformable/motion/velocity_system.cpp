// SPDX-License-Identifier: MIT
// Assembles the linear system of backward Euler, A v = M v₀ + h f(x₀). After the solve, the code
// restores the momentum of each connected piece of the solid that neither handles nor contacts
// hold: all nodes of the piece get the same additional velocity, which adds the missing momentum.
#include "deformable/motion/velocity_system.hpp"

namespace rigor {

void VelocitySystem::assemble(const Deformable& solid, const ElementWorkspace& elements,
                              const std::vector<Vector3d>& forces, double time_step)
{
    if (!system.is_analysed())
        system.analyse(elements.elements, static_cast<int>(solid.positions.size()));
    system.assemble(elements.elements, elements.strains, solid.masses, solid.material, time_step);
    momenta.resize(forces.size());
    for (std::size_t i = 0; i < forces.size(); ++i)
        momenta[i] = solid.masses[i] * solid.velocities[i] + time_step * forces[i];
    velocities = solid.velocities;
}

void VelocitySystem::restore_momentum(const Deformable& solid, const std::vector<HeldNode>& held,
                                      const std::vector<int>& tied_by, double time_step)
{
    const BlockMatrix& A = system.matrix();
    is_part_held_.assign(A.parts(), 0);
    for (const HeldNode& h : held)
        is_part_held_[A.part_of(h.node)] = 1;
    for (int i = 0; i < static_cast<int>(tied_by.size()); ++i)
        if (tied_by[i] >= 0) is_part_held_[A.part_of(i)] = 1;
    missing_.assign(A.parts(), {});
    for (int i = 0; i < A.nodes(); ++i) { // the forces between nodes cancel in this sum
        const double m = (1 + time_step * solid.material.drag) * solid.masses[i];
        Missing& part = missing_[A.part_of(i)];
        part.momentum += momenta[i] - m * velocities[i];
        part.mass += m;
    }
    for (int i = 0; i < A.nodes(); ++i) {
        const int p = A.part_of(i);
        if (!is_part_held_[p]) velocities[i] += missing_[p].momentum / missing_[p].mass;
    }
}

} // namespace rigor
