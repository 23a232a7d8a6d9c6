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

// Share of the penetration that a step removes. It is small enough that resting nodes do not
// jitter.
constexpr double corrected_share = 0.2;

// A node as a rigid body: a point mass at the position of the node.
Body node_body(const Deformable& solid, int node, double inverse_mass)
{
    Body body;
    body.inverse_mass = inverse_mass;
    body.position = solid.positions[node];
    body.velocity = solid.velocities[node];
    return body;
}

// The impulse of a static body on a node for which handles prescribe some coordinates. The function
// calls `collision_impulse` for the free coordinates, with the direction m in place of the normal
// n. The velocity along m is chosen so that it corresponds to the whole normal velocity n·v. The
// coefficient of friction is scaled, so that the limit is that of the whole normal impulse and
// friction acts only on the free part of the sliding velocity.
Vector3d impulse_along_free_axes(const HeldAxes& held, const FreeNormal& free, double inverse_mass,
                                 const Vector3d& v, const NodeContact& c, double restitution)
{
    const Vector3d n = c.normal, &m = free.m;
    const Vector3d slip = v - n.dot(v) * n;
    Vector3d along = held.free_part(v);
    along -= m.dot(along) * m;
    const double share = slip.norm() > 0 ? std::min(along.norm() / slip.norm(), 1.0) : 1;
    const Matrix3d K = inverse_mass * Matrix3d::Identity();
    return collision_impulse(K, along + n.dot(v) / free.cosine * m, m, restitution,
                             c.friction * share / free.cosine);
}

} // namespace

void collide_nodes(Deformable& solid, const std::vector<HeldAxes>& held,
                   const NodeContacts& contacts, RigidColliders& rigid, double time_step,
                   bool with_restitution, Counters& counters)
{
    // A contact rests if its rebound would be slower than this [m/s]: gravity stops such a rebound
    // within twice `time_step`.
    const double resting_speed = 2 * time_step * rigid.world.settings.gravity.norm();
    for (const NodeContact& c : contacts.all()) {
        const Vector3d x = rigid.at_start(c.body, solid.positions[c.node]), n = c.normal;
        const std::optional<FreeNormal> free = free_normal(held[c.node], n);
        const double inverse_mass = free ? 1 / solid.masses[c.node] : 0;
        const Mover& mover = rigid.mover(c.body);
        const Body& body = mover.body;
        if (inverse_mass == 0 && body.is_static()) continue;
        const Vector3d v = relative_velocity(node_body(solid, c.node, inverse_mass), body, x);
        const double v_n = v.dot(n);
        if (v_n >= 0 || c.gap + time_step * v_n >= 0) continue;
        if (with_restitution && (c.restitution == 0 || -c.restitution * v_n < resting_speed))
            continue;
        // Without restitution, a node may still close its gap within the time step, so only the
        // approach speed above gap / time_step is removed.
        const Vector3d closing = with_restitution ? v : v + std::max(c.gap, 0.0) / time_step * n;
        const double restitution = with_restitution ? c.restitution : 0;
        Vector3d j;
        if (held[c.node].any() && body.is_static()) {
            j = impulse_along_free_axes(held[c.node], *free, inverse_mass, closing, c, restitution);
        } else {
            const Matrix3d K =
                inverse_mass * held[c.node].free_axes() + mover.impulse_matrix_at(x, -n);
            j = collision_impulse(K, closing, n, restitution, c.friction);
        }
        solid.velocities[c.node] += inverse_mass * held[c.node].free_part(j);
        rigid.push(c.body, x, -j);
        ++counters.node_impulses;
    }
}

void push_by_held_nodes(const Deformable& solid, const std::vector<HeldAxes>& held,
                        const NodeContacts& contacts, RigidColliders& rigid, double time_step,
                        Counters& counters)
{
    constexpr int sweeps = 30;
    std::vector<const NodeContact*> fixed;
    for (const NodeContact& c : contacts.all())
        if (!free_normal(held[c.node], c.normal) && !rigid.mover(c.body).body.is_static())
            fixed.push_back(&c);
    if (fixed.empty()) return;
    rigid.fall(time_step); // to the velocities at the end of the step
    std::vector<Vector3d> impulses(fixed.size(), Vector3d::Zero()); // on the bodies [N s]
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t k = 0; k < fixed.size(); ++k) {
            const NodeContact& c = *fixed[k];
            const Vector3d x = solid.positions[c.node], n = -c.normal; // n: towards the body
            const Mover& mover = rigid.mover(c.body);
            const Body& body = mover.body;
            // K uses the mass of the body without its supports. With their very large mass, the
            // impulse of a node that cannot move would push the supports away.
            const Matrix3d K =
                impulse_matrix(body.inverse_mass, body.inverse_inertia, body.position, x);
            const Vector3d v = relative_velocity(body, node_body(solid, c.node, 0), x);
            const double share = c.gap > 0 ? 1 : corrected_share, v_n = n.dot(v);
            const double j_n = std::max(
                n.dot(impulses[k]) - (v_n + share * c.gap / time_step) / n.dot(K * n), 0.0);
            // No eigenvalue of K exceeds its trace, so this step never overshoots.
            Vector3d j_t = impulses[k] - (v - v_n * n) / K.trace();
            j_t -= n.dot(j_t) * n;
            const double most = c.friction * j_n;
            if (j_t.norm() > most) j_t *= most / j_t.norm();
            const Vector3d j = j_n * n + j_t;
            rigid.push(c.body, x, j - impulses[k]);
            impulses[k] = j;
        }
    rigid.fall(-time_step);
    for (const Vector3d& impulse : impulses)
        if (!impulse.isZero(0)) ++counters.node_impulses;
}

void correct_node_positions(Deformable& solid, const std::vector<HeldAxes>& held,
                            const NodeContacts& contacts, double step_share, double farthest)
{
    for (const NodeContact& c : contacts.all()) {
        if (c.gap >= 0) continue;
        const std::optional<FreeNormal> free = free_normal(held[c.node], c.normal);
        if (!free) continue;
        solid.positions[c.node] +=
            std::min(corrected_share * step_share * -c.gap, farthest) / free->cosine * free->m;
    }
}

} // namespace rigor
