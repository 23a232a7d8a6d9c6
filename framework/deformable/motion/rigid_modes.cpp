// SPDX-License-Identifier: MIT
// Moves the nodes of a solid as particles of one rigid body (lecture "Rigid bodies", "Constrained
// dynamics"). The code takes the generalized velocity u = (V, ω) from the momenta of the nodes,
// then u̇ from the generalized mass and the forces, and then moves the nodes.
#include "deformable/motion/rigid_modes.hpp"

#include "deformable/elasticity/totals.hpp"
#include "deformable/solid/handles.hpp"
#include "deformable/solid/rigid_motion.hpp"
#include "formulas/kinematics.hpp"
#include "formulas/rotation.hpp"

namespace rigor {

namespace {

// The motion at the start of a step, about the center of mass X.
struct Modes {
    Vector3d X;
    Vector6d u, u_dot; // u = (V, ω) [m/s, rad/s], and its time derivative

    Vector3d velocity() const { return u.head<3>(); }
    Vector3d angular_velocity() const { return u.tail<3>(); }
};

Modes modes_of(const NodeMotion& motion)
{
    const Deformable& solid = motion.solid;
    const std::size_t count = solid.positions.size();
    Modes modes;
    modes.X = totals(solid).center_of_mass;
    std::vector<Vector3d> forces(count, Vector3d::Zero());
    add_loads(solid, motion.gravity, motion.start, forces);

    std::vector<Particle> particles;
    Vector6d momentum = Vector6d::Zero(), force = Vector6d::Zero();
    for (std::size_t i = 0; i < count; ++i) {
        particles.push_back({solid.masses[i], solid.positions[i]});
        const Matrix36d S = velocity_modes(modes.X, solid.positions[i]);
        momentum += solid.masses[i] * S.transpose() * solid.velocities[i];
        force += S.transpose() * forces[i];
    }
    const Matrix6d mass = generalized_mass(particles, modes.X);
    const Eigen::LDLT<Matrix6d> inverse(mass);
    // u follows from the velocities v of the nodes: (Sᵀ M S) u = Sᵀ M v. So the rigid motion S u
    // has the momentum and the angular momentum of the nodes.
    modes.u = inverse.solve(momentum);
    // u̇ follows from the forces F on the nodes: (Sᵀ M S) u̇ = Sᵀ F - (Sᵀ M Ṡ) u.
    const Wrench inertial =
        inertial_wrench(particles, modes.X, modes.velocity(), modes.angular_velocity());
    modes.u_dot = inverse.solve(force - stacked(inertial.force, inertial.torque));
    return modes;
}

// Gives each node the velocity V + ω × (x - X) at its current position x, where u = (V, ω).
void set_velocities(Deformable& solid, const Vector3d& X, const Vector6d& u)
{
    for (std::size_t i = 0; i < solid.positions.size(); ++i)
        solid.velocities[i] = velocity_modes(X, solid.positions[i]) * u;
}

} // namespace

void move_in_modes(const NodeMotion& motion)
{
    Deformable& solid = motion.solid;
    const double h = motion.time_step;
    const Modes modes = modes_of(motion);
    for (Vector3d& x : solid.positions) {
        const Matrix36d S = velocity_modes(modes.X, x);
        const Vector3d v = S * modes.u;
        // v̇ = S u̇ + Ṡ u
        const Vector3d v_dot = S * modes.u_dot + velocity_mode_rates(modes.velocity(), v) * modes.u;
        x += h * v + h * h / 2 * v_dot;
    }
    const Vector3d X = modes.X + h * modes.velocity() + h * h / 2 * modes.u_dot.head<3>();
    set_velocities(solid, X, modes.u + h * modes.u_dot);
}

void move_by_matrix(const NodeMotion& motion)
{
    Deformable& solid = motion.solid;
    const double h = motion.time_step;
    const Modes modes = modes_of(motion);
    // The formula advances R to R + h ω* R, with the cross-product matrix ω*. If x - X = R p, then
    // (R + h ω* R) p = (δ + h ω*) (x - X), so R itself need not be known.
    const Matrix3d turn = advance_matrix(Matrix3d::Identity(), modes.angular_velocity(), h);
    const Vector3d X_new = modes.X + h * modes.velocity();
    for (Vector3d& x : solid.positions)
        x = X_new + turn * (x - modes.X);
    set_velocities(solid, X_new, modes.u + h * modes.u_dot);
}

} // namespace rigor
