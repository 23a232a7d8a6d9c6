// SPDX-License-Identifier: MIT
#include "deformable/handles.hpp"
#include "deformable/node_motion.hpp"
#include "formulas/collision.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

constexpr int most_rounds = 10; // of the active set

// How a contact holds its node.
enum class Hold { off, sticking, sliding };

Matrix3d axes_of(const HeldNode& held)
{
    return Vector3d(held.axes[0], held.axes[1], held.axes[2]).asDiagonal();
}

class ImplicitMotion {
public:
    explicit ImplicitMotion(const NodeMotion& motion)
        : motion_(motion), solid_(motion.solid), work_(motion.work), h_(motion.time_step),
          contacts_(motion.work.contacts.all())
    {
    }

    void run()
    {
        hold_nodes(solid_, motion_.start + h_, h_, work_.held);
        for (const HeldNode& held : work_.held)
            work_.is_held[held.node] = 1;
        work_.contacts.measure(solid_, motion_.rigid);
        collide_nodes(solid_, work_.is_held, work_.contacts, motion_.rigid, h_, true,
                      motion_.counters);
        set_up_system();
        join_bodies();
        guess_holds();
        auto& v = work_.next_velocities;
        v = solid_.velocities;
        for (int round = 0; round < most_rounds; ++round) {
            tie_nodes();
            motion_.counters.solver_iterations +=
                work_.system.solve(work_.right_side, work_.ties, work_.bodies, v);
            ++motion_.counters.system_solves;
            note_impulses();
            if (!revise_holds()) break;
        }
        keep_momentum();
        push_bodies();
        solid_.velocities = v;
        for (std::size_t i = 0; i < v.size(); ++i)
            solid_.positions[i] += h_ * v[i];
        heal_nodes(solid_, work_.is_held, work_.contacts, 1, h_ * motion_.radius);
        for (const HeldNode& held : work_.held)
            work_.is_held[held.node] = 0;
    }

private:
    // b = M v₀ + h f(x₀)
    void set_up_system()
    {
        work_.elements.strains(solid_.positions, work_.strains);
        if (!work_.system.is_analysed())
            work_.system.analyse(work_.elements, static_cast<int>(solid_.positions.size()));
        work_.system.assemble(work_.elements, work_.strains, solid_.masses, solid_.material, h_);
        auto& f = work_.forces;
        std::fill(f.begin(), f.end(), Vector3d::Zero());
        work_.elements.add_elastic_forces(solid_.positions, f);
        add_loads(solid_, motion_.gravity, motion_.start, f);
        work_.momenta.resize(f.size());
        for (std::size_t i = 0; i < f.size(); ++i)
            work_.momenta[i] = solid_.masses[i] * solid_.velocities[i] + h_ * f[i];
    }

    // A body that nothing else holds becomes part of the system, with what gravity will do to it in this
    // step. One that rests on others is as good as static here: what it gets it hands down to them.
    void join_bodies()
    {
        const World& world = motion_.rigid.world;
        work_.body_numbers.assign(world.bodies.size(), -1);
        work_.free_bodies.clear();
        for (const NodeContact& c : contacts_) {
            const Body& body = motion_.rigid.bodies[c.body];
            if (body.is_static() || work_.body_numbers[c.body] >= 0 || motion_.rigid.rests(c.body))
                continue;
            work_.body_numbers[c.body] = static_cast<int>(work_.free_bodies.size());
            work_.free_bodies.push_back({1 / body.inverse_mass, body.inverse_inertia.inverse(),
                                         body.velocity + h_ * world.gravity,
                                         body.angular_velocity});
        }
    }
    Vector3d arm(const NodeContact& c) const
    {
        return solid_.positions[c.node] - motion_.rigid.bodies[c.body].position;
    }
    // Of the surface at the node, without contacts, or as the system says.
    Vector3d surface_velocity(const NodeContact& c, const std::vector<SystemBody>& bodies) const
    {
        const int number = work_.body_numbers[c.body];
        const Body& body = motion_.rigid.bodies[c.body];
        const Vector3d r = arm(c);
        return number < 0 ? body.velocity + body.angular_velocity.cross(r)
                          : bodies[number].V + bodies[number].w.cross(r);
    }
    double gap_afterwards(const NodeContact& c, const Vector3d& v,
                          const std::vector<SystemBody>& bodies) const
    {
        return c.gap + h_ * c.normal.dot(v - surface_velocity(c, bodies));
    }

    void guess_holds()
    {
        work_.holds.assign(contacts_.size(), 0);
        work_.frictions.assign(contacts_.size(), Vector3d::Zero());
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
            const NodeContact& c = contacts_[k];
            const Vector3d v = solid_.velocities[c.node] + h_ * motion_.gravity;
            if (!work_.is_held[c.node] && gap_afterwards(c, v, work_.free_bodies) < 0)
                hold(k, c.friction > 0 ? Hold::sticking : Hold::sliding);
        }
    }
    void hold(std::size_t k, Hold how) { work_.holds[k] = static_cast<char>(how); }
    Hold held_how(std::size_t k) const { return static_cast<Hold>(work_.holds[k]); }

    // The ties of this round, and the friction of what slides as an impulse. A node in several contacts is
    // tied by the deepest.
    void tie_nodes()
    {
        work_.right_side = work_.momenta;
        work_.bodies = work_.free_bodies;
        work_.ties.clear();
        for (const HeldNode& held : work_.held) {
            const Matrix3d N = axes_of(held);
            work_.ties.push_back({held.node, N, N * held.velocity, -1, Vector3d::Zero()});
        }
        work_.tied_by.assign(solid_.positions.size(), -1);
        for (int k = 0; k < static_cast<int>(contacts_.size()); ++k) {
            int& by = work_.tied_by[contacts_[k].node];
            if (held_how(k) != Hold::off && (by < 0 || contacts_[k].gap < contacts_[by].gap))
                by = k;
        }
        for (int k = 0; k < static_cast<int>(contacts_.size()); ++k)
            if (is_tied(k)) tie(k);
    }
    bool is_tied(int k) const { return work_.tied_by[contacts_[k].node] == k; }

    void tie(int k)
    {
        const NodeContact& c = contacts_[k];
        const int number = work_.body_numbers[c.body];
        Vector3d surface = -std::max(c.gap, 0.0) / h_ * c.normal; // closes a gap within the step
        if (number < 0) surface += surface_velocity(c, work_.free_bodies);
        Matrix3d N = Matrix3d::Identity();
        if (held_how(k) == Hold::sliding) {
            N = c.normal * c.normal.transpose();
            const Vector3d& friction = work_.frictions[k];
            work_.right_side[c.node] += friction;
            if (number >= 0) {
                const Body& body = motion_.rigid.bodies[c.body];
                work_.bodies[number].V -= body.inverse_mass * friction;
                work_.bodies[number].w -= body.inverse_inertia * arm(c).cross(friction);
            }
        }
        work_.ties.push_back({c.node, N, N * surface, number, arm(c)});
    }

    // What the ties of contacts gave their nodes.
    void note_impulses()
    {
        work_.impulses.assign(contacts_.size(), Vector3d::Zero());
        if (contacts_.empty()) return;
        const auto& missing = work_.system.missing(work_.right_side, work_.next_velocities);
        for (int k = 0; k < static_cast<int>(contacts_.size()); ++k) {
            if (!is_tied(k)) continue;
            const Vector3d n = contacts_[k].normal, j = missing[contacts_[k].node];
            work_.impulses[k] =
                held_how(k) == Hold::sliding ? Vector3d(n.dot(j) * n + work_.frictions[k]) : j;
        }
    }

    // @return whether any contact holds otherwise than in the round before
    bool revise_holds()
    {
        bool is_changed = false;
        for (int k = 0; k < static_cast<int>(contacts_.size()); ++k)
            if (is_tied(k) ? revise_tied(k) : revise_free(k)) is_changed = true;
        return is_changed;
    }

    bool revise_free(int k)
    {
        const NodeContact& c = contacts_[k];
        if (held_how(k) != Hold::off || work_.is_held[c.node]) return false;
        const double depth = -gap_afterwards(c, work_.next_velocities[c.node], work_.bodies);
        if (depth <= 1e-6 * motion_.radius) return false;
        hold(k, c.friction > 0 ? Hold::sticking : Hold::sliding);
        work_.frictions[k].setZero();
        return true;
    }

    bool revise_tied(int k)
    {
        const NodeContact& c = contacts_[k];
        const Vector3d n = c.normal, j = work_.impulses[k];
        const double j_n = n.dot(j);
        if (j_n < 0) { // it would pull
            hold(k, Hold::off);
            return true;
        }
        if (held_how(k) == Hold::sticking) {
            if (inside_friction_cone(j, n, c.friction)) return false;
            const Vector3d j_t = j - j_n * n;
            hold(k, Hold::sliding);
            work_.frictions[k] = c.friction * j_n / j_t.norm() * j_t;
            return true;
        }
        if (c.friction == 0) return false;
        const Vector3d v = work_.next_velocities[c.node] - surface_velocity(c, work_.bodies);
        const Vector3d v_t = v - n.dot(v) * n;
        if (v_t.dot(work_.frictions[k]) > 0) { // friction would drive it
            hold(k, Hold::sticking);
            return true;
        }
        const double speed = v_t.norm();
        if (speed == 0) return false;
        const Vector3d friction = -c.friction * j_n / speed * v_t;
        if ((friction - work_.frictions[k]).norm() <= 1e-3 * friction.norm()) return false;
        work_.frictions[k] = friction;
        return true;
    }

    // Of a solid that nothing touches the sum of momenta is right to rounding, whatever the solver left.
    void keep_momentum()
    {
        if (!work_.ties.empty()) return;
        Vector3d left = Vector3d::Zero();
        double mass = 0;
        auto& v = work_.next_velocities;
        for (std::size_t i = 0; i < v.size(); ++i) { // forces between nodes have no sum
            const double m = (1 + h_ * solid_.material.drag) * solid_.masses[i];
            left += work_.momenta[i] - m * v[i];
            mass += m;
        }
        for (Vector3d& velocity : v)
            velocity += left / mass;
    }

    void push_bodies()
    {
        for (int k = 0; k < static_cast<int>(contacts_.size()); ++k) {
            if (!is_tied(k)) continue;
            const NodeContact& c = contacts_[k];
            motion_.rigid.push(c.body, solid_.positions[c.node], -work_.impulses[k]);
            ++motion_.counters.node_impulses;
        }
    }

    const NodeMotion& motion_;
    Deformable& solid_;
    Workspace& work_;
    double h_;
    const std::vector<NodeContact>& contacts_;
};

} // namespace

void move_implicitly(const NodeMotion& motion)
{
    ++motion.counters.deformable_substeps;
    ImplicitMotion(motion).run();
}

} // namespace rigor
