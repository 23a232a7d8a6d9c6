// SPDX-License-Identifier: MIT
// Applies impulses and position correction at the contacts of nodes, one contact after the other.
// The impulse is `collision_impulse` of assignment A4, between the node as a point mass and the
// rigid body. The position correction is like that of rigid bodies (position_correction.hpp), but
// without a slop, and only the node moves. It removes a part of the penetration without a change of
// velocities (Catto 2014).
#include "deformable/contact/node_collisions.hpp"

#include "formulas/collision.hpp"

#include <algorithm>

namespace rigor {

namespace {

// A node as a rigid body: a point mass at the position of the node.
Body node_body(const Deformable& solid, int node, double inverse_mass)
{
    Body body;
    body.inverse_mass = inverse_mass;
    body.position = solid.positions[node];
    body.velocity = solid.velocities[node];
    return body;
}

} // namespace

void collide_nodes(Deformable& solid, const std::vector<char>& is_held,
                   const NodeContacts& contacts, RigidColliders& rigid, double time_step,
                   bool with_restitution, Counters& counters)
{
    // A contact rests if its rebound would be slower than this [m/s]: gravity stops such a rebound
    // within twice `time_step`.
    const double resting_speed = 2 * time_step * rigid.world.settings.gravity.norm();
    for (const NodeContact& c : contacts.all()) {
        const Vector3d x = solid.positions[c.node], n = c.normal;
        const double inverse_mass = is_held[c.node] ? 0 : 1 / solid.masses[c.node];
        const Body& body = rigid.bodies[c.body];
        if (inverse_mass == 0 && body.is_static()) continue;
        const Vector3d v = relative_velocity(node_body(solid, c.node, inverse_mass), body, x);
        const double v_n = v.dot(n);
        if (v_n >= 0 || c.gap + time_step * v_n >= 0) continue;
        if (with_restitution && (c.restitution == 0 || -c.restitution * v_n < resting_speed))
            continue;
        const Matrix3d K =
            inverse_mass * Matrix3d::Identity() +
            impulse_matrix(body.inverse_mass, body.inverse_inertia, body.position, x);
        // Without restitution, a node may still close its gap within the time step, so only the
        // approach speed above gap / time_step is removed.
        const Vector3d closing = with_restitution ? v : v + std::max(c.gap, 0.0) / time_step * n;
        const Vector3d j =
            collision_impulse(K, closing, n, with_restitution ? c.restitution : 0.0, c.friction);
        solid.velocities[c.node] += inverse_mass * j;
        rigid.push(c.body, x, -j);
        ++counters.node_impulses;
    }
}

void correct_node_positions(Deformable& solid, const std::vector<char>& is_held,
                            const NodeContacts& contacts, double step_share, double farthest)
{
    // Share of the penetration that a step removes. It is small enough that resting nodes do not
    // jitter.
    constexpr double corrected_share = 0.2;
    for (const NodeContact& c : contacts.all()) {
        if (c.gap >= 0 || is_held[c.node]) continue;
        solid.positions[c.node] +=
            std::min(corrected_share * step_share * -c.gap, farthest) * c.normal;
    }
}

} // namespace rigor
