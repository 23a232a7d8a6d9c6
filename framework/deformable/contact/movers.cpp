// SPDX-License-Identifier: MIT
// Makes the movers, each a body or several bodies that move as one. Union-find groups the bodies
// that rest on each other. If none of a group rests on a static body or on a body with an axis, the
// group becomes one rigid body. Each body of any other group is
// a mover of its own. In the directions of the forces that support it, it gets a very large mass,
// so that its acceleration and its response to an impulse follow from one mass matrix.
#include "deformable/contact/movers.hpp"

#include "deformable/solid/rigid_motion.hpp"
#include "formulas/collision.hpp"
#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/orientation.hpp"
#include "rigid/bodies/union_find.hpp"
#include "rigid/motion/forces.hpp"
#include "rigid/motion/free_flight.hpp"

#include <algorithm>
#include <tuple>

namespace rigor {

namespace {

// A rigid body as deformable solids collide with it. A driven body has the velocity of its drive,
// and a sleeping body counts as static.
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

// The mean force and torque of gravity, springs, applied forces and drag on each body during the
// step. They follow from the change of its momentum and angular momentum in a predicted flight
// without contacts. This prediction includes the substeps that the integrator takes for stiff
// springs.
std::vector<Wrench> loads_of(World& world, double time_step)
{
    std::vector<Wrench> loads(world.bodies.size());
    for (std::size_t i = 0; i < loads.size(); ++i)
        loads[i].force = world.bodies[i].mass * world.settings.gravity;
    const std::vector<bool> pulled = with_dragged_bodies(pulled_bodies(world, time_step), world);
    if (std::find(pulled.begin(), pulled.end(), true) == pulled.end()) return loads;
    const Counters before = world.counters;
    const std::vector<RigidState> flown = fly_all(world, pulled, time_step, world.pool);
    world.counters = before; // this flight is only a prediction
    for (std::size_t i = 0; i < loads.size(); ++i) {
        if (!pulled[i]) continue;
        const RigidState& state = world.bodies[i].state;
        loads[i].force = world.bodies[i].mass / time_step * (flown[i].velocity - state.velocity);
        loads[i].torque = (flown[i].angular_momentum - state.angular_momentum) / time_step;
    }
    return loads;
}

// Whether a body has all six degrees of freedom.
bool moves_freely(const RigidBody& rigid, const Body& body)
{
    return !body.is_static() && !rigid.only_axis && rigid.inverse_moments.minCoeff() > 0;
}

// A contact at which another rigid body supports a body, with the unit vector of the supporting
// force.
struct Support {
    Vector3d point, direction;
};

// Sets the mass matrix and the accelerations of a mover. Its mass is very large in the direction of
// each support, and its moment of inertia is very large about an axis about which it cannot turn.
// @param turns  whether the mover can turn about every axis
void set_mass(Mover& mover, bool turns, const std::vector<Support>& supports, const Wrench& load)
{
    // The mass in the direction of a support, divided by the mass of the body. A larger number
    // would make the solution of the linear system less accurate. With this number, a body moves by
    // about a hundredth of a millimeter against its support in a step.
    constexpr double very_large = 1e5;
    const Body& body = mover.body;
    const double m = 1 / body.inverse_mass;
    const Matrix3d& I_inv = body.inverse_inertia;
    mover.mass.setZero();
    mover.mass.topLeftCorner<3, 3>() = m * Matrix3d::Identity();
    mover.mass.bottomRightCorner<3, 3>() =
        turns ? Matrix3d(I_inv.inverse())
              : Matrix3d((I_inv + Matrix3d::Identity() / (very_large * m)).inverse());
    mover.free_mass = mover.mass;
    for (const Support& support : supports) {
        const Vector6d s =
            point_jacobian(support.point - body.position).transpose() * support.direction;
        mover.mass += very_large * m * s * s.transpose();
        mover.supports.push_back(support.direction);
    }
    mover.acceleration = body.inverse_mass * load.force;
    mover.angular_acceleration = I_inv * load.torque;
    if (!mover.is_carried()) return;
    mover.inverse_mass = mover.mass.ldlt().solve(Matrix6d::Identity());
    const Vector6d a = mover.inverse_mass * stacked(load.force, load.torque);
    mover.acceleration = a.head<3>();
    mover.angular_acceleration = a.tail<3>();
}

// A mover with the total mass, momentum and angular momentum of the bodies `members`.
Mover joined(const std::vector<Body>& bodies, const std::vector<int>& members,
             const std::vector<Wrench>& loads)
{
    double M = 0;
    Vector3d X = Vector3d::Zero(), P = Vector3d::Zero(), F = Vector3d::Zero();
    for (const int i : members) {
        const double m = 1 / bodies[i].inverse_mass;
        M += m;
        X += m * bodies[i].position;
        P += m * bodies[i].velocity;
        F += loads[i].force;
    }
    X /= M;
    const Vector3d V = P / M;
    Matrix3d I = Matrix3d::Zero();
    Vector3d L = Vector3d::Zero(), T = Vector3d::Zero();
    for (const int i : members) {
        const Body& body = bodies[i];
        const double m = 1 / body.inverse_mass;
        const Vector3d r = body.position - X;
        I += body.inverse_inertia.inverse() +
             m * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
        L += body.angular_momentum + m * r.cross(body.velocity - V);
        T += loads[i].torque + r.cross(loads[i].force);
    }
    Mover mover;
    mover.body.inverse_mass = 1 / M;
    mover.body.inverse_inertia = I.inverse();
    mover.body.position = X;
    mover.body.velocity = V;
    mover.body.angular_momentum = L;
    mover.body.angular_velocity = mover.body.inverse_inertia * L;
    set_mass(mover, true, {}, {F, T});
    return mover;
}

// Whether two bodies move as one at a contact point: both their relative velocity there, and their
// relative angular velocity times the distance of the point from the farther center, are below
// `speed` [m/s].
bool moves_with(const Body& body1, const Body& body2, const Vector3d& point, double speed)
{
    const double radius =
        std::max((point - body1.position).norm(), (point - body2.position).norm());
    return relative_velocity(body1, body2, point).norm() < speed &&
           radius * (body1.angular_velocity - body2.angular_velocity).norm() < speed;
}

// A contact between two rigid bodies in the previous step. Each of the two has its own entry.
struct RestingContact {
    int body, other;
    Vector3d point, force; // present contact point [m]; mean force on `body` in that step [N]
};

std::vector<RestingContact> resting_contacts(const World& world, const std::vector<Wrench>& loads)
{
    // A contact whose force is below this share of the other forces on the body is left out.
    constexpr double noticeable = 0.01;
    std::vector<RestingContact> all;
    for (const WarmContact& c : world.memory.warm_contacts) {
        const Pose pose = pose_of(world.bodies[c.body1].state);
        const Vector3d point = pose.R * c.point1 + pose.X;
        for (const auto& [body, other, sign] :
             {std::tuple(c.body1, c.body2, 1.0), {c.body2, c.body1, -1.0}})
            if (c.mean_force.norm() > noticeable * loads[body].force.norm())
                all.push_back({body, other, point, sign * c.mean_force});
    }
    return all;
}

} // namespace

bool Mover::yields(const Vector3d& push) const
{
    return std::none_of(supports.begin(), supports.end(),
                        [&](const Vector3d& support) { return support.dot(push) < 0; });
}

Matrix3d Mover::impulse_matrix_at(const Vector3d& point, const Vector3d& push) const
{
    if (yields(push))
        return impulse_matrix(body.inverse_mass, body.inverse_inertia, body.position, point);
    const Matrix36d J = point_jacobian(point - body.position);
    return J * inverse_mass * J.transpose();
}

void Mover::push(const Vector3d& point, const Vector3d& impulse)
{
    if (body.is_static()) return;
    if (yields(impulse)) {
        body = apply_impulse(body, point, impulse);
        return;
    }
    const Vector6d change =
        inverse_mass * point_jacobian(point - body.position).transpose() * impulse;
    body.velocity += change.head<3>();
    body.angular_velocity += change.tail<3>();
}

Movers movers_of(World& world, double time_step)
{
    const std::size_t n = world.bodies.size();
    const std::vector<Wrench> loads = loads_of(world, time_step);
    std::vector<Body> bodies;
    std::vector<char> is_free;      // for each body, whether it has all degrees of freedom
    std::vector<char> stands(n, 0); // for each group, whether a body that is not free supports it
    for (const RigidBody& rigid : world.bodies) {
        bodies.push_back(collider_in_world(world, rigid));
        is_free.push_back(moves_freely(rigid, bodies.back()));
    }
    const std::vector<RestingContact> resting = resting_contacts(world, loads);
    const double speed = 2 * time_step * world.settings.gravity.norm();
    UnionFind groups(n);
    for (const RestingContact& c : resting)
        if (is_free[c.body] && is_free[c.other] &&
            moves_with(bodies[c.body], bodies[c.other], c.point, speed))
            groups.unite(c.body, c.other);
    for (const RestingContact& c : resting)
        if (!is_free[c.other]) stands[groups.find(c.body)] = 1;

    std::vector<std::vector<int>> members(n);
    for (std::size_t i = 0; i < n; ++i) {
        const int group = groups.find(static_cast<int>(i));
        const bool is_alone = stands[group] || !is_free[i];
        members[is_alone ? i : static_cast<std::size_t>(group)].push_back(static_cast<int>(i));
    }
    std::vector<std::vector<Support>> supports(n);
    for (const RestingContact& c : resting)
        if (stands[groups.find(c.body)] &&
            (bodies[c.other].is_static() || c.force.dot(loads[c.body].force) < 0))
            supports[c.body].push_back({c.point, c.force.normalized()});

    Movers movers;
    movers.of.resize(n);
    for (const std::vector<int>& together : members) {
        if (together.empty()) continue;
        const int first = together[0];
        for (const int i : together)
            movers.of[i] = static_cast<int>(movers.all.size());
        if (together.size() > 1) {
            movers.all.push_back(joined(bodies, together, loads));
            continue;
        }
        Mover alone;
        alone.body = bodies[first];
        if (!alone.body.is_static()) set_mass(alone, is_free[first], supports[first], loads[first]);
        movers.all.push_back(alone);
    }
    for (Mover& mover : movers.all)
        mover.start = mover.body;
    return movers;
}

} // namespace rigor
