// SPDX-License-Identifier: MIT
// The linear system of one implicit step, with its right-hand side and its solution.
#pragma once

#include "deformable/elasticity/element_workspace.hpp"
#include "deformable/solid/handles.hpp"
#include "deformable/solvers/implicit_system.hpp"

namespace rigor {

/// A v = b for the velocities v of a solid's nodes at the end of a step.
struct VelocitySystem {
    /// Assembles A and b = M v₀ + h f(x₀), and starts v from v₀.
    ///
    /// @param elements  contains the strains at the start of the step
    /// @param forces    sum of elastic forces, loads and gravity on each node [N]
    void assemble(const Deformable& solid, const ElementWorkspace& elements,
                  const std::vector<Vector3d>& forces, double time_step);

    /// Restores the exact momentum of each part (connected piece of the solid) that neither handles
    /// nor contacts hold. Conjugate gradients conserve it only up to their tolerance.
    ///
    /// @param tied_by  for each node, the contact that prescribes its velocity, or -1 for none
    void restore_momentum(const Deformable& solid, const std::vector<HeldNode>& held,
                          const std::vector<int>& tied_by, double time_step);

    ImplicitSystem system;
    std::vector<Vector3d> momenta;    // b for each node [N s]
    std::vector<Vector3d> velocities; // v for each node [m/s]
    std::vector<TiedNode> ties;       // the prescribed velocities of nodes in the latest solve

private:
    /// The missing momentum of a part of the solid [N s], and the mass of this part [kg] times
    /// 1 + α h, with the drag α and the time step h.
    struct Missing {
        Vector3d momentum = Vector3d::Zero();
        double mass = 0;
    };
    std::vector<char> is_part_held_;
    std::vector<Missing> missing_; // for each part
};

} // namespace rigor
