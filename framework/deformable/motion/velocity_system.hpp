// SPDX-License-Identifier: MIT
// The linear system of one implicit step, with its right-hand side and its solution.
#pragma once

#include "deformable/elasticity/element_workspace.hpp"
#include "deformable/motion/tension.hpp"
#include "deformable/solvers/implicit_system.hpp"

namespace rigor {

/// A v = b for the velocities v of a solid's nodes at the end of a step.
struct VelocitySystem {
    /// Assembles A and b = M v₀ + h f(x₀), and starts v from v₀.
    ///
    /// @param elements  contains the strains at the start of the step
    /// @param held      the nodes that handles hold
    /// @param forces    sum of elastic forces, loads and gravity on each node [N]
    void assemble(const Deformable& solid, const ElementWorkspace& elements,
                  const std::vector<HeldNode>& held, const std::vector<Vector3d>& forces,
                  double time_step);

    /// Restores the exact momentum and angular momentum of each free part: a connected piece of the
    /// solid that neither handles nor contacts hold. Conjugate gradients conserve the momentum only
    /// up to their tolerance. The angular momentum also changes because the matrix has constant
    /// rotations, and because the damping -β K v acts on the rotation of a stretched solid. A part
    /// that turns by more than 0.2 rad in the step gets its momentum alone.
    ///
    /// @param tied_by  for each node, the contact that prescribes its velocity, or -1 for none
    void restore_momenta(const Deformable& solid, const std::vector<HeldNode>& held,
                         const std::vector<int>& tied_by, double time_step);

    /// How far each node of a free part has to be moved back after a step with the new velocity, so
    /// that the center of mass moves with the mean of its velocities at the start and at the end;
    /// 0 for other nodes [m]. Known after `restore_momenta`.
    const Vector3d& shift(int node) const { return parts_[system.matrix().part_of(node)].shift; }

    /// Computes A again as `assemble` did, without plastic flow.
    void assemble_matrix(const Deformable& solid, const ElementWorkspace& elements,
                         double time_step);

    ImplicitSystem system;
    Tension tension;                  // its terms are in A
    std::vector<Vector3d> momenta;    // b for each node [N s]
    std::vector<Vector3d> velocities; // v for each node [m/s]
    std::vector<TiedNode> ties;       // the prescribed velocities of nodes in the latest solve

private:
    // A connected piece of the solid.
    struct Part {
        bool is_held = false;                       // by handles or contacts; then nothing is added
        double mass = 0;                            // [kg]
        Vector3d X = Vector3d::Zero();              // center of mass at the start [m]
        Vector3d start_momentum = Vector3d::Zero(); // at the start of the step [N s]
        Vector3d end_momentum = Vector3d::Zero();   // at its end [N s]
        Vector3d momentum = Vector3d::Zero();       // missing after the solve [N s]
        Vector3d whole = Vector3d::Zero(); // angular momentum that it should have [kg m²/s]
        Vector3d angular_momentum = Vector3d::Zero(); // missing after the solve, about X [kg m²/s]
        Matrix3d inertia = Matrix3d::Zero();          // about X [kg m²]
        Vector3d V = Vector3d::Zero(), omega = Vector3d::Zero(); // what is added [m/s, rad/s]
        Vector3d shift = Vector3d::Zero();                       // see `shift` [m]
    };
    std::vector<Part> parts_;
};

} // namespace rigor
