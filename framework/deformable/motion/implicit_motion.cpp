// SPDX-License-Identifier: MIT
#include "deformable/motion/implicit_motion.hpp"

#include "deformable/contact/node_collisions.hpp"
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
        work_.impulses.assign(contacts_.size(), Vector3d::Zero());
        work_.is_open.assign(work_.system.parts(), 1);
        for (int round = 0; round < most_rounds && open_parts(); ++round) {
            tie_nodes();
            motion_.counters.solver_iterations +=
                work_.system.solve(work_.momenta, work_.open_nodes, work_.ties,
                                   work_.bodies_are_open ? work_.bodies : work_.no_bodies, v);
            ++motion_.counters.system_solves;
            note_impulses();
            revise_holds();
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
        work_.dampings.assign(contacts_.size(), 0.0);
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
            const NodeContact& c = contacts_[k];
            const Vector3d v = solid_.velocities[c.node] + h_ * motion_.gravity;
            if (!work_.is_held[c.node] && gap_afterwards(c, v, work_.free_bodies) < 0)
                hold(k, c.friction > 0 ? Hold::sticking : Hold::sliding);
        }
    }
    void hold(std::size_t k, Hold how) { work_.holds[k] = static_cast<char>(how); }
    Hold held_how(std::size_t k) const { return static_cast<Hold>(work_.holds[k]); }

    // A round is about the parts of the solid with a contact that held otherwise in the one before. Those that
    // may touch bodies of the system go together.
    // @return whether there are any
    bool open_parts()
    {
        char& bodies_open = work_.bodies_are_open;
        bodies_open = 0;
        const auto for_each_joined = [&](const auto& visit) {
            if (work_.free_bodies.empty()) return;
            for (const NodeContact& c : contacts_)
                if (work_.body_numbers[c.body] >= 0) visit(open(c));
        };
        for_each_joined([&](char& is_open) { bodies_open |= is_open; });
        for_each_joined([&](char& is_open) { is_open = bodies_open; });
        work_.open_nodes.clear();
        for (int i = 0; i < static_cast<int>(solid_.positions.size()); ++i)
            if (work_.is_open[work_.system.part_of(i)]) work_.open_nodes.push_back(i);
        return !work_.open_nodes.empty();
    }
    char& open(const NodeContact& c) { return work_.is_open[work_.system.part_of(c.node)]; }

    // The ties of this round. A node in several contacts is tied by the deepest.
    void tie_nodes()
    {
        if (work_.bodies_are_open) work_.bodies = work_.free_bodies;
        work_.ties.clear();
        for (const HeldNode& held : work_.held) {
            if (!work_.is_open[work_.system.part_of(held.node)]) continue;
            const Matrix3d N = axes_of(held);
            work_.ties.push_back({held.node, N, held.velocity, -1, Vector3d::Zero(), 0});
        }
        work_.tied_by.assign(solid_.positions.size(), -1);
        for (int k = 0; k < static_cast<int>(contacts_.size()); ++k) {
            int& by = work_.tied_by[contacts_[k].node];
            if (held_how(k) != Hold::off && (by < 0 || contacts_[k].gap < contacts_[by].gap))
                by = k;
        }
        for (int k = 0; k < static_cast<int>(contacts_.size()); ++k)
            if (is_tied(k) && open(contacts_[k])) tie(k);
    }
    bool is_tied(int k) const { return work_.tied_by[contacts_[k].node] == k; }

    void tie(int k)
    {
        const NodeContact& c = contacts_[k];
        const int number = work_.body_numbers[c.body];
        Vector3d surface = -std::max(c.gap, 0.0) / h_ * c.normal; // closes a gap within the step
        if (number < 0) surface += surface_velocity(c, work_.free_bodies);
        const bool slides = held_how(k) == Hold::sliding;
        const Matrix3d N =
            slides ? Matrix3d(c.normal * c.normal.transpose()) : Matrix3d::Identity();
        work_.ties.push_back({c.node, N, surface, number, arm(c), slides ? work_.dampings[k] : 0});
    }

    // What the ties of contacts gave their nodes.
    void note_impulses()
    {
        if (contacts_.empty()) return;
        const auto& missing =
            work_.system.missing(work_.momenta, work_.open_nodes, work_.next_velocities);
        for (int k = 0; k < static_cast<int>(contacts_.size()); ++k)
            if (is_tied(k) && open(contacts_[k])) work_.impulses[k] = missing[contacts_[k].node];
    }

    // Parts where any contact is to hold otherwise stay open.
    void revise_holds()
    {
        work_.was_open = work_.is_open;
        std::fill(work_.is_open.begin(), work_.is_open.end(), 0);
        for (int k = 0; k < static_cast<int>(contacts_.size()); ++k) {
            if (!work_.was_open[work_.system.part_of(contacts_[k].node)]) continue;
            if (is_tied(k) ? revise_tied(k) : revise_free(k)) open(contacts_[k]) = 1;
        }
    }

    bool revise_free(int k)
    {
        const NodeContact& c = contacts_[k];
        if (held_how(k) != Hold::off || work_.is_held[c.node]) return false;
        const double depth = -gap_afterwards(c, work_.next_velocities[c.node], work_.bodies);
        if (depth <= 1e-6 * motion_.radius) return false;
        const bool is_new = work_.impulses[k].isZero(); // one that let go before would do so again
        hold(k, is_new && c.friction > 0 ? Hold::sticking : Hold::sliding);
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
        if (c.friction == 0) return false;
        const double most = c.friction * j_n; // that friction may be
        double& d = work_.dampings[k];
        const double largest = 1e3 * work_.system.diagonal(c.node).trace();
        if (held_how(k) == Hold::sticking) {
            if (inside_friction_cone(j, n, c.friction)) return false;
            hold(k, Hold::sliding);
            const Vector3d v = solid_.velocities[c.node] + h_ * motion_.gravity;
            d = std::min(most / slip_speed(c, v), largest);
            return true;
        }
        const double speed = slip_speed(c, work_.next_velocities[c.node]);
        if (std::abs(d * speed - most) <= 1e-3 * most) return false;
        d = most / speed;
        if (!(d < largest)) hold(k, Hold::sticking);
        return true;
    }
    double slip_speed(const NodeContact& c, const Vector3d& velocity) const
    {
        const Vector3d v = velocity - surface_velocity(c, work_.bodies);
        return (v - c.normal.dot(v) * c.normal).norm();
    }

    // Of a part that nothing holds the sum of momenta is right to rounding, whatever the solver left.
    void keep_momentum()
    {
        const ImplicitSystem& system = work_.system;
        auto& is_held = work_.was_open;
        is_held.assign(system.parts(), 0);
        for (const HeldNode& held : work_.held)
            is_held[system.part_of(held.node)] = 1;
        for (std::size_t i = 0; i < work_.tied_by.size(); ++i)
            if (work_.tied_by[i] >= 0) is_held[system.part_of(static_cast<int>(i))] = 1;
        work_.left_over.assign(system.parts(), {});
        auto& v = work_.next_velocities;
        for (std::size_t i = 0; i < v.size(); ++i) { // forces between nodes have no sum
            const double m = (1 + h_ * solid_.material.drag) * solid_.masses[i];
            LeftOver& part = work_.left_over[system.part_of(static_cast<int>(i))];
            part.momentum += work_.momenta[i] - m * v[i];
            part.mass += m;
        }
        for (std::size_t i = 0; i < v.size(); ++i) {
            const int p = system.part_of(static_cast<int>(i));
            if (!is_held[p]) v[i] += work_.left_over[p].momentum / work_.left_over[p].mass;
        }
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
