// SPDX-License-Identifier: MIT
// Advances a world by one time step. For each solid, highest first, the code moves the nodes with
// their contacts, then lets the elements flow plastically at the new places of the nodes (unless
// they flowed in each explicit substep), then separates elements that stay inverted or, if there
// are none, opens cracks. Last comes the step of the rigid bodies, with the impulses of the nodes
// as forces.
#include "deformable/step/step.hpp"

#include "deformable/elasticity/flow.hpp"
#include "deformable/fracture/fracture.hpp"
#include "deformable/fracture/inverted_elements.hpp"
#include "deformable/motion/explicit_motion.hpp"
#include "deformable/motion/implicit_motion.hpp"
#include "deformable/motion/rigid_modes.hpp"
#include "deformable/solid/handles.hpp"
#include "rigid/bodies/height_order.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "rigid/step/step.hpp"

#include <algorithm>

namespace rigor {

namespace {

double radius_of(const Deformable& solid)
{
    Vector3d low = solid.positions.at(0), high = low;
    for (const Vector3d& x : solid.positions) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    return 0.5 * (high - low).norm();
}

void require_finite(const Deformable& solid, double time)
{
    for (std::size_t i = 0; i < solid.positions.size(); ++i) {
        require_in_range(solid.positions[i], solid.name, "x", time);
        require_in_range(solid.velocities[i], solid.name, "v", time);
    }
    for (const Matrix3d& strain : solid.plastic_strains)
        for (int axis = 0; axis < 3; ++axis)
            require_in_range(strain.col(axis), solid.name, "plastic strain", time);
}

void move(Deformable& solid, RigidColliders& rigid, World& world, double time_step)
{
    Workspace& work = workspace_of(solid);
    if (is_rigid(solid)) { // such a solid has no contacts and no plastic flow
        const NodeMotion motion{solid,      work,      rigid, world.settings.gravity,
                                world.time, time_step, 0,     world.counters};
        if (solid.integrator == NodeIntegrator::matrix)
            move_by_matrix(motion);
        else
            move_in_modes(motion);
        return;
    }
    work.contacts.find(solid, work.is_surface, rigid, time_step, world.counters);
    const NodeMotion motion{
        solid,         work, rigid, world.settings.gravity, world.time, time_step, radius_of(solid),
        world.counters};
    const bool is_explicit = solid.integrator == NodeIntegrator::explicit_step;
    if (is_explicit)
        move_explicitly(motion);
    else
        move_implicitly(motion);

    const SolidMaterial& m = solid.material;
    if (m.yield_stress == never && m.strength == never) return;
    if (!is_explicit || !flows_in_step(solid)) { // else the elements have flowed in each substep
        work.elements.strains(solid.positions, work.strains);
        if (m.yield_stress != never) flow(solid, work, world.settings, world.counters);
    }
    if (m.strength == never || separate_inverted_elements(solid, work, work.held, world, time_step))
        return;
    fracture(solid, work, world);
}

// Sorts the solids, highest center first. The lower one of two solids has to know the load that a
// rigid body between them passes on.
void sort_from_top(DeformableWorld& world)
{
    const Vector3d up = up_direction(world.rigid.settings.gravity);
    std::vector<SolidAtHeight>& order = world.from_top;
    order.clear();
    for (std::size_t i = 0; i < world.solids.size(); ++i) {
        const std::vector<Vector3d>& positions = world.solids[i].positions;
        double sum = 0;
        for (const Vector3d& x : positions)
            sum += up.dot(x);
        order.push_back({sum / static_cast<double>(positions.size()), i});
    }
    std::sort(order.begin(), order.end(), [](const SolidAtHeight& a, const SolidAtHeight& b) {
        return a.height != b.height ? a.height > b.height : a.solid < b.solid;
    });
}

// As long as this object lives, the impulses of the nodes act on the rigid bodies as forces.
class ForcesOfNodes {
public:
    ForcesOfNodes(const RigidColliders& rigid, World& world) : rigid_(rigid), world_(world)
    {
        rigid.apply_to(world);
    }
    ~ForcesOfNodes() { rigid_.end_forces(world_); }
    ForcesOfNodes(const ForcesOfNodes&) = delete;
    ForcesOfNodes& operator=(const ForcesOfNodes&) = delete;

private:
    const RigidColliders& rigid_;
    World& world_;
};

} // namespace

std::vector<ContactRecord> step(DeformableWorld& world, double time_step)
{
    if (!world.solids.empty()) {
        RigidColliders rigid(world.rigid, time_step);
        const std::vector<Pose> surfaces = rigid.surfaces;
        sort_from_top(world);
        for (const SolidAtHeight& next : world.from_top) {
            Deformable& solid = world.solids[next.solid];
            remember_first_places(solid);
            move(solid, rigid, world.rigid, time_step);
            require_finite(solid, world.rigid.time + time_step);
            rigid.surfaces = surfaces;
        }
        const ForcesOfNodes forces(rigid, world.rigid);
        return step(world.rigid, time_step);
    }
    return step(world.rigid, time_step);
}

} // namespace rigor
