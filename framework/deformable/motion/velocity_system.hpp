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
    /// @param strains  as the step begins
    /// @param forces   of loads and gravity on each node; elastic forces are added [N]
    void assemble(const Deformable& solid, const ElementWorkspace& elements,
                  const std::vector<Vector3d>& forces, double time_step);

    /// Gives each part that neither handles nor contacts hold its whole momentum, which conjugate
    /// gradients keep to their tolerance only.
    ///
    /// @param tied_by  for each node the contact that ties it; -1: none
    void restore_momentum(const Deformable& solid, const std::vector<HeldNode>& held,
                          const std::vector<int>& tied_by, double time_step);

    ImplicitSystem system;
    std::vector<Vector3d> momenta;    // b of each node [N s]
    std::vector<Vector3d> velocities; // v of each node [m/s]
    std::vector<TiedNode> ties;       // ties in the latest solve

private:
    /// Momentum that a part of the solid lacks [N s], and its mass [kg].
    struct Missing {
        Vector3d momentum = Vector3d::Zero();
        double mass = 0;
    };
    std::vector<char> is_part_held_;
    std::vector<Missing> missing_; // for each part
};

} // namespace rigor
