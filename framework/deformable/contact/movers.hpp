// SPDX-License-Identifier: MIT
// The rigid bodies, or groups of them, that move when a deformable solid pushes a rigid body.
#pragma once

#include "rigid/bodies/world.hpp"

#include <vector>

namespace rigor {

/// What moves when a solid pushes a rigid body. Bodies that rested on each other in the previous
/// step, and on nothing static, form one mover, which moves as one rigid body: a solid that carries
/// a stack feels the mass of the whole stack. Any other body is a mover of its own. If rigid bodies
/// support a mover, it does not yield to a push against these supports.
struct Mover {
    /// The body, or the group of bodies as one body. It is static if the body is static, driven or
    /// asleep.
    Body body;
    Body start; // `body` before the solids moved
    /// The momentum (P, L) is `free_mass` times (V, ω) [kg, kg m, kg m²]. `mass` is `free_mass`
    /// plus a very large mass in the directions of the supports. `inverse_mass` is set only if
    /// there are supports.
    Matrix6d free_mass = Matrix6d::Identity(), mass = Matrix6d::Identity(),
             inverse_mass = Matrix6d::Zero();
    std::vector<Vector3d> supports; // directions of the forces by which rigid bodies support it
    /// The accelerations by gravity, springs, applied forces and drag [m/s², rad/s²], close to 0
    /// in the directions of the supports.
    Vector3d acceleration = Vector3d::Zero(), angular_acceleration = Vector3d::Zero();

    /// Whether other rigid bodies support the mover.
    bool is_carried() const { return !supports.empty(); }
    /// Whether no support opposes a push in this direction.
    bool yields(const Vector3d& push) const;
    /// The matrix K [1/kg] by which an impulse j at a point of the mover changes the velocity of
    /// this point, namely by K j. With supports, K depends on the direction `push` of j.
    Matrix3d impulse_matrix_at(const Vector3d& point, const Vector3d& push) const;
    void push(const Vector3d& point, const Vector3d& impulse);
};

struct Movers {
    std::vector<Mover> all;
    std::vector<int> of; // for each body, the index of its mover in `all`

    const Mover& by(int body) const { return all[of[body]]; }
};

/// The movers of a world at the start of a step of this length [s].
/// @param world  is not changed: the function restores the counters that its prediction changes
Movers movers_of(World& world, double time_step);

} // namespace rigor
