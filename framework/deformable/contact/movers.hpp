// SPDX-License-Identifier: MIT
// What moves when a deformable solid pushes a rigid body.
#pragma once

#include "rigid/bodies/world.hpp"

#include <vector>

namespace rigor {

/// Bodies that lay on each other in the step before, and on nothing static, move as one rigid body,
/// the mover: a solid that carries a stack feels the mass of all its bodies. For all others the
/// mover is the body itself. If rigid bodies carry it, it does not yield where they hold against
/// it.
struct Mover {
    /// Static: a static or driven body, or one that sleeps.
    Body body;
    Body start; // before the solids moved
    /// The momentum (P, L) is `free_mass` times (V, ω) [kg, kg m, kg m²]. `mass` is very large
    /// where rigid bodies hold against the mover; its inverse is set only then.
    Matrix6d free_mass = Matrix6d::Identity(), mass = Matrix6d::Identity(),
             inverse_mass = Matrix6d::Zero();
    std::vector<Vector3d> supports; // the directions of the forces by which rigid bodies carry it
    /// By gravity, springs, applied forces and drag, as far as what carries it lets it move
    /// [m/s², rad/s²].
    Vector3d acceleration = Vector3d::Zero(), angular_acceleration = Vector3d::Zero();

    /// Whether other rigid bodies hold against it.
    bool is_carried() const { return !supports.empty(); }
    /// Whether no rigid body holds against a push in this direction.
    bool yields(const Vector3d& push) const;
    /// The change of a point's velocity by an impulse there, if it pushes in this direction.
    Matrix3d impulse_matrix_at(const Vector3d& point, const Vector3d& push) const;
    void push(const Vector3d& point, const Vector3d& impulse);
};

struct Movers {
    std::vector<Mover> all;
    std::vector<int> of; // for each body, the index of its mover

    const Mover& by(int body) const { return all[of[body]]; }
};

/// The movers of a world at the start of a step of this length.
/// @param world  only its counters change, and are set back
Movers movers_of(World& world, double time_step);

} // namespace rigor
