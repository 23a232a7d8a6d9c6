// SPDX-License-Identifier: MIT
// Makes the movers: groups of bodies that lie on each other are found by union-find, each group
// that nothing static carries becomes one rigid body, and a body that is carried gets a very large
// mass in the directions in which rigid bodies hold against it. Then its acceleration and its
// answer to an impulse follow from one matrix.
#include "deformable/contact/movers.hpp"

#include "formulas/collision.hpp"
#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/orientation.hpp"
#include "rigid/motion/forces.hpp"

#include <numeric>

namespace rigor {

namespace {

// A body as a solid meets it. One that sleeps is taken as static.
Body collider_in_world(const World& world, const RigidBody& rigid)
{
    Body body = body_in_world(world.settings.integrator, rigid);
    if (rigid.is_static && rigid.drive) {
        const DriveVelocity driven = drive_velocity(*rigid.drive, world.time);
        body.velocity = driven.linear;
        body.angular_velocity = driven.angular;
    }
    if (rigid.rest.is_asleep()) {
        body.inverse_mass = 0;
        body.inverse_inertia.setZero();
    }
    return body;
}

// The net wrench of gravity, springs, applied forces and drag on each body, at the start of the
// step.
std::vector<Wrench> loads_of(const World& world, double time_step)
{
    std::vector<Wrench> loads(world.bodies.size());
    std::vector<int> pulled;
    const std::vector<bool> is_pulled = with_dragged_bodies(pulled_bodies(world, time_step), world);
    std::vector<RigidState> states;
    for (std::size_t i = 0; i < loads.size(); ++i) {
        states.push_back(world.bodies[i].state);
        loads[i].force = world.bodies[i].mass * world.settings.gravity;
        if (is_pulled[i]) pulled.push_back(static_cast<int>(i));
    }
    if (pulled.empty()) return loads;
    AppliedWrenches wrenches(world, pulled);
    const std::vector<Wrench>& all = wrenches.at(states, world.time + time_step / 2, world.time);
    for (std::size_t k = 0; k < pulled.size(); ++k)
        loads[pulled[k]] = all[k];
    return loads;
}

// Groups of numbers that are connected by pairs (union-find).
class Groups {
public:
    explicit Groups(std::size_t size) : parents_(size)
    {
        std::iota(parents_.begin(), parents_.end(), 0);
    }
    int of(int i)
    {
        while (parents_[i] != i)
            i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    void connect(int i, int k) { parents_[of(i)] = of(k); }

private:
    std::vector<int> parents_;
};

using Vector6d = Eigen::Matrix<double, 6, 1>;

// The Jacobian of the point at r from the center: its velocity is J (V, ω).
Eigen::Matrix<double, 3, 6> jacobian(const Vector3d& r)
{
    Eigen::Matrix<double, 3, 6> J;
    J << Matrix3d::Identity(), Matrix3d{{0, r.z(), -r.y()}, {-r.z(), 0, r.x()}, {r.y(), -r.x(), 0}};
    return J;
}

Vector6d stacked(const Vector3d& a, const Vector3d& b)
{
    Vector6d both;
    both << a, b;
    return both;
}

// Whether a body has all six degrees of freedom, so that it can be a part of a mover.
bool moves_freely(const Body& body)
{
    return !body.is_static() && body.inverse_inertia.determinant() > 0;
}

// A rigid body that holds against a body: where, and in which direction.
struct Support {
    Vector3d point, direction;
};

// Sets the mass and the accelerations. Where rigid bodies hold against the mover, its mass is very
// large, and so it is about an axis about which it cannot turn.
void set_mass(Mover& mover, const std::vector<Support>& supports, const Wrench& load)
{
    constexpr double very_large = 1e8; // times the mass of the body, at a radius of 1 m
    const Body& body = mover.body;
    const double m = 1 / body.inverse_mass;
    const Matrix3d& I_inv = body.inverse_inertia;
    mover.mass.setZero();
    mover.mass.topLeftCorner<3, 3>() = m * Matrix3d::Identity();
    mover.mass.bottomRightCorner<3, 3>() =
        I_inv.determinant() > 0
            ? Matrix3d(I_inv.inverse())
            : Matrix3d((I_inv + Matrix3d::Identity() / (very_large * m)).inverse());
    mover.is_carried = !supports.empty();
    for (const Support& support : supports) {
        const Vector6d s = jacobian(support.point - body.position).transpose() * support.direction;
        mover.mass += very_large * m * s * s.transpose();
    }
    mover.inverse_mass = mover.mass.ldlt().solve(Matrix6d::Identity());
    mover.acceleration = body.inverse_mass * load.force;
    mover.angular_acceleration = I_inv * load.torque;
    if (!mover.is_carried) return;
    const Vector6d a = mover.inverse_mass * stacked(load.force, load.torque);
    mover.acceleration = a.head<3>();
    mover.angular_acceleration = a.tail<3>();
}

// One rigid body with the mass, the momentum and the angular momentum of its members.
Mover joined(const World& world, const std::vector<int>& members, const std::vector<Wrench>& loads)
{
    double M = 0;
    Vector3d X = Vector3d::Zero(), P = Vector3d::Zero(), F = Vector3d::Zero();
    std::vector<Body> bodies;
    for (const int i : members) {
        bodies.push_back(body_in_world(world.settings.integrator, world.bodies[i]));
        const double m = 1 / bodies.back().inverse_mass;
        M += m;
        X += m * bodies.back().position;
        P += m * bodies.back().velocity;
        F += loads[i].force;
    }
    X /= M;
    Matrix3d I = Matrix3d::Zero();
    Vector3d L = Vector3d::Zero(), T = Vector3d::Zero();
    for (std::size_t k = 0; k < members.size(); ++k) {
        const Body& body = bodies[k];
        const double m = 1 / body.inverse_mass;
        const Vector3d r = body.position - X;
        I += body.inverse_inertia.inverse() +
             m * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
        L += body.angular_momentum + m * r.cross(body.velocity - P / M);
        T += loads[members[k]].torque + r.cross(loads[members[k]].force);
    }
    Mover mover;
    mover.body.inverse_mass = 1 / M;
    mover.body.inverse_inertia = I.inverse();
    mover.body.position = X;
    mover.body.velocity = P / M;
    mover.body.angular_momentum = L;
    mover.body.angular_velocity = mover.body.inverse_inertia * L;
    set_mass(mover, {}, {F, T});
    return mover;
}

// Which bodies lie on each other, and which groups of them something static carries.
struct Lying {
    Groups groups;
    std::vector<char> stands; // for each group
};

Lying lying_bodies(const World& world, const std::vector<Body>& bodies)
{
    Lying lying{Groups(bodies.size()), std::vector<char>(bodies.size(), 0)};
    for (const WarmContact& c : world.memory.warm_contacts)
        if (moves_freely(bodies[c.body1]) && moves_freely(bodies[c.body2]))
            lying.groups.connect(c.body1, c.body2);
    for (const WarmContact& c : world.memory.warm_contacts)
        for (const auto& [body, other] : {std::pair(c.body1, c.body2), {c.body2, c.body1}})
            if (!moves_freely(bodies[other])) lying.stands[lying.groups.of(body)] = 1;
    return lying;
}

// For each body, what holds against it. Only bodies of groups that stand on something have any.
std::vector<std::vector<Support>> supports_of(const World& world, const std::vector<Body>& bodies,
                                              const std::vector<Wrench>& loads, Lying& lying)
{
    std::vector<std::vector<Support>> supports(bodies.size());
    for (const WarmContact& c : world.memory.warm_contacts) {
        const RigidState& state = world.bodies[c.body1].state;
        const Vector3d point =
            body_rotation(world.settings.integrator, state) * c.point + state.position;
        for (const bool is_first : {true, false}) {
            const int body = is_first ? c.body1 : c.body2, other = is_first ? c.body2 : c.body1;
            const Vector3d force = is_first ? c.mean_force : Vector3d(-c.mean_force);
            const bool carries = bodies[other].is_static() || force.dot(loads[body].force) < 0;
            if (lying.stands[lying.groups.of(body)] && carries && !force.isZero(0))
                supports[body].push_back({point, force.normalized()});
        }
    }
    return supports;
}

} // namespace

Matrix3d Mover::impulse_matrix_at(const Vector3d& point) const
{
    if (!is_carried)
        return impulse_matrix(body.inverse_mass, body.inverse_inertia, body.position, point);
    const Eigen::Matrix<double, 3, 6> J = jacobian(point - body.position);
    return J * inverse_mass * J.transpose();
}

void Mover::push(const Vector3d& point, const Vector3d& impulse)
{
    if (body.is_static()) return;
    if (!is_carried) {
        body = apply_impulse(body, point, impulse);
        return;
    }
    const Vector6d change = inverse_mass * jacobian(point - body.position).transpose() * impulse;
    body.velocity += change.head<3>();
    body.angular_velocity += change.tail<3>();
}

Movers movers_of(const World& world, double time_step)
{
    const std::size_t n = world.bodies.size();
    const std::vector<Wrench> loads = loads_of(world, time_step);
    std::vector<Body> bodies;
    for (const RigidBody& rigid : world.bodies)
        bodies.push_back(collider_in_world(world, rigid));
    Lying lying = lying_bodies(world, bodies);
    const std::vector<std::vector<Support>> supports = supports_of(world, bodies, loads, lying);

    std::vector<std::vector<int>> members(n);
    for (std::size_t i = 0; i < n; ++i) {
        const int group = lying.groups.of(static_cast<int>(i));
        const bool is_alone = lying.stands[group] || !moves_freely(bodies[i]);
        members[is_alone ? i : static_cast<std::size_t>(group)].push_back(static_cast<int>(i));
    }
    Movers movers;
    movers.of.resize(n);
    for (const std::vector<int>& together : members) {
        if (together.empty()) continue;
        const int first = together[0];
        for (const int i : together)
            movers.of[i] = static_cast<int>(movers.all.size());
        if (together.size() > 1) {
            movers.all.push_back(joined(world, together, loads));
            continue;
        }
        Mover alone;
        alone.body = bodies[first];
        if (!alone.body.is_static()) set_mass(alone, supports[first], loads[first]);
        movers.all.push_back(alone);
    }
    return movers;
}

} // namespace rigor
