// SPDX-License-Identifier: MIT
// Moves the nodes of a solid by one step of backward Euler, linearized at the start of the step
// with constant rotations of the elements (Baraff and Witkin 1998, "Large steps in cloth
// simulation"; Müller and Gross 2004), unless tension is large (tension.hpp). First restitution
// acts on the velocities. Then the linear system is solved, in a limited number of rounds, until
// neither the contacts nor the plastic flow change. The momenta that rounding and tolerances cost
// are restored, and the impulses are applied to the rigid bodies. Last, held nodes push bodies, the
// nodes move with their new velocities, and positions are corrected.
#include "deformable/motion/implicit_motion.hpp"

#include "deformable/contact/node_collisions.hpp"

#include <algorithm>

namespace rigor {

namespace {

// The largest number of solves of the linear system for the same plastic flow. Contacts that still
// change after these rounds stay as they are; the next step begins with a new guess. Most steps
// take less than five. A block that friction just holds on a slope takes some tens in its first
// steps; with fewer, it would creep down for ever.
constexpr int most_rounds = 100;
// The largest number of times in a step that the plastic flow is linearized. After each of them,
// the system is solved in up to `most_rounds` further rounds.
constexpr int most_flow_rounds = 20;

Matrix3d axes_of(const HeldNode& held)
{
    return Vector3d(held.axes[0], held.axes[1], held.axes[2]).asDiagonal();
}

void assemble_system(const NodeMotion& motion)
{
    const Deformable& solid = motion.solid;
    Workspace& work = motion.work;
    work.elements.strains(solid.positions, work.strains);
    std::fill(work.forces.begin(), work.forces.end(), Vector3d::Zero());
    work.elements.add_elastic_forces(solid.positions, work.forces);
    add_loads(solid, motion.gravity, motion.start, work.forces);
    work.velocity_system.assemble(solid, work, work.held, work.forces, motion.time_step);
}

// An open part is a connected piece of the solid that the next solve includes, and a joined body is
// a rigid body that the system can include. If an open part has a contact with a joined body, this
// function opens all other parts that have a contact with any joined body, because parts that touch
// the same body have to be solved for together.
// @return whether an open part has a contact with a joined body
bool open_coupled_parts(Workspace& work)
{
    if (work.bodies.is_empty()) return false;
    const auto is_joined = [&](const NodeContact& c) { return work.bodies.number(c.body) >= 0; };
    const auto& contacts = work.contacts.all();
    const bool any = std::any_of(contacts.begin(), contacts.end(), [&](const NodeContact& c) {
        return is_joined(c) && work.parts.is_open(c.node);
    });
    if (any)
        for (const NodeContact& c : contacts)
            if (is_joined(c)) work.parts.open(c.node);
    return any;
}

void tie_nodes(Workspace& work)
{
    std::vector<TiedNode>& ties = work.velocity_system.ties;
    ties.clear();
    for (const HeldNode& held : work.held)
        if (work.parts.is_open(held.node))
            ties.push_back({held.node, axes_of(held), held.velocity, -1, Vector3d::Zero(), 0});
    work.contact_set.choose_ties();
    const auto& contacts = work.contacts.all();
    for (int k = 0; k < static_cast<int>(contacts.size()); ++k)
        if (work.contact_set.is_tied(k) && work.parts.is_open(contacts[k].node))
            ties.push_back(work.contact_set.tie(k));
}

void note_impulses(Workspace& work)
{
    const auto& contacts = work.contacts.all();
    if (contacts.empty()) return;
    VelocitySystem& s = work.velocity_system;
    const auto& impulses = s.system.residual(s.momenta, work.parts.nodes(), s.velocities);
    for (int k = 0; k < static_cast<int>(contacts.size()); ++k)
        if (work.contact_set.is_tied(k) && work.parts.is_open(contacts[k].node))
            work.contact_set.set_impulse(k, impulses[contacts[k].node]);
}

// Revises the contacts of the parts that were solved for. If a contact of a part changed, the part
// stays open, so it is solved for again.
void revise_contacts(Workspace& work)
{
    const VelocitySystem& s = work.velocity_system;
    const auto& contacts = work.contacts.all();
    work.parts.close_all();
    for (int k = 0; k < static_cast<int>(contacts.size()); ++k) {
        const int node = contacts[k].node;
        if (work.parts.was_open(node) &&
            work.contact_set.revise(k, s.velocities[node], s.system.matrix().diagonal(node)))
            work.parts.open(node);
    }
}

void solve_with_contacts(const NodeMotion& motion)
{
    Workspace& work = motion.work;
    VelocitySystem& s = work.velocity_system;
    for (int round = 0; round < most_rounds; ++round) {
        const bool with_bodies = open_coupled_parts(work);
        if (!work.parts.collect_nodes()) break;
        tie_nodes(work);
        auto& bodies = with_bodies ? work.bodies.restart() : work.no_bodies;
        motion.counters.solver_iterations +=
            s.system.solve(s.momenta, work.parts.nodes(), s.ties, bodies, s.velocities);
        ++motion.counters.system_solves;
        note_impulses(work);
        revise_contacts(work);
    }
}

// Solves the system, and solves it again for those parts in which the plastic flow of an element
// differs from what the previous solve has assumed.
void solve_with_flow(const NodeMotion& motion)
{
    Workspace& work = motion.work;
    work.parts.open_all(work.velocity_system.system.matrix());
    solve_with_contacts(motion);
    if (!flows_in_step(motion.solid)) return;
    FlowInStep& flow = work.flow_in_step;
    flow.start(motion.solid, work, motion.rigid.world.settings, motion.time_step);
    for (int round = 0; round < most_flow_rounds && flow.revise(work.velocity_system); ++round) {
        work.parts.close_all();
        for (const int e : flow.changed())
            work.parts.open(work.elements.nodes(e)[0]);
        solve_with_contacts(motion);
    }
}

void push_bodies(const NodeMotion& motion)
{
    const auto& contacts = motion.work.contacts.all();
    const ContactSet& set = motion.work.contact_set;
    for (int k = 0; k < static_cast<int>(contacts.size()); ++k) {
        if (!set.is_tied(k)) continue;
        const NodeContact& c = contacts[k];
        motion.rigid.push(c.body, motion.solid.positions[c.node], -set.impulse(k));
        ++motion.counters.node_impulses;
    }
}

} // namespace

void move_implicitly(const NodeMotion& motion)
{
    Deformable& solid = motion.solid;
    Workspace& work = motion.work;
    const double h = motion.time_step;
    ++motion.counters.deformable_substeps;
    hold_nodes(solid, motion.start + h, h, work.held, work.held_entries);
    for (const HeldNode& held : work.held)
        work.held_axes[held.node].axes = held.axes;
    work.contacts.measure(solid, motion.rigid);
    collide_nodes(solid, work.held_axes, work.contacts, motion.rigid, h, true, motion.counters);

    assemble_system(motion);
    const auto& contacts = work.contacts.all();
    work.bodies.join(motion.rigid, contacts, h);
    work.contact_set.guess({solid, motion.rigid, work.bodies, contacts, work.held_axes,
                            motion.gravity, h, motion.radius});
    solve_with_flow(motion);
    work.velocity_system.restore_momenta(solid, work.held, work.contact_set.tied_by(), h);

    push_bodies(motion);
    solid.velocities = work.velocity_system.velocities;
    push_by_held_nodes(solid, work.held_axes, work.contacts, motion.rigid, h, motion.counters);
    for (std::size_t i = 0; i < solid.positions.size(); ++i)
        solid.positions[i] +=
            h * solid.velocities[i] + work.velocity_system.shift(static_cast<int>(i));
    correct_node_positions(solid, work.held_axes, work.contacts, 1, h * motion.radius);
    for (const HeldNode& held : work.held)
        work.held_axes[held.node] = {};
}

} // namespace rigor
