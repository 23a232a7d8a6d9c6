// SPDX-License-Identifier: MIT
// Detection of contacts between the nodes of a solid and rigid bodies.
#pragma once

#include "deformable/contact/rigid_colliders.hpp"
#include "deformable/solid/deformable.hpp"
#include "rigid/detection/shapes/distance_field.hpp"

namespace rigor {

/// A node that touches a part of a rigid body, or may touch it within the step.
struct NodeContact {
    int node = 0, body = 0;
    int part = 0;                        // index of that part in `NodeContacts::parts_`
    double gap = 0;                      // distance to the part, negative inside [m]
    Vector3d normal = Vector3d::UnitY(); // outward unit normal of the body, world space
    double restitution = 0, friction = 0;
};

class NodeContacts {
public:
    /// Finds the nodes on the surface of the solid (`is_surface`) that may reach a body within a
    /// step. Their gaps and normals are not set until `measure` is called.
    void find(const Deformable& solid, const std::vector<char>& is_surface,
              const RigidColliders& rigid, double time_step, Counters& counters);
    /// Recomputes the gaps and normals of all contacts, for the current positions of nodes and
    /// surfaces. A node near several parts has a contact with each.
    void measure(const Deformable& solid, const RigidColliders& rigid);

    std::vector<NodeContact>& all() { return contacts_; }
    const std::vector<NodeContact>& all() const { return contacts_; }

private:
    struct NearPart {
        int body;
        Pose in_body;
        DistanceField field;
    };
    std::vector<NearPart> parts_;
    std::vector<NodeContact> contacts_;
};

} // namespace rigor
