// SPDX-License-Identifier: MIT
// Finds the contacts of a convex shape with the shape to which a distance field belongs. Iterations
// start from points spread over the surface. Each step goes to the point of the surface that lies
// farthest in the direction opposite to the field's gradient, until this direction no longer
// changes. The points where the iterations end are local minima of the field on the surface. Those
// that are close enough are contacts.
#include "rigid/detection/shapes/smooth_contact.hpp"

#include "geometry/distance/support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

constexpr double alike = 0.98; // cosine of 11°: directions at a smaller angle count as equal
constexpr int most_steps = 4;  // largest number of steps of an iteration
// An iteration has converged if 1 - cosine of the angle between its last two gradients is below
// this value.
constexpr double converged = 1e-12;
constexpr double zero_length = 1e-9; // a shorter sum of parts of unit vectors is a rounding error

// At a point p of the surface of a convex shape, the outward normal that is closest to the
// direction d. (At an edge or a corner there are several outward normals.)
struct NormalAt {
    const Vector3d& p;
    const Vector3d& d;

    // Points this close to a face, relative to the size of the shape, lie on the face up to
    // rounding.
    static constexpr double rounding = 1e-9;
    static constexpr double on_it = 1 - rounding;

    // The unit vector along the sum of the parts of d along orthogonal normals, without the parts
    // that are opposite to a normal. It is the first normal if the sum is zero.
    static Vector3d sum(std::initializer_list<Vector3d> normals, const Vector3d& d)
    {
        Vector3d n = Vector3d::Zero();
        for (const Vector3d& face : normals)
            n += std::max(0.0, face.dot(d)) * face;
        return n.norm() > zero_length ? Vector3d(n.normalized()) : *normals.begin();
    }
    Vector3d outward() const
    {
        const double r = std::hypot(p.x(), p.z());
        return r > 0 ? Vector3d(p.x() / r, 0, p.z() / r) : Vector3d::UnitX();
    }

    Vector3d operator()(const Box& b) const
    {
        Vector3d n = Vector3d::Zero();
        for (int i = 0; i < 3; ++i)
            if (std::abs(p[i]) >= on_it * b.size[i] / 2 && p[i] * d[i] > 0) n[i] = d[i];
        return n.norm() > zero_length ? Vector3d(n.normalized()) : d;
    }
    Vector3d operator()(const Cylinder& c) const
    {
        const Vector3d cap(0, p.y() < 0 ? -1 : 1, 0);
        const bool on_cap = std::abs(p.y()) >= on_it * c.height / 2;
        const bool on_side = std::hypot(p.x(), p.z()) >= on_it * c.radius;
        if (on_cap && on_side) return sum({cap, outward()}, d);
        return on_side ? outward() : cap;
    }
    Vector3d operator()(const Cone& c) const
    {
        const Vector3d base = -Vector3d::UnitY();
        const Vector3d slope = (c.height * outward() + Vector3d(0, c.radius, 0)).normalized();
        const double above_base = p.y() + 0.25 * c.height;
        if (above_base >= on_it * c.height) { // the tip has a cone of normals about y
            if (d.y() >= slope.y()) return d;
            const double r = std::hypot(d.x(), d.z());
            if (!(r > 0)) return slope;
            return (c.height * Vector3d(d.x() / r, 0, d.z() / r) + Vector3d(0, c.radius, 0))
                .normalized();
        }
        if (above_base > rounding * c.height) return slope;
        if (std::hypot(p.x(), p.z()) < on_it * c.radius) return base;
        // At the rim the normal lies between those of the base and the slope.
        const Vector3d in_plane(outward() * outward().dot(d) + Vector3d(0, d.y(), 0));
        if (in_plane.norm() < zero_length || in_plane.normalized().dot(slope) < base.dot(slope))
            return base.dot(d) > slope.dot(d) ? base : slope;
        const Vector3d n = in_plane.normalized();
        if (n.y() > slope.y()) return slope;
        return n.dot(outward()) < 0 ? base : n;
    }
    Vector3d operator()(const Ellipsoid& e) const
    {
        return p.cwiseQuotient(e.radii).cwiseQuotient(e.radii).normalized();
    }
    template <class Other> Vector3d operator()(const Other&) const { return d; }
};

// Points spread over the surface, one for each of 26 directions: the middle of the face, edge or
// point that lies farthest in this direction.
std::vector<Vector3d> seeds(const Shape& shape)
{
    std::vector<Vector3d> points;
    for (int i = 0; i < 27; ++i)
        if (i != 13) {
            const Eigen::Vector3i direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            const Vector3d d = direction.cast<double>().normalized();
            const Feature feature = feature_towards(shape, d);
            Vector3d middle = Vector3d::Zero();
            for (int k = 0; k < feature.count; ++k)
                middle += feature.points[k] / feature.count;
            points.push_back(middle);
        }
    return points;
}

// Finds the contacts of a convex shape.
class OnSurface {
public:
    OnSurface(const Shape& shape, const Pose& pose, const DistanceField& field, double reach,
              std::vector<Contact>& contacts)
        : shape_(shape), pose_(pose), field_(field), reach_(reach), contacts_(contacts)
    {
    }

    DeepestPoint find()
    {
        const std::vector<Vector3d> points = seeds(shape_);
        double spacing = 0; // estimate of the largest distance from a surface point to a seed
        for (const Vector3d& p : points)
            spacing = std::max(spacing, p.norm() / 2);
        for (const Vector3d& p : points) {
            const double distance = field_.distance(pose_ * p);
            deepest_.consider(pose_ * p, distance);
            if (distance < reach_ + spacing) start(p);
        }
        return deepest_;
    }

private:
    Vector3d gradient(const Vector3d& p) const
    {
        return pose_.R.transpose() * field_.normal(pose_ * p);
    }

    // Whether n differs from all directions in `known`. If so, n is added to `known`.
    static bool is_new(const Vector3d& n, std::vector<Vector3d>& known)
    {
        if (std::any_of(known.begin(), known.end(),
                        [&](const Vector3d& k) { return k.dot(n) > alike; }))
            return false;
        known.push_back(n);
        return true;
    }

    void start(const Vector3d& seed)
    {
        Vector3d n = gradient(seed);
        if (!is_new(n, starts_)) return;
        for (int step = 0; step < most_steps; ++step) {
            const Vector3d at_lowest = gradient(lowest(feature_towards(shape_, -n)));
            const bool is_there = at_lowest.dot(n) > 1 - converged;
            n = at_lowest;
            if (is_there) break;
        }
        if (!is_new(n, ends_)) return;
        const Feature feature = feature_towards(shape_, -n);
        for (int i = 0; i < feature.count; ++i)
            add(feature.points[i]);
    }

    Vector3d lowest(const Feature& feature) const
    {
        int best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < feature.count; ++i) {
            const double d = field_.distance(pose_ * feature.points[i]);
            if (d >= least) continue;
            least = d;
            best = i;
        }
        return feature.points[best];
    }

    void add(const Vector3d& p)
    {
        const Vector3d x = pose_ * p;
        const double gap = field_.distance(x);
        deepest_.consider(x, gap);
        if (gap >= reach_) return;
        const Vector3d against = -gradient(p);
        const Vector3d own = std::visit(NormalAt{p, against}, shape_);
        if (own.dot(against) < least_opposition) return;
        const Vector3d n = -(pose_.R * own);
        contacts_.push_back({x - gap / 2 * n, n, gap});
    }

    const Shape& shape_;
    const Pose& pose_;
    const DistanceField& field_;
    double reach_;
    std::vector<Contact>& contacts_;
    DeepestPoint deepest_;
    std::vector<Vector3d> starts_, ends_; // gradients at the start and the end of iterations
};

} // namespace

DeepestPoint find_smooth_contacts(const Shape& shape, const Pose& pose, const DistanceField& field,
                                  double reach, std::vector<Contact>& contacts)
{
    return OnSurface(shape, pose, field, reach, contacts).find();
}

} // namespace rigor
