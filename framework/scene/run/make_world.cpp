// SPDX-License-Identifier: MIT
// Makes the world of a scene: first the rigid bodies with their mass and state, then springs and
// forces with their points moved to object space, last the deformable solids.
#include "scene/run/make_world.hpp"

#include "deformable/elasticity/totals.hpp"
#include "deformable/solid/make_deformable.hpp"
#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/bodies/mass.hpp"

#include <map>

namespace rigor {

namespace {

// Copies of the meshes of the scene, one for each mesh. Each world computes its own data of a mesh,
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

// A solid at its place, which starts to move like a rigid body.
Deformable make_solid(const SolidDescription& described)
{
    Deformable solid = make_deformable(described.name, *described.mesh, described.material,
                                       rotation_matrix(described.orientation), described.position);
    solid.integrator = described.integrator;
    solid.fracture_method = described.fracture_method;
    solid.handles = described.handles;
    solid.loads = described.loads;
    const Vector3d X = totals(solid).center_of_mass;
    const Vector3d &V = described.velocity, &w = described.angular_velocity;
    // v = V + ω × (x - X)
    for (std::size_t i = 0; i < solid.positions.size(); ++i)
        solid.velocities[i] = V + w.cross(solid.positions[i] - X);
    return solid;
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
    world.settings.gravity = scene.gravity;
    world.settings.integrator = scene.integrator;
    world.settings.contact_method = scene.contact_method;
    world.settings.skips = scene.skips;
    world.settings.formulas_are_reference = settings.formulas_are_reference;
    world.pool = ThreadPool(settings.threads);
    world.springs = scene.springs;
    world.forces = scene.forces;
    OwnMeshes meshes;
    for (const BodyDescription& described : scene.bodies) {
        RigidBody& body = world.bodies.emplace_back();
        body.name = described.name;
        body.parts = described.parts;
        meshes.take(body.parts);
        body.material = described.material;
        body.is_static = described.is_static;
        Vector3d center = Vector3d::Zero();
        if (body.is_static) {
            // A static body keeps mass 0.
        } else if (described.mass) {
            set_mass(body, *described.mass, described.inertia.value());
        } else {
            center = set_mass_from_parts(body);
        }
        const Matrix3d R = rotation_matrix(described.orientation);
        // L = I(t) ω,  I(t) = R I_body Rᵀ
        const Vector3d& w = described.angular_velocity;
        body.state = {described.position + R * center, described.orientation, described.velocity,
                      R * (body.inertia * (R.transpose() * w))};
        made.bodies.push_back({body.is_static, body.mass, center, body.inertia});
    }
    // Moves a point from the frame of the scene file to object space, whose origin is the center of
    // mass.
    const auto shift = [&](int body, Vector3d& point) {
        if (body >= 0) point -= made.bodies[static_cast<std::size_t>(body)].center_of_mass;
    };
    for (Spring& spring : world.springs) {
        shift(spring.body1, spring.point1);
        shift(spring.body2, spring.point2);
    }
    for (AppliedForce& force : world.forces)
        shift(force.body, force.point);
    for (const SolidDescription& solid : scene.solids)
        made.world.solids.push_back(make_solid(solid));
    return made;
}

} // namespace rigor
