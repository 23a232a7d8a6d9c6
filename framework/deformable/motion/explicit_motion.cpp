// SPDX-License-Identifier: MIT
// Moves the nodes of a solid by substeps of symplectic Euler. Each substep measures the contacts
// and the forces, applies the first half of the forces, lets nodes bounce, applies the second half,
// applies contact impulses and moves the nodes. Then the positions of nodes inside bodies are
// corrected. Last, the elements flow plastically, unless the solid flows only once after each step.
//
// Nodes bounce between the halves, since there the velocity v belongs to the same time as the
// position x. With this v, symplectic Euler conserves v²/2 + (1 - h²ω²/4) ω²x²/2 for a spring of
// frequency ω (Hairer, Lubich and Wanner 2003). A bounce does not increase this quantity, whatever
// the substep h is.
#include "deformable/motion/explicit_motion.hpp"

#include "deformable/contact/node_collisions.hpp"
#include "deformable/elasticity/flow.hpp"
#include "deformable/motion/stable_step.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace rigor {

namespace {

// The longest substep, as a share of the longest one that is stable at rest. It is below 1, because
// large deformations need shorter substeps.
constexpr double safety = 0.9;

// A solid that needs more substeps than this has an element that is almost flat, or far too stiff
// for the step. Its step would take far too long.
constexpr double most_substeps = 1e6;

int substeps_for(const Deformable& solid, double step, double stable)
{
    const double needed = std::ceil(step / (safety * stable));
    if (needed > most_substeps) {
        std::ostringstream text;
        text << "body '" << solid.name
             << "': an element is too thin or too stiff for the step: expected up to "
             << most_substeps << " substeps, found " << std::setprecision(3) << needed;
        throw std::domain_error(text.str());
    }
    return needed > 1 ? static_cast<int>(needed) : 1; // a NaN is reported at the end of the step
}

void add_up_forces(const NodeMotion& motion, double time)
{
    const Deformable& solid = motion.solid;
    auto& f = motion.work.forces;
    std::fill(f.begin(), f.end(), Vector3d::Zero());
    motion.work.elements.add_forces(solid.positions, solid.velocities, f);
    add_loads(solid, motion.gravity, time, f);
}

// v += h f/m, for the time h
void kick(const NodeMotion& motion, double h)
{
    Deformable& solid = motion.solid;
    const auto& f = motion.work.forces;
    for (std::size_t i = 0; i < f.size(); ++i)
        solid.velocities[i] += h / solid.masses[i] * f[i];
}

void slow_down(const NodeMotion& motion, double h)
{
    const double slowed = 1 / (1 + h * motion.solid.material.drag);
    for (Vector3d& v : motion.solid.velocities)
        v *= slowed;
}

} // namespace

void move_explicitly(const NodeMotion& motion)
{
    Deformable& solid = motion.solid;
    Workspace& work = motion.work;
    const double step = motion.time_step;
    if (work.stable_step == 0) work.stable_step = stable_step(solid, work.elements);
    const int substeps = substeps_for(solid, step, work.stable_step);
    const double h = step / substeps;
    motion.counters.deformable_substeps += substeps;
    motion.rigid.begin_substeps();
    for (int k = 0; k < substeps; ++k) {
        const double time = motion.start + k * h;
        hold_nodes(solid, time + h, h, work.held, work.held_entries);
        for (const HeldNode& held : work.held)
            work.held_axes[held.node].axes = held.axes;
        const auto collide = [&](bool with_restitution) {
            collide_nodes(solid, work.held_axes, work.contacts, motion.rigid, h, with_restitution,
                          motion.counters);
        };
        motion.rigid.fall(h);
        work.contacts.measure(solid, motion.rigid);
        add_up_forces(motion, time);
        kick(motion, h / 2);
        move_held(work.held, solid.velocities);
        collide(true);
        kick(motion, h / 2);
        slow_down(motion, h);
        move_held(work.held, solid.velocities);
        collide(false);
        // A solid that touches nothing falls with the mean of its velocities before and after.
        const bool is_free = work.held.empty() && work.contacts.all().empty();
        const Vector3d back = is_free ? Vector3d(-h * h / 2 * motion.gravity) : Vector3d::Zero();
        for (std::size_t i = 0; i < solid.positions.size(); ++i)
            solid.positions[i] += h * solid.velocities[i] + back;
        correct_node_positions(solid, work.held_axes, work.contacts, h / step, h * motion.radius);
        if (flows_in_step(solid)) {
            work.elements.strains(solid.positions, work.strains);
            flow(solid, work, motion.rigid.world.settings, motion.counters);
        }
        motion.rigid.advance(h);
        for (const HeldNode& held : work.held)
            work.held_axes[held.node] = {};
    }
    motion.rigid.end_substeps();
}

} // namespace rigor
