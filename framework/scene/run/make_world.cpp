// SPDX-License-Identifier: MIT
// Makes the world of a scene: first the rigid bodies with their mass and state, then springs and
// forces with their points moved to object space, last the deformable solids.
#include "scene/run/make_world.hpp"

#include "deformable/elasticity/totals.hpp"
#include "deformable/solid/make_deformable.hpp"
#include "formulas/kinematics.hpp"
#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/bodies/mass.hpp"
#include "scene/run/approximate_mass.hpp"

#include <map>

namespace rigor {

namespace {

// Copies of the meshes of the scene, one of each mesh. Each world computes its own data of a mesh,
// such as the level set, so that all worlds of a scene do the same work and have the same counters.
class OwnMeshes {
public:
    void take(std::vector<Part>& parts)
    {
        for (Part& part : parts) {
            Mesh* mesh = std::get_if<Mesh>(&part.shape);
            if (!mesh) continue;
            std::shared_ptr<const SolidMesh>& own = own_[mesh->solid.get()];
            if (!own) own = mesh->solid->copy();
            mesh->solid = own;
        }
    }

private:
    std::map<const SolidMesh*, std::shared_ptr<const SolidMesh>> own_;
};

// Makes a deformable solid at its position. Its nodes start with the velocities of a rigid body.
Deformable make_solid(const SolidDescription& described)
{
    Deformable solid = make_deformable(described.name, *described.mesh, described.material,
                                       rotation_matrix(described.orientation), described.position);
    solid.integrator = described.integrator;
    solid.fracture_method = described.fracture_method;
    solid.yield_test = described.yield_test;
    solid.flow_time = described.flow_time;
    solid.handles = described.handles;
    solid.loads = described.loads;
    const Vector3d X = totals(solid).center_of_mass;
    const Vector3d &V = described.velocity, &w = described.angular_velocity;
    // v = V + ω × (x - X)
    for (std::size_t i = 0; i < solid.positions.size(); ++i)
        solid.velocities[i] = V + w.cross(solid.positions[i] - X);
    return solid;
}

// The initial angular velocity ω of a body. The scene contains either ω or the orientations at the
// start and a short time later, from which ω is computed.
Vector3d angular_velocity_of(const BodyDescription& body)
{
    if (!body.later) return body.angular_velocity;
    const Matrix3d R = rotation_matrix(body.orientation);
    const Matrix3d R_later = rotation_matrix(body.later->orientation);
    return angular_velocity((R_later - R) / body.later->after, R);
}

// Sets the mass of a body from its parts, by the method that the scene names, and moves the parts
// so that the origin is the center of mass. Returns this center in the frame of the scene file.
Vector3d set_mass_by(const BodyDescription& described, RigidBody& body)
{
    if (described.mass_method == MassMethod::exact) return set_mass_from_parts(body);
    const MassProperties properties = approximate_mass(described);
    for (Part& part : body.parts)
        part.position -= properties.center_of_mass;
    set_mass(body, properties.mass, properties.inertia);
    return properties.center_of_mass;
}

// The point of a force in object space. The scene gives this point in world space.
Vector3d point_of_force(const AppliedForce& force, const World& world)
{
    const RigidState& state = world.bodies[force.body].state;
    return object_point(rotation_matrix(state.orientation), state.position, force.point);
}

} // namespace

World make_world(const Scene& scene, const RunSettings& settings)
{
    return make_recorded_world(scene, settings).world.rigid;
}

DeformableWorld make_deformable_world(const Scene& scene, const RunSettings& settings)
{
    return make_recorded_world(scene, settings).world;
}

RecordedWorld make_recorded_world(const Scene& scene, const RunSettings& settings)
{
    RecordedWorld made;
    World& world = made.world.rigid;
    world.settings = scene.settings;
    world.settings.formulas_are_reference = settings.formulas_are_reference;
    world.pool = ThreadPool(settings.threads);
    world.springs = scene.springs;
    world.forces = scene.forces;
    world.pair_laws = scene.pairs;
    OwnMeshes meshes;
    std::map<std::string, int> groups; // the id of each group, from 1, by its name
    for (const BodyDescription& described : scene.bodies) {
        RigidBody& body = world.bodies.emplace_back();
        body.name = described.name;
        body.parts = described.parts;
        meshes.take(body.parts);
        body.material = described.material;
        body.drag = described.drag;
        if (!described.group.empty())
            body.group = groups.try_emplace(described.group, static_cast<int>(groups.size()) + 1)
                             .first->second;
        body.is_static = described.is_static;
        Vector3d center = Vector3d::Zero();
        if (body.is_static) {
            // A static body keeps mass 0.
        } else if (described.mass) {
            set_mass(body, *described.mass, described.inertia.value());
        } else {
            center = set_mass_by(described, body);
        }
        const Matrix3d R = rotation_matrix(described.orientation);
        if (described.only_axis) let_turn_about(body, R.transpose() * *described.only_axis);
        // L = I(t) ω,  I(t) = R I_body Rᵀ
        const Vector3d w = angular_velocity_of(described);
        body.state = {described.position + R * center, described.orientation, described.velocity,
                      R * (body.inertia * (R.transpose() * w))};
        if (described.drive) {
            Drive drive = *described.drive;
            drive.first_position = described.position;
            drive.first_orientation = described.orientation;
            body.drive = std::make_shared<const Drive>(drive);
            body.state = driven_state(drive, world.time);
        }
        made.bodies.push_back({body.is_static, body.mass, center, body.inertia});
    }
    // Moves a point from a body's frame of the scene file to object space, whose origin is the
    // center of mass. A point that is fixed in the world (body -1) stays.
    const auto shift = [&](int body, Vector3d& point) {
        if (body >= 0) point -= made.bodies[static_cast<std::size_t>(body)].center_of_mass;
    };
    for (Spring& spring : world.springs) {
        shift(spring.body1, spring.point1);
        shift(spring.body2, spring.point2);
    }
    for (AppliedForce& force : world.forces)
        shift(force.body, force.point);
    for (const int i : scene.world_forces)
        world.forces[i].point = point_of_force(scene.forces[i], world);
    for (const SolidDescription& solid : scene.solids)
        made.world.solids.push_back(make_solid(solid));
    return made;
}

} // namespace rigor
