// SPDX-License-Identifier: MIT
// Finds which contacts hold their nodes in a step of backward Euler, and which of them stick or
// slide, by an active-set method. `solve_with_contacts` (implicit_motion.cpp) runs its rounds. Each
// round ties the nodes of the contacts that hold, solves the linear system and corrects every
// contact that pulls, penetrates, or violates Coulomb's law. Sliding friction enters the system as
// a damping: the friction impulse divided by the sliding speed. From two solves with different
// dampings, the code extrapolates to the damping that gives the friction impulse of Coulomb's law.
#include "deformable/motion/contact_set.hpp"

#include "formulas/collision.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// An open contact starts to hold its node if the penetration, divided by the radius of the solid,
// exceeds this number. It is well above the penetration that rounding and the tolerance of the
// linear solve leave for a tied node.
constexpr double penetration_tolerance = 1e-6;
// A sliding contact needs no further round if the relative error of its friction force is below
// this. A smaller value takes more solves of the linear system.
constexpr double friction_tolerance = 1e-3;
// The largest damping of a sliding contact, divided by the trace of the diagonal block of its node
// in the matrix. At this damping the node hardly slides, and a larger value would make the system
// ill-conditioned. So a sliding contact that needs a larger value becomes a sticking one.
constexpr double largest_damping = 1e3;

} // namespace

Vector3d ContactSet::arm(const NodeContact& c) const
{
    return step_->solid.positions[c.node] - step_->rigid.mover(c.body).body.position;
}

void ContactSet::guess(const ContactStep& step)
{
    step_.emplace(step);
    modes_.assign(step.contacts.size(), ContactMode::open);
    dampings_.assign(step.contacts.size(), 0.0);
    last_slidings_.assign(step.contacts.size(), {});
    has_stopped_.assign(step.contacts.size(), false);
    impulses_.assign(step.contacts.size(), Vector3d::Zero());
    const double h = step.time_step;
    for (std::size_t k = 0; k < step.contacts.size(); ++k) {
        const NodeContact& c = step.contacts[k];
        const HeldAxes& held = step.held[c.node];
        if (!free_normal(held, c.normal)) continue;
        const Vector3d v = step.solid.velocities[c.node] + h * held.free_part(step.gravity);
        const Vector3d surface = step.bodies.velocity_before(step.rigid, c.body, arm(c));
        if (c.gap + h * c.normal.dot(v - surface) < 0)
            modes_[k] = c.friction > 0 ? ContactMode::sticking : ContactMode::sliding;
    }
}

void ContactSet::choose_ties()
{
    const auto& contacts = step_->contacts;
    tied_by_.assign(step_->solid.positions.size(), -1);
    for (int k = 0; k < static_cast<int>(contacts.size()); ++k) {
        int& by = tied_by_[contacts[k].node];
        if (modes_[k] != ContactMode::open && (by < 0 || contacts[k].gap < contacts[by].gap))
            by = k;
    }
}

TiedNode ContactSet::tie(int k) const
{
    const NodeContact& c = step_->contacts[k];
    const int number = step_->bodies.number(c.body);
    // The velocity at which the node closes the gap within the step.
    Vector3d surface = -std::max(c.gap, 0.0) / step_->time_step * c.normal;
    if (number < 0) surface += step_->bodies.velocity_before(step_->rigid, c.body, arm(c));
    const bool slides = modes_[k] == ContactMode::sliding;
    const HeldAxes& held = step_->held[c.node];
    const FreeNormal free = free_normal(held, c.normal).value();
    if (held.any() && number < 0) {
        // Handles prescribe some coordinates of v. The free coordinates are chosen so that n·v
        // still equals the normal velocity of the surface.
        const Vector3d v = step_->solid.velocities[c.node], prescribed = v - held.free_part(v),
                       n = c.normal;
        surface += (n.dot(surface - prescribed) / free.cosine - free.m.dot(surface)) * free.m;
    }
    const Matrix3d N = slides ? Matrix3d(free.m * free.m.transpose()) : held.free_axes();
    return {c.node, N, surface, number, arm(c), slides ? dampings_[k] : 0};
}

// The impulse j of a contact is the sum of a normal impulse along n and friction along the free
// coordinates. In the prescribed coordinates, the residual also contains the impulse of the
// handles, so j is computed from the free part of the residual.
void ContactSet::set_impulse(int k, const Vector3d& residual)
{
    const NodeContact& c = step_->contacts[k];
    const HeldAxes& held = step_->held[c.node];
    impulses_[k] = residual;
    if (!held.any()) return;
    const FreeNormal free = free_normal(held, c.normal).value();
    const Vector3d r = held.free_part(residual);
    const double along_m = free.m.dot(r);
    impulses_[k] = r - along_m * free.m + along_m / free.cosine * c.normal;
}

bool ContactSet::revise(int k, const Vector3d& velocity, const Matrix3d& diagonal)
{
    return is_tied(k) ? revise_tied(k, velocity, diagonal) : revise_free(k, velocity);
}

bool ContactSet::revise_free(int k, const Vector3d& velocity)
{
    const NodeContact& c = step_->contacts[k];
    if (modes_[k] != ContactMode::open || !free_normal(step_->held[c.node], c.normal)) return false;
    const Vector3d surface = step_->bodies.velocity_after(step_->rigid, c.body, arm(c));
    const double depth = -(c.gap + step_->time_step * c.normal.dot(velocity - surface));
    if (depth <= penetration_tolerance * step_->radius) return false;
    // A contact that was released in this step slides now, because as a sticking contact it would
    // be released again.
    const bool is_new = impulses_[k].isZero();
    modes_[k] = is_new && c.friction > 0 ? ContactMode::sticking : ContactMode::sliding;
    return true;
}

bool ContactSet::revise_tied(int k, const Vector3d& velocity, const Matrix3d& diagonal)
{
    const NodeContact& c = step_->contacts[k];
    const Vector3d n = c.normal, j = impulses_[k];
    const double j_n = n.dot(j);
    if (j_n < 0) { // the contact would pull its node
        modes_[k] = ContactMode::open;
        return true;
    }
    if (c.friction == 0) return false;
    const double most = c.friction * j_n; // friction impulse of a node that slides [N s]
    double& d = dampings_[k];
    const double largest = largest_damping * diagonal.trace();
    if (modes_[k] == ContactMode::sticking) {
        if (inside_friction_cone(j, n, c.friction)) return false;
        modes_[k] = ContactMode::sliding;
        last_slidings_[k] = {};
        const Vector3d v = step_->solid.velocities[c.node] + step_->time_step * step_->gravity;
        d = std::min(largest, most / slip_speed(c, v)); // `largest` also for 0/0
        return true;
    }
    const double speed = slip_speed(c, velocity);
    if (std::abs(d * speed - most) <= friction_tolerance * most) return false;
    revise_damping(k, speed, most, largest);
    return true;
}

// Corrects the damping d of a contact that slides at the speed s, so that d s becomes the friction
// impulse `most`, or lets the contact stick. If the node had the momentum p before friction, and
// moved with the mass m, then s = p / (m + d). Two solves give p and m, and with them the speed
// s = (p - most) / m that friction leaves. If friction leaves none, the contact sticks. With
// d = most / s instead, friction that just stops a solid would need a hundred rounds. In a step, a
// contact is made to stick in this way only once.
void ContactSet::revise_damping(int k, double speed, double most, double largest)
{
    double& d = dampings_[k];
    const auto [last_d, last_speed] = last_slidings_[k];
    last_slidings_[k] = {d, speed};
    const double p = (d - last_d) / (1 / speed - 1 / last_speed), m = p / speed - d;
    const bool is_known = last_speed > 0 && p > 0 && m > 0;
    if (is_known && p <= most && !has_stopped_[k]) {
        has_stopped_[k] = true;
        modes_[k] = ContactMode::sticking;
        return;
    }
    d = is_known && p > most ? most * m / (p - most) : most / speed;
    if (!(d < largest)) modes_[k] = ContactMode::sticking;
}

double ContactSet::slip_speed(const NodeContact& c, const Vector3d& velocity) const
{
    const Vector3d v = velocity - step_->bodies.velocity_after(step_->rigid, c.body, arm(c));
    return (v - c.normal.dot(v) * c.normal).norm();
}

} // namespace rigor
