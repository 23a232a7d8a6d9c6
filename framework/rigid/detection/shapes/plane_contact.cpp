// SPDX-License-Identifier: MIT
// Finds the contacts of a shape with a plane, in closed form. For each kind of shape, the code
// tests the points that can be lowest: vertices, ends, or points of a circle. Each of these points
// that is closer than the reach is a contact.
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

    // Adds the contact of a ball around the point p of object space.
    void add_ball(const Vector3d& p, double radius) const
    {
        const double distance = gap(p) - radius;
        if (distance < reach_) contacts_.push_back({pose_ * p - radius * n_, n_, distance});
    }

    // Adds points of a circle about y: eight fixed points if the circle is parallel to the plane,
    // otherwise the lowest point and the three points at quarters of a turn from it. Fixed
    // points of a circle that rolls would hit the plane one after the other like the spokes of a
    // wheel without a rim.
    void add_circle(double radius, double height, double tube) const
    {
        constexpr double flat = 1e-6; // sine of the largest angle that counts as parallel
        const double slope = std::hypot(down_.x(), down_.z());
        const bool is_flat = !(slope > flat);
        const double first = is_flat ? 0 : std::atan2(down_.z(), down_.x());
        const int points = is_flat ? 8 : 4;
        for (int i = 0; i < points; ++i) {
            const double angle = first + 2 * std::numbers::pi / points * i;
            add_ball({radius * std::cos(angle), height, radius * std::sin(angle)}, tube);
        }
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
