// SPDX-License-Identifier: MIT
// Finds the contacts of two convex shapes. First the code finds their closest points or, if they
// overlap, the shortest move that separates them; this gives the contact normal. Then the features
// (a point, a segment or a face) that both shapes turn to each other are projected along the
// normal, and one is clipped against the other (Sutherland and Hodgman 1974). Each corner of the
// result is a contact with its own gap.
#include "rigid/detection/shapes/convex_contact.hpp"

#include "geometry/distance/separation.hpp"
#include "geometry/distance/support.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/detection/shapes/reduce_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace rigor {

namespace {

using Eigen::Vector2d;

// Distance from a clipping line that counts as rounding, relative to the length of the line.
constexpr double line_rounding = 1e-9;
// Sine of the angle, about 6°, above which two segments count as crossing in one point. Segments at
// a smaller angle make a contact at each end of their common part, so that a body that rests on an
// edge does not rock.
constexpr double crossing_sine = 0.1;
// The closest points make a contact of their own only if their gap is smaller than the gap of every
// corner by more than this, relative to the distance of the closest point of shape 1 from the
// origin of shape 1. A smaller difference may be an error of the search for the closest points.
constexpr double gap_tolerance = 1e-6;

// A feature projected along the contact normal: `places` are positions in the tangent plane, and
// `heights` are positions along the normal [m].
struct Outline {
    std::vector<Vector2d> places;
    std::vector<double> heights;

    int count() const { return static_cast<int>(places.size()); }
    void add(const Vector2d& place, double height)
    {
        places.push_back(place);
        heights.push_back(height);
    }
};

double cross(const Vector2d& a, const Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

double signed_area(const Outline& o)
{
    double area = 0;
    for (int i = 1; i + 1 < o.count(); ++i)
        area += cross(o.places[i] - o.places[0], o.places[i + 1] - o.places[0]) / 2;
    return area;
}

// A frame of three columns: two axes perpendicular to the normal, and the normal.
Matrix3d frame_about(const Vector3d& n)
{
    int least = 0;
    n.cwiseAbs().minCoeff(&least);
    const Vector3d u = n.cross(Vector3d::Unit(least)).normalized();
    Matrix3d R;
    R << u, n.cross(u), n;
    return R;
}

// Projects a feature into the frame. The corners of a polygon are put in counter-clockwise order.
Outline outline(const Feature& feature, const Matrix3d& frame, const Vector3d& origin)
{
    Outline o;
    for (int i = 0; i < feature.count; ++i) {
        const Vector3d p = frame.transpose() * (feature.points[i] - origin);
        o.add(p.head<2>(), p.z());
    }
    if (signed_area(o) < 0) {
        std::reverse(o.places.begin(), o.places.end());
        std::reverse(o.heights.begin(), o.heights.end());
    }
    return o;
}

// The height of an outline at a place: that of the plane through a polygon, or of the line through
// a segment.
double height_at(const Outline& o, const Vector2d& place)
{
    const Vector2d p = place - o.places[0];
    if (o.count() == 2) {
        const Vector2d d = o.places[1] - o.places[0];
        return o.heights[0] + p.dot(d) / d.squaredNorm() * (o.heights[1] - o.heights[0]);
    }
    // The largest of the triangles at the first corner spans the plane.
    int best = 1;
    double widest = 0;
    for (int i = 1; i + 1 < o.count(); ++i) {
        const double area = cross(o.places[i] - o.places[0], o.places[i + 1] - o.places[0]);
        if (area <= widest) continue;
        widest = area;
        best = i;
    }
    const Vector2d a = o.places[best] - o.places[0], b = o.places[best + 1] - o.places[0];
    const double s = cross(p, b) / cross(a, b), t = cross(a, p) / cross(a, b);
    return o.heights[0] + s * (o.heights[best] - o.heights[0]) +
           t * (o.heights[best + 1] - o.heights[0]);
}

// The part of an outline to the left of the line from a to b. Points on the line up to rounding
// count as left of it; otherwise rounding would add corners where faces are aligned.
Outline left_of(const Outline& o, const Vector2d& a, const Vector2d& b)
{
    const Vector2d d = (b - a).normalized();
    const double border = -line_rounding * (b - a).norm();
    Outline kept;
    const int sides = o.count() > 2 ? o.count() : o.count() - 1;
    for (int i = 0; i < o.count(); ++i) {
        const int j = (i + 1) % o.count();
        const double from = cross(d, o.places[i] - a), to = cross(d, o.places[j] - a);
        if (from >= border) kept.add(o.places[i], o.heights[i]);
        if (i >= sides || (from >= border) == (to >= border)) continue;
        // A corner that counts as left of the line may lie slightly beyond it, and the quotient of
        // two rounding errors may be any number. The clamp keeps the new corner between corners i
        // and j.
        const double t = std::clamp(from / (from - to), 0.0, 1.0);
        kept.add(o.places[i] + t * (o.places[j] - o.places[i]),
                 o.heights[i] + t * (o.heights[j] - o.heights[i]));
    }
    return kept;
}

// The part of an outline that lies inside the polygon `by`.
Outline clipped(Outline o, const Outline& by)
{
    for (int i = 0; i < by.count() && o.count() > 0; ++i)
        o = left_of(o, by.places[i], by.places[(i + 1) % by.count()]);
    return o;
}

// The common part of two nearly parallel segments, along the first one. It is empty if the segments
// are not parallel, or if one ends before the other begins.
Outline common(const Outline& a, const Outline& b)
{
    const Vector2d d = a.places[1] - a.places[0], e = b.places[1] - b.places[0];
    Outline o;
    if (std::abs(cross(d, e)) > crossing_sine * d.norm() * e.norm()) return o; // not parallel
    const auto along = [&](const Vector2d& p) {
        return (p - a.places[0]).dot(d) / d.squaredNorm();
    };
    const double s = along(b.places[0]), t = along(b.places[1]);
    const double first = std::max(0.0, std::min(s, t)), last = std::min(1.0, std::max(s, t));
    if (first >= last) return o;
    for (const double at : {first, last})
        o.add(a.places[0] + at * d, a.heights[0] + at * (a.heights[1] - a.heights[0]));
    return o;
}

// The region where both features face each other, with the heights of feature 1. It is empty if a
// feature is a point, if two segments cross, or if the features do not face each other.
Outline overlap(const Outline& a, const Outline& b)
{
    if (a.count() < 2 || b.count() < 2) return {};
    if (a.count() == 2 && b.count() == 2) return common(a, b);
    if (b.count() > 2) return clipped(a, b);
    Outline o = clipped(b, a); // a segment below a polygon
    for (int i = 0; i < o.count(); ++i)
        o.heights[i] = height_at(a, o.places[i]);
    return o;
}

// Whether a place is inside a polygon or, up to rounding, on its border.
bool contains(const Outline& polygon, const Vector2d& place)
{
    for (int i = 0; i < polygon.count(); ++i) {
        const Vector2d& a = polygon.places[i];
        const Vector2d d = polygon.places[(i + 1) % polygon.count()] - a;
        if (cross(d, place - a) < -line_rounding * d.squaredNorm()) return false;
    }
    return true;
}

// The vertices of a mesh that stands for a round body (its `facet_angle` is not 0). Within a step,
// such a body can roll from the facet that faces the other shape to the next facets. For other
// shapes, the result is empty.
std::span<const Vector3d> vertices_of_round(const Shape& shape)
{
    const Mesh* mesh = std::get_if<Mesh>(&shape);
    if (!mesh || mesh->solid->facet_angle() == 0) return {};
    return mesh->solid->mesh().vertices;
}

// The middle of the gap where the shapes are nearest. If the feature of a shape is a single point,
// this point is used, because the closest points from the search for the distance are less exact:
// for a round shape and a large face they depend on the last triangle of the search.
Vector3d nearest_middle(const Separation& nearest, const Feature& feature1, const Feature& feature2)
{
    const Vector3d half = nearest.distance / 2 * nearest.normal;
    const Vector3d below1 = feature1.points[0] - half, above2 = feature2.points[0] + half;
    if (feature1.count == 1 && feature2.count == 1) return (below1 + above2) / 2;
    if (feature1.count == 1) return below1;
    if (feature2.count == 1) return above2;
    return (nearest.point1 + nearest.point2) / 2;
}

} // namespace

void find_convex_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                          const Pose& pose2, double reach, std::vector<Contact>& contacts)
{
    // All contacts are computed in the frame of shape 2, so that no digits are lost far from the
    // origin of the world.
    const Matrix3d to_2 = pose2.R.transpose();
    const Pose pose{to_2 * pose1.R, to_2 * (pose1.X - pose2.X)};
    const Separation nearest = separation(shape1, pose, shape2, reach);
    if (nearest.distance >= reach) return;

    const Vector3d& n = nearest.normal;
    Feature feature1 = feature_towards(shape1, -(pose.R.transpose() * n));
    for (int i = 0; i < feature1.count; ++i)
        feature1.points[i] = pose * feature1.points[i];
    const Matrix3d frame = frame_about(n);
    const Feature feature2 = feature_towards(shape2, n);
    const Outline above = outline(feature1, frame, nearest.point2);
    const Outline below = outline(feature2, frame, nearest.point2);

    const std::size_t first = contacts.size();
    const auto add = [&](const Vector3d& middle, double gap) {
        if (gap < reach) contacts.push_back({pose2 * middle, pose2.R * n, gap});
    };
    const Outline shared = overlap(above, below);
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < shared.count(); ++i) {
        const double floor = height_at(below, shared.places[i]);
        const double gap = shared.heights[i] - floor;
        Vector3d p(shared.places[i].x(), shared.places[i].y(), (shared.heights[i] + floor) / 2);
        lowest = std::min(lowest, gap);
        add(nearest.point2 + frame * p, gap);
    }
    const auto add_vertices = [&](const Shape& shape, const Pose& placed, const Outline& face,
                                  double sign) {
        if (face.count() < 3) return;
        for (const Vector3d& v : vertices_of_round(shape)) {
            const Vector3d p = frame.transpose() * (placed * v - nearest.point2);
            const double away = sign * (p.z() - height_at(face, p.head<2>()));
            if (away < reach && contains(face, p.head<2>()))
                add(nearest.point2 + frame * (p - away / 2 * sign * Vector3d::UnitZ()), away);
        }
    };
    add_vertices(shape1, pose, below, 1);
    add_vertices(shape2, Pose{}, above, -1);
    const double extent = (nearest.point1 - pose.X).norm();
    if (!(lowest <= nearest.distance + gap_tolerance * extent))
        add(nearest_middle(nearest, feature1, feature2), nearest.distance);
    reduce_contacts(contacts, first, reach);
}

} // namespace rigor
