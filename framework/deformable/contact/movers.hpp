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
    bool is_carried = false; // whether other rigid bodies hold against it
    /// The momentum (P, L) is `mass` times (V, ω) [kg, kg m, kg m²].
    Matrix6d mass = Matrix6d::Identity(), inverse_mass = Matrix6d::Zero();
    /// By gravity, springs, applied forces and drag, as far as what carries it lets it move
    /// [m/s², rad/s²].
    Vector3d acceleration = Vector3d::Zero(), angular_acceleration = Vector3d::Zero();

    /// The change of a point's velocity by an impulse there.
    Matrix3d impulse_matrix_at(const Vector3d& point) const;
    void push(const Vector3d& point, const Vector3d& impulse);
};

struct Movers {
    std::vector<Mover> all;
    std::vector<int> of; // for each body, the index of its mover

    const Mover& by(int body) const { return all[of[body]]; }
};

/// The movers of a world at the start of a step of this length.
Movers movers_of(const World& world, double time_step);

} // namespace rigor
