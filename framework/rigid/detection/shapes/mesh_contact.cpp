// SPDX-License-Identifier: MIT
// Finds the contacts of a mesh with another solid shape. The surface points of each shape are
// tested in the distance field of the other (Guendelman, Bridson and Fedkiw 2003), where a bounding
// tree skips points that are far away. Contacts of sharp edges are added. If the shapes overlap but
// no contact has a negative gap, for example because a thin bar has pierced a wall, the deepest of
// all tested points becomes a contact. The result is reduced to a few contacts.
#include "rigid/detection/shapes/mesh_contact.hpp"

#include "geometry/distance/signed_distance.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/detection/shapes/distance_field.hpp"
#include "rigid/detection/shapes/edge_contact.hpp"
#include "rigid/detection/shapes/reduce_contacts.hpp"
#include "rigid/detection/shapes/smooth_contact.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace rigor {

namespace {

// If the distance of a node of the tree from the shape is larger than this multiple of the node's
// radius, only one point of the node is tested. With a smaller value fewer points are tested, but
// the untested points may be much nearer than the tested one.
constexpr double far = 6;
// Two lengths, divided by the spacing of the surface points. A node of the tree with a radius below
// `small_node` has one contact, at its nearest point. Two points are equally near if their
// distances differ by less than `equally_near`.
constexpr double small_node = 1.5, equally_near = 1e-3;
// Two gradients belong to one flat face if their difference is shorter than this.
constexpr double same_face = 1e-3;

// The surface points of a mesh that are near another shape.
class PointsInField {
public:
    // @param pose  pose of the mesh in the frame of the field
    PointsInField(const SolidMesh& mesh, const Pose& pose, const DistanceField& field, double reach)
        : surface_(mesh.surface()), pose_(pose), field_(field), reach_(reach),
          facet_cosine_(std::cos(mesh.facet_angle()))
    {
    }

    // Appends contacts in the frame of the field, with normals out of the field's shape.
    // @return the deepest of all tested points, whether it is a contact or not
    DeepestPoint find(std::vector<Contact>& contacts)
    {
        const std::size_t first = contacts.size();
        descend(0, contacts);
        if (facet_cosine_ < 1) remove_points_ahead_of_round(contacts, first);
        return deepest_;
    }

private:
    // Tests the points of a node of the tree, by the first of these rules that applies:
    //   1. If the node is known to be farther away than the reach, no point is tested.
    //   2. If the node is a leaf, all its points are tested, and the nearest one makes a contact.
    //   3. If the distance of its middle is larger than `far` times its radius, one point is
    //      tested, because all its points have about the same distance.
    //   4. If its radius is below `small_node` spacings, it is treated as a leaf.
    //   5. Otherwise its two children are treated in the same way.
    void descend(int index, std::vector<Contact>& contacts)
    {
        const BoundingTree::Node& node = surface_.point_tree().nodes()[index];
        const Vector3d middle = pose_ * ((node.bounds.low + node.bounds.high) / 2);
        const double radius = (node.bounds.high - node.bounds.low).norm() / 2;
        const double farthest = reach_ + radius + field_.uncertainty();
        if (field_.at_least(middle) >= farthest) return;
        if (node.is_leaf()) return add_nearest(node.first, node.last, contacts);
        const double distance = field_.distance(middle);
        if (distance >= farthest) return;
        if (distance > far * radius) return add_nearest(node.first, node.first + 1, contacts);
        if (radius < small_node * surface_.spacing())
            return add_nearest(node.first, node.last, contacts);
        descend(index + 1, contacts);
        descend(node.right, contacts);
    }

    void add_nearest(int first, int last, std::vector<Contact>& contacts)
    {
        const double as_near = equally_near * surface_.spacing();
        int nearest = -1;
        double least = reach_;
        for (int i = first; i < last; ++i) {
            const int number = surface_.point_tree().order()[i];
            const double gap = field_.distance(pose_ * surface_.points()[number].point);
            // If points are equally near, the one with the lowest index is taken: a vertex
            // rather than a point on an edge, and a point on an edge rather than one on a face.
            const bool is_nearer = nearest < 0        ? gap < reach_
                                   : number < nearest ? gap < least + as_near
                                                      : gap < least - as_near;
            if (!is_nearer) continue;
            nearest = number;
            least = gap;
        }
        if (nearest >= 0) add(surface_.points()[nearest], least, contacts);
    }

    void add(const SurfacePoint& sample, double gap, std::vector<Contact>& contacts)
    {
        const Vector3d p = pose_ * sample.point;
        deepest_.consider(p, gap);
        const Vector3d gradient = field_.normal(p);
        const Vector3d own =
            surface_.nearest_normal(sample.cone, -(pose_.R.transpose() * gradient));
        const Vector3d n = -(pose_.R * own);
        if (n.dot(gradient) < least_opposition) return;
        contacts.push_back({p - gap / 2 * n, n, gap});
        gradients_.push_back(gradient);
    }

    // For a mesh that stands for a round body, removes the contacts for which all of these
    // conditions hold:
    //   1. The contact has a gap.
    //   2. Its normal differs from the gradient by more than `SolidMesh::facet_angle`.
    //   3. Another contact at the same flat face has a smaller gap, and a normal that differs from
    //      the gradient by at most this angle.
    // The points of such contacts lie on the front of a rolling wheel, and the wheel turns them
    // away before they touch.
    void remove_points_ahead_of_round(std::vector<Contact>& contacts, std::size_t first) const
    {
        // Whether the normal and the gradient differ by at most the angle of a facet.
        const auto faces = [&](std::size_t i) {
            return contacts[i].normal.dot(gradients_[i - first]) >= facet_cosine_;
        };
        std::vector<std::size_t> facing;
        for (std::size_t i = first; i < contacts.size(); ++i)
            if (faces(i)) facing.push_back(i);
        if (facing.empty() || facing.size() == contacts.size() - first) return;
        const auto is_ahead = [&](std::size_t i) {
            const double gap = contacts[i].gap;
            return gap > 0 && !faces(i) &&
                   std::any_of(facing.begin(), facing.end(), [&](std::size_t k) {
                       return contacts[k].gap < gap &&
                              (gradients_[k - first] - gradients_[i - first]).norm() < same_face;
                   });
        };
        std::vector<Contact> kept;
        for (std::size_t i = first; i < contacts.size(); ++i)
            if (!is_ahead(i)) kept.push_back(contacts[i]);
        contacts.resize(first);
        contacts.insert(contacts.end(), kept.begin(), kept.end());
    }

    const MeshSurface& surface_;
    const Pose& pose_;
    const DistanceField& field_;
    double reach_, facet_cosine_;
    std::vector<Vector3d> gradients_; // one for each contact that was found
    DeepestPoint deepest_;
};

Pose inverse(const Pose& pose)
{
    return {pose.R.transpose(), -(pose.R.transpose() * pose.X)};
}

// The contact of a point that lies inside a field's shape, in the frame of the field. The normal is
// the gradient of the distance, which points along the nearest way out.
Contact contact_of_deepest(const DeepestPoint& deepest, const DistanceField& field)
{
    const Vector3d n = field.normal(deepest.point);
    return {deepest.point - deepest.gap / 2 * n, n, deepest.gap};
}

// Converts a contact from the frame of shape 1, with a normal from 1 to 2, to the frame of shape 2,
// with a normal from 2 to 1.
Contact seen_from_2(const Contact& contact, const Pose& from_1)
{
    return {from_1 * contact.point, -(from_1.R * contact.normal), contact.gap};
}

bool any_overlaps(const std::vector<Contact>& contacts)
{
    return std::any_of(contacts.begin(), contacts.end(),
                       [](const Contact& c) { return c.gap < 0; });
}

// Appends the contacts of surface points of mesh 2 with shape 1, in the frame of the mesh, with
// normals from 2 to 1.
// @param from_1  pose of shape 1 in the frame of the mesh
// @return the deepest of all tested points, in the frame of shape 1
DeepestPoint add_points(const Shape& shape1, const Pose& from_1, const SolidMesh& mesh2,
                        double reach, Counters& counters, std::vector<Contact>& found)
{
    const DistanceField field1(shape1, counters);
    const Pose from_2 = inverse(from_1);
    const std::size_t first = found.size();
    const DeepestPoint deepest = PointsInField(mesh2, from_2, field1, reach).find(found);
    for (std::size_t i = first; i < found.size(); ++i)
        found[i] = seen_from_2(found[i], from_1);
    return deepest;
}

// Whether a contact of a mesh point lies ahead of a rolling shape 1, so that `remove_points_ahead`
// removes it (mesh_contact.hpp lists the conditions).
bool is_ahead_on_face(const Contact& point, const Shape& shape1, const Pose& pose1,
                      std::span<const Contact> others, double share)
{
    constexpr double same = 1e-6; // directions count as equal if 1 - cosine is below this value
    // Two points lie on one flat face if their heights above it differ by at most this share of
    // their distance.
    constexpr double level = 1e-6;
    if (point.gap <= 0) return false;
    const Vector3d x = point.point - point.gap / 2 * point.normal; // on the face
    const Vector3d away =
        pose1.R * signed_distance(shape1, pose1.R.transpose() * (x - pose1.X)).normal;
    if (point.normal.dot(away) < -1 + same) return false;
    return std::any_of(others.begin(), others.end(), [&](const Contact& c) {
        if (c.gap >= point.gap || c.normal.dot(point.normal) < 1 - same) return false;
        const Vector3d apart = c.point - share * c.gap * c.normal - x;
        return std::abs(apart.dot(c.normal)) <= level * apart.norm();
    });
}

bool is_round(const Shape& shape)
{
    return std::holds_alternative<Cylinder>(shape) || std::holds_alternative<Cone>(shape) ||
           std::holds_alternative<Ellipsoid>(shape);
}

} // namespace

void remove_points_ahead(std::vector<Contact>& points, const Shape& shape1, const Pose& pose1,
                         std::span<const Contact> others, double share)
{
    std::erase_if(points, [&](const Contact& point) {
        return is_ahead_on_face(point, shape1, pose1, others, share);
    });
}

void find_point_contacts(const Shape& shape1, const Pose& pose1, const SolidMesh& mesh2,
                         const Pose& pose2, double reach, Counters& counters,
                         std::vector<Contact>& contacts)
{
    const std::size_t first = contacts.size();
    add_points(shape1, inverse(pose2) * pose1, mesh2, reach, counters, contacts);
    for (std::size_t i = first; i < contacts.size(); ++i)
        contacts[i] = {pose2 * contacts[i].point, pose2.R * contacts[i].normal, contacts[i].gap};
}

void find_mesh_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                        const Pose& pose2, double reach, Counters& counters,
                        std::vector<Contact>& contacts)
{
    const SolidMesh& mesh2 = *std::get<Mesh>(shape2).solid;
    const Pose from_1 = inverse(pose2) * pose1, from_2 = inverse(from_1);
    Bounds near2 = mesh2.bounds(), near1 = bounds_of(shape1, {});
    near2.grow(reach);
    near1.grow(reach);
    if (!near2.overlaps(bounds_of(shape1, from_1)) || !near1.overlaps(bounds_of(shape2, from_2)))
        return;

    std::vector<Contact> found; // in the frame of shape 2, normals from 2 to 1
    const DeepestPoint of_2 = add_points(shape1, from_1, mesh2, reach, counters, found);
    std::vector<Contact> own; // contacts of points of shape 1, if it is no mesh
    const DistanceField field2(shape2, counters);
    const Mesh* mesh1 = std::get_if<Mesh>(&shape1);
    const DeepestPoint of_1 = mesh1
                                  ? PointsInField(*mesh1->solid, from_1, field2, reach).find(found)
                                  : find_smooth_contacts(shape1, from_1, field2, reach, own);
    if (is_round(shape1)) remove_points_ahead(found, shape1, from_1, own, 0.5);
    found.insert(found.end(), own.begin(), own.end());
    find_edge_contacts(shape1, from_1, mesh2.surface(), reach, found);
    const bool is_missed = !any_overlaps(found);
    if (is_missed && of_1.gap < 0 && of_1.gap <= of_2.gap)
        found.push_back(contact_of_deepest(of_1, field2));
    else if (is_missed && of_2.gap < 0)
        found.push_back(
            seen_from_2(contact_of_deepest(of_2, DistanceField(shape1, counters)), from_1));
    reduce_contacts(found, 0, reach);
    for (const Contact& t : found)
        contacts.push_back({pose2 * t.point, pose2.R * t.normal, t.gap});
}

} // namespace rigor
