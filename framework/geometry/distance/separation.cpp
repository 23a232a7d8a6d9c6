// SPDX-License-Identifier: MIT
// Computes the distance or the penetration depth of two convex shapes. Distances are found by the
// GJK algorithm (Gilbert, Johnson and Keerthi 1988), depths by pushing the shapes apart along
// candidate directions. GJK is tried first, then, if the shapes overlap, the candidates. If these
// are not enough, an expanding polytope (EPA, van den Bergen 2001) gives one more direction.
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

// The largest number of steps of GJK and of EPA. Both usually need far fewer; the limit guards
// against cycles that rounding causes.
constexpr int most_steps = 100;

// Relative error at which GJK's distance has converged: a few thousand times the rounding of a
// double.
constexpr double gjk_tolerance = 1e-12;

// The lengths from `least_distance` to `shallow` are in units of `size`, which is the smaller
// bounding radius of the two shapes.
//
// A distance found by GJK is used only if it is above this. At a smaller distance, the direction
// between the nearest points is mostly a rounding error.
constexpr double least_distance = 1e-6;
// After `push_out` has moved the shapes apart, GJK's normal and nearest points are used only if the
// distance is above this. Only rounding can make the distance smaller: the margin is far larger.
constexpr double least_gjk_length = 1e-9;
// The shapes count as touching if the origin is nearer to the simplex of GJK than this.
constexpr double inside_tolerance = 1e-12;
// EPA starts from a tetrahedron around the origin. Until GJK ends with one, the shapes are pushed
// together: first by `first_push`, then each time ten times as far, at most by `most_push`, and by
// less than their middles are apart.
constexpr double first_push = 1e-6;
constexpr double most_push = 1e-3;          // a longer push would change the result too much
constexpr double polytope_tolerance = 1e-7; // EPA ends when a step grows the polytope by less
// `push_out` begins with this margin, at which rounding hardly affects directions.
constexpr double first_margin = 0.02;
constexpr double least_margin = 1e-5; // the smallest margin of `push_out`
constexpr double margin_decay = 0.2;  // a step of `push_out` multiplies the margin by this
constexpr int most_pushes = 20;       // steps of `push_out`; five reach `least_margin`
constexpr double least_gain = 1e-13;  // a smaller reduction of the depth is rounding
// The direction that the polytope gives is used only if it reduces the depth by more than this.
constexpr double least_difference = 1e-9;
// A depth below this is accepted without the polytope, if `push_out` has found a local minimum: no
// other direction would give a much smaller depth.
constexpr double shallow = 0.02;

// Unit vectors count as the same direction if the length of their difference is below this.
constexpr double same_direction = 1e-6;

// A value of `reach` that asks for the exact distance, however far apart the shapes are [m].
constexpr double unlimited = 1e300;

// The Minkowski difference of shape 1 and shape 2. In its functions, an argument `shift` [m] moves
// shape 1.
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

    // The gap between the shapes along the unit vector n, which points from shape 2 to shape 1 [m].
    // It is negative if their projections on n overlap.
    double along(const Vector3d& n) const { return n.dot(support_along(-n).w); }

    // GJK: the shortest vector from shape 2 to shape 1. If the shapes are at least `reach` apart,
    // the search may end early, with a lower bound of the distance that is at least `reach`. The
    // result is empty if the shapes overlap or the vector is not longer than `least`. `simplex` is
    // set to the last simplex of the search.
    std::optional<Separation> apart(const Vector3d& shift, double least, double reach,
                                    Simplex& simplex) const
    {
        simplex = simplex_of(support_along(Vector3d(-shift - pose_.X), shift));
        Vector3d v = simplex.nearest();
        for (int step = 0; step < most_steps; ++step) {
            const double length = v.norm();
            if (length <= least) return {};
            const Vertex next = support_along(-v, shift);
            const double bound = v.dot(next.w) / length; // a lower bound of the distance
            if (bound >= reach) return of_normal(v / length, bound, simplex);
            if (length - bound <= gjk_tolerance * length) break;
            Simplex wider = simplex;
            wider.vertices[wider.count++] = next;
            Simplex reduced = nearest_of(wider);
            if (reduced.count == 4) {
                // If `bound` > 0, a plane lies between the shapes and they are apart, although
                // rounding may make a flat tetrahedron seem to contain the origin.
                if (!(bound > 0)) {
                    simplex = reduced;
                    return {};
                }
                reduced = nearest_face_of(wider);
            }
            const Vector3d nearest = reduced.nearest();
            // Rounding prevents further progress.
            if (!(nearest.squaredNorm() < v.squaredNorm())) break;
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

    // The vector from the middle of shape 2 to the middle of shape 1. The middle of a shape is its
    // origin or, for a mesh, the middle of its bounds, which may lie outside the mesh.
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

// Candidates for the direction of least depth: normals of faces, the line between the origins, and
// 26 directions along axes and diagonals.
std::vector<Vector3d> directions(const Shape& shape1, const Pose& pose, const Shape& shape2)
{
    std::vector<Vector3d> all, own;
    add_face_normals(shape2, pose.X, all);
    add_face_normals(shape1, -(pose.R.transpose() * pose.X), own);
    for (const Vector3d& n : own)
        all.push_back(-(pose.R * n));
    if (pose.X.norm() > 0) all.push_back(pose.X.normalized());
    for (int i = 0; i < 27; ++i)
        if (i != 13)
            all.push_back(
                Eigen::Vector3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1).cast<double>().normalized());
    return all;
}

struct PushOut : Separation {
    // Whether the normal of the separated shapes is the direction of the push. Then the depth has a
    // local minimum in this direction.
    bool is_settled = false;
};

// Pushes the shapes apart along n until their gap along n is a small margin. Repeats this along the
// normal of the separated shapes, as long as the depth becomes smaller. The margin shrinks from
// step to step, because a step with a smaller margin improves the depth more.
PushOut push_out(const MinkowskiDifference& difference, Vector3d n, double size)
{
    double margin = first_margin * size;
    const Vertex farthest = difference.support_along(-n);
    double best = n.dot(farthest.w);
    PushOut result;
    result.point1 = farthest.a;
    result.point2 = farthest.b;
    for (int step = 0; step < most_pushes;
         ++step, margin = std::max(margin_decay * margin, least_margin * size)) {
        const auto found =
            difference.apart((margin - best) * n, least_gjk_length * size, unlimited);
        if (!found) break;
        if (step == 0) static_cast<Separation&>(result) = *found;
        const double s = difference.along(found->normal);
        result.is_settled = (found->normal - n).norm() < same_direction;
        if (!(s > best + least_gain * size)) break;
        static_cast<Separation&>(result) = *found;
        best = s;
        n = found->normal;
        if (result.is_settled) break;
    }
    result.distance = best;
    result.normal = n;
    return result;
}

// EPA: the direction of least depth, from shape 2 to shape 1. It is the negative of the outward
// normal of the polytope's face nearest to the origin. The result is empty if the first tetrahedron
// is flat, or if no tetrahedron contains the origin, even after the shapes are pushed together a
// little.
std::optional<Vector3d> expanding_polytope_normal(const MinkowskiDifference& difference,
                                                  double size)
{
    const Vector3d inwards = difference.between_insides();
    const double length = inwards.norm();
    Vector3d shift = Vector3d::Zero();
    Simplex simplex;
    for (double push = first_push * size; simplex.count < 4; push *= 10) {
        difference.apart(shift, inside_tolerance * size, unlimited, simplex);
        if (simplex.count == 4) break;
        if (push > most_push * size || !(length > push)) return {};
        shift = -push / length * inwards;
    }
    ExpandingPolytope polytope({simplex.vertices[0].w, simplex.vertices[1].w, simplex.vertices[2].w,
                                simplex.vertices[3].w});
    if (!polytope.is_solid()) return {};
    for (int step = 0; step < most_steps; ++step) {
        const Vector3d m = polytope.nearest_normal();
        const Vector3d w = difference.support_along(m, shift).w;
        if (m.dot(w) - polytope.nearest_distance() < polytope_tolerance * size || !polytope.add(w))
            break;
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
    if (-best.distance < shallow * size && best.is_settled) return best;
    if (const auto normal = expanding_polytope_normal(difference, size)) {
        const Separation other = push_out(difference, *normal, size);
        if (other.distance > best.distance + least_difference * size) return other;
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
    const double least = least_distance * size;
    if (const auto found = difference.apart(Vector3d::Zero(), least, reach)) return *found;
    return overlap(difference, directions(shape1, pose, shape2), size);
}

} // namespace rigor
