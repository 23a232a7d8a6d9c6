// SPDX-License-Identifier: MIT
// Where nodes of a solid meet rigid bodies.
#pragma once

#include "deformable/contact/rigid_colliders.hpp"
#include "deformable/solid/deformable.hpp"
#include "rigid/distance_field.hpp"

namespace rigor {

/// A node that is, or soon may be, at the surface of a part of a rigid body.
struct NodeContact {
    int node = 0, body = 0;
    int part = 0;                        // among those that are near
    double gap = 0;                      // negative inside [m]
    Vector3d normal = Vector3d::UnitY(); // of the body, outwards
    double restitution = 0, friction = 0;
};

class NodeContacts {
public:
    /// The nodes that may meet a body within a step.
    void find(const Deformable& solid, const std::vector<char>& is_surface,
              const RigidColliders& rigid, double time_step, Counters& counters);
    /// Gaps and normals where the nodes and the surfaces are now. Of a node in several parts' reach
    /// each counts.
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
