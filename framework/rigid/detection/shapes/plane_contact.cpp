// SPDX-License-Identifier: MIT
// Contacts of a shape with a plane, in closed form. For each kind of shape it tests the points that
// can be lowest: vertices, ends, or points of a circle. Each one that is closer than the reach is a
// contact.
#include "rigid/detection/shapes/plane_contact.hpp"

#include "geometry/distance/support.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/detection/shapes/reduce_contacts.hpp"

#include <cmath>
#include <numbers>

namespace rigor {

namespace {

class AgainstPlane {
public:
    AgainstPlane(const Pose& pose, const Pose& plane, double reach, std::vector<Contact>& contacts)
        : pose_(pose), n_(plane.R.col(1)), height_(n_.dot(pose.X - plane.X)), reach_(reach),
          down_(-(pose.R.transpose() * n_)), contacts_(contacts)
    {
    }

    void operator()(const Sphere& s) const { add_ball({0, 0, 0}, s.radius); }
    void operator()(const Capsule& c) const
    {
        add_ball({0, -c.height / 2, 0}, c.radius);
        add_ball({0, c.height / 2, 0}, c.radius);
    }
    void operator()(const Torus& t) const { add_circle(t.radius, 0, t.tube); }
    void operator()(const Box& b) const
    {
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            add(sign.cwiseProduct(b.size / 2));
        }
    }
    void operator()(const Cylinder& c) const
    {
        add_circle(c.radius, -c.height / 2, 0);
        add_circle(c.radius, c.height / 2, 0);
    }
    void operator()(const Cone& c) const
    {
        add_circle(c.radius, -0.25 * c.height, 0);
        add({0, 0.75 * c.height, 0});
    }
    void operator()(const Ellipsoid& e) const { add(support(Shape(e), down_)); }
    void operator()(const Mesh& m) const
    {
        const std::size_t first = contacts_.size();
        const double lowest = height_ - down_.dot(m.solid->center()) - m.solid->radius();
        if (lowest >= reach_) return;
        for (const Vector3d& v : m.solid->mesh().vertices)
            add(v);
        reduce_contacts(contacts_, first, reach_);
    }
    void operator()(const Plane&) const {} // two planes never touch

private:
    double gap(const Vector3d& p) const { return height_ - down_.dot(p); }

    void add(const Vector3d& p) const { add_ball(p, 0); }

    // Adds a point of object space with a ball around it.
    void add_ball(const Vector3d& p, double radius) const
    {
        const double distance = gap(p) - radius;
        if (distance < reach_) contacts_.push_back({pose_ * p - radius * n_, n_, distance});
    }

    // Adds eight fixed points of a circle about y, and its lowest point if that is lower than
    // those.
    void add_circle(double radius, double height, double tube) const
    {
        double lowest = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 8; ++i) {
            const double angle = std::numbers::pi / 4 * i;
            const Vector3d p(radius * std::cos(angle), height, radius * std::sin(angle));
            lowest = std::min(lowest, gap(p));
            add_ball(p, tube);
        }
        const double slope = std::hypot(down_.x(), down_.z());
        if (!(slope > 0)) return;
        const Vector3d p(radius * down_.x() / slope, height, radius * down_.z() / slope);
        if (gap(p) < lowest - 1e-9 * radius) add_ball(p, tube);
    }

    const Pose& pose_;
    Vector3d n_;
    double height_; // height of the shape's origin above the plane [m]
    double reach_;
    Vector3d down_; // towards the plane, in object space
    std::vector<Contact>& contacts_;
};

} // namespace

void find_plane_contacts(const Shape& shape, const Pose& pose, const Pose& plane, double reach,
                         std::vector<Contact>& contacts)
{
    std::visit(AgainstPlane(pose, plane, reach, contacts), shape);
}

} // namespace rigor
