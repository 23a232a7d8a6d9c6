// SPDX-License-Identifier: MIT
// Data that a step derives from a solid. It is kept until the mesh or the material changes. It
// includes most buffers of a step, so that these are not allocated again in each step.
#pragma once

#include "deformable/contact/node_contacts.hpp"
#include "deformable/elasticity/element_workspace.hpp"
#include "deformable/motion/contact_set.hpp"
#include "deformable/motion/flow_in_step.hpp"
#include "deformable/motion/joined_bodies.hpp"
#include "deformable/motion/open_parts.hpp"
#include "deformable/motion/velocity_system.hpp"
#include "deformable/solid/handles.hpp"

namespace rigor {

struct Workspace : ElementWorkspace {
    explicit Workspace(const Deformable& solid);

    int topology;
    SolidMaterial material;
    std::vector<char> is_surface; // for each node, whether it is on the boundary of the material
    double stable_step = 0;       // longest stable explicit substep, 0 until it is computed [s]

    // Buffers of a step.
    std::vector<Vector3d> forces;
    std::vector<HeldNode> held;
    std::vector<int> held_entries;   // memory for `hold_nodes`
    std::vector<HeldAxes> held_axes; // for each node
    NodeContacts contacts;

    // Data for implicit steps only.
    VelocitySystem velocity_system;
    JoinedBodies bodies;
    ContactSet contact_set;
    OpenParts parts;
    FlowInStep flow_in_step;
    std::vector<SystemBody> no_bodies; // always empty; passed to a solve without rigid bodies
};

/// The workspace of a solid. It is made again if the mesh or the material has changed (apart from
/// `SolidMaterial::surface`, on which it does not depend).
Workspace& workspace_of(Deformable& solid);

} // namespace rigor
