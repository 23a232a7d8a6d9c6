// SPDX-License-Identifier: MIT
#include "geometry/distance/separation.hpp"

#include "geometry/convex/expanding_polytope.hpp"
#include "geometry/convex/simplex.hpp"
#include "geometry/distance/support.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "geometry/shapes/solid_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace rigor {

namespace {

// The difference of shape 1, moved by `shift`, and shape 2.
class MinkowskiDifference {
public:
    MinkowskiDifference(const Shape& shape1, const Pose& pose, const Shape& shape2)
        : shape1_(shape1), pose_(pose), shape2_(shape2)
    {
    }

    Vertex support_along(const Vector3d& d, const Vector3d& shift = Vector3d::Zero()) const
    {
        Vertex v;
        v.a = pose_ * support(shape1_, pose_.R.transpose() * d);
        v.b = support(shape2_, -d);
        v.w = v.a - v.b + shift;
        return v;
    }

    // Distance along the unit vector n, of shape 1 above shape 2; negative: overlap.
    double along(const Vector3d& n) const { return n.dot(support_along(-n).w); }

    // The shortest vector from shape 2 to shape 1, as long as it is longer than `least`; or the
    // simplex that it shrank to.
    std::optional<Separation> apart(const Vector3d& shift, double least, double reach,
                                    Simplex& simplex) const
    {
        simplex = simplex_of(support_along(Vector3d(-shift - pose_.X), shift));
        Vector3d v = simplex.nearest();
        for (int step = 0; step < 100; ++step) {
            const double length = v.norm();
            if (length <= least) return {};
            const Vertex next = support_along(-v, shift);
            const double bound = v.dot(next.w) / length; // no point of the difference is nearer
            if (bound >= reach) return of_normal(v / length, bound, simplex);
            if (length - bound <= 1e-12 * length) break;
            Simplex wider = simplex;
            wider.vertices[wider.count++] = next;
            const Simplex reduced = nearest_of(wider);
            if (reduced.count == 4) {
                simplex = reduced;
                return {};
            }
            const Vector3d nearest = reduced.nearest();
            if (!(nearest.squaredNorm() < v.squaredNorm())) break; // rounding: no progress
            simplex = reduced;
            v = nearest;
        }
        const Vector3d n = v.normalized();
        return of_normal(n, n.dot(support_along(-n, shift).w), simplex);
    }
    std::optional<Separation> apart(const Vector3d& shift, double least, double reach) const
    {
        Simplex simplex;
        return apart(shift, least, reach, simplex);
    }

    // From a point inside shape 2 to one inside shape 1.
    Vector3d between_insides() const { return pose_ * inside(shape1_) - inside(shape2_); }

private:
    static Vector3d inside(const Shape& shape)
    {
        const Mesh* mesh = std::get_if<Mesh>(&shape);
        return mesh ? mesh->solid->center() : Vector3d::Zero();
    }
    static Separation of_normal(const Vector3d& n, double distance, const Simplex& simplex)
    {
        return {distance, n, simplex.blend(&Vertex::a), simplex.blend(&Vertex::b)};
    }

    const Shape& shape1_;
    Pose pose_;
    const Shape& shape2_;
};

// Directions worth trying first: those of the faces, of the axes and between them.
std::vector<Vector3d> directions(const Shape& shape1, const Pose& pose, const Shape& shape2)
{
    std::vector<Vector3d> all, own;
    add_face_normals(shape2, pose.X, all);
    add_face_normals(shape1, -(pose.R.transpose() * pose.X), own);
    for (const Vector3d& n : own)
        all.push_back(-(pose.R * n));
    if (pose.X.norm() > 0) all.push_back(pose.X.normalized());
    for (int i = 0; i < 27; ++i)
        if (i != 13) all.push_back(Vector3d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1).normalized());
    return all;
}

struct PushOut : Separation {
    bool is_settled =
        false; // outside, the normal is the way's direction: no way beside it is shorter
};

// The way out along n, and from there on along the normal found outside, as long as that is shorter.
PushOut push_out(const MinkowskiDifference& difference, Vector3d n, double size)
{
    double margin =
        0.02 * size; // apart enough for a clean direction; the nearer, the longer a step
    double best = difference.along(n);
    PushOut result;
    for (int step = 0; step < 20; ++step, margin = std::max(0.2 * margin, 1e-5 * size)) {
        const auto found = difference.apart((margin - best) * n, 1e-9 * size, 1e300);
        if (!found) break;
        if (step == 0) static_cast<Separation&>(result) = *found;
        const double s = difference.along(found->normal);
        result.is_settled = (found->normal - n).norm() < 1e-6;
        if (!(s > best + 1e-13 * size)) break;
        static_cast<Separation&>(result) = *found;
        best = s;
        n = found->normal;
        if (result.is_settled) break;
    }
    result.distance = best;
    result.normal = n;
    return result;
}

// The normal of the nearest face of a polytope that grows until it reaches the difference there; empty
// if the origin is not inside even with the shapes pushed together a little.
std::optional<Vector3d> expanding_polytope_normal(const MinkowskiDifference& difference,
                                                  double size)
{
    const Vector3d inwards = difference.between_insides();
    const double length = inwards.norm();
    Vector3d shift = Vector3d::Zero();
    Simplex simplex;
    for (double push = 1e-6 * size; simplex.count < 4; push *= 10) {
        difference.apart(shift, 1e-12 * size, 1e300, simplex);
        if (simplex.count == 4) break;
        if (push > 1e-3 * size || !(length > push)) return {};
        shift = -push / length * inwards;
    }
    ExpandingPolytope polytope({simplex.vertices[0].w, simplex.vertices[1].w, simplex.vertices[2].w,
                                simplex.vertices[3].w});
    if (!polytope.is_solid()) return {};
    for (int step = 0; step < 100; ++step) {
        const Vector3d m = polytope.nearest_normal();
        const Vector3d w = difference.support_along(m, shift).w;
        if (m.dot(w) - polytope.nearest_distance() < 1e-7 * size || !polytope.add(w)) break;
    }
    return -polytope.nearest_normal();
}

Separation overlap(const MinkowskiDifference& difference, const std::vector<Vector3d>& tries,
                   double size)
{
    double least = std::numeric_limits<double>::infinity();
    Vector3d n = Vector3d::UnitY();
    for (const Vector3d& direction : tries)
        if (const double depth = -difference.along(direction); depth < least) {
            least = depth;
            n = direction;
        }
    const PushOut best = push_out(difference, n, size);
    constexpr double shallow = 0.02; // of the size: then no way elsewhere is much shorter
    if (-best.distance < shallow * size && best.is_settled) return best;
    if (const auto normal = expanding_polytope_normal(difference, size)) {
        const Separation other = push_out(difference, *normal, size);
        if (other.distance > best.distance + 1e-9 * size) return other;
    }
    return best;
}

double radius(const Shape& shape)
{
    Part part;
    part.shape = shape;
    return bounding_radius(part);
}

} // namespace

Separation separation(const Shape& shape1, const Pose& pose, const Shape& shape2, double reach)
{
    const MinkowskiDifference difference(shape1, pose, shape2);
    const double size = std::min(radius(shape1), radius(shape2));
    // nearer than this, the direction would be mostly rounding
    const double least = 1e-6 * size;
    if (const auto found = difference.apart(Vector3d::Zero(), least, reach)) return *found;
    return overlap(difference, directions(shape1, pose, shape2), size);
}

} // namespace rigor
