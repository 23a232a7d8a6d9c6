// SPDX-License-Identifier: MIT
// Finds the contacts of shapes that are a core (a point, a segment or a circle) with a radius
// around it: spheres, capsules and tori; other engines call such shapes rounded. The distance of
// the other shape is sampled along the core. Each minimum of the samples is refined by golden
// section search (Kiefer 1953), and along a segment also each end of a part where the distance
// changes linearly, by bisection. Spheres on a torus or a mesh have methods of their own. For a
// capsule or a torus on a mesh that is not convex, contacts at the points of the mesh are added.
#include "rigid/detection/shapes/core_contact.hpp"

#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/detection/shapes/distance_field.hpp"
#include "rigid/detection/shapes/mesh_contact.hpp"
#include "rigid/detection/shapes/reduce_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace rigor {

namespace {

// Number of samples along a segment (the ends of 16 equal intervals) and around a circle (7.5°
// apart). A local minimum of the gap is found if a sample near it is lower than the two samples
// beside this sample. A minimum in an interval narrower than the spacing may be missed. More
// samples take more time; the numbers were chosen by trial.
constexpr int segment_samples = 17, circle_samples = 48;
constexpr int golden_steps = 42; // 42 steps shorten an interval to 0.618⁴² = 2e-9 of its length
// A minimum between two samples becomes one more contact only if its gap is smaller than the gap at
// the sample by more than this fraction of the core's length. A smaller difference may be an
// error of the search.
constexpr double least_improvement = 1e-9;

// A core curve with a radius around it, in the frame of the other shape.
struct Core {
    double radius = 0;
    double length = 0; // range of the parameter s: [m] on a segment, [rad] on a circle
    int samples = 1;
    bool is_closed = false;
    Pose pose;
    double circle = 0; // radius of the circle, if the curve is closed

    Vector3d at(double s) const
    {
        if (!is_closed) return pose * Vector3d(0, s - length / 2, 0);
        return pose * Vector3d(circle * std::cos(s), 0, circle * std::sin(s));
    }
    double meters() const { return is_closed ? length * circle : length; }
};

struct CoreOf {
    const Pose& pose;

    Core operator()(const Sphere& s) const
    {
        Core core;
        core.radius = s.radius;
        core.pose = pose;
        return core;
    }
    Core operator()(const Capsule& c) const
    {
        return {c.radius, c.height, segment_samples, false, pose, 0};
    }
    Core operator()(const Torus& t) const
    {
        return {t.tube, 2 * std::numbers::pi, circle_samples, true, pose, t.radius};
    }
    template <class Other> Core operator()(const Other&) const { return {}; }
};

// A local minimum of f between a and b by golden section search (Kiefer 1953).
template <class Function> double minimum(const Function& f, double a, double b)
{
    constexpr double golden = 0.6180339887498949; // (√5 - 1) / 2
    double s = b - golden * (b - a), t = a + golden * (b - a);
    double f_s = f(s), f_t = f(t);
    for (int i = 0; i < golden_steps; ++i) {
        if (f_s <= f_t) {
            b = t;
            t = s;
            f_t = f_s;
            s = b - golden * (b - a);
            f_s = f(s);
        } else {
            a = s;
            s = t;
            f_s = f_t;
            t = a + golden * (b - a);
            f_t = f(t);
        }
    }
    return (a + b) / 2;
}

// Finds the contacts of a core curve (the segment of a capsule, the circle of a torus): at its
// samples or, on a circle, around the nearest point, and at the minima of the gap along the curve.
class AlongCore {
public:
    AlongCore(const Core& core, const DistanceField& field, const Pose& pose2, double reach,
              std::vector<Contact>& contacts)
        : core_(core), field_(field), pose2_(pose2), reach_(reach), contacts_(contacts)
    {
    }

    void find()
    {
        if (core_.samples == 1) return add(0);
        const int n = core_.samples;
        const double step = core_.length / (core_.is_closed ? n : n - 1);
        std::vector<double> gaps;
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < n; ++i) {
            gaps.push_back(gap(i * step));
            least = std::min(least, gaps.back());
        }
        // Between two samples, the gap is smaller than at the nearer sample by at most half the
        // distance between the samples. The test allows for about twice this.
        if (least - core_.meters() / n - field_.uncertainty() >= reach_) return;
        const std::size_t first = contacts_.size();
        if (core_.is_closed)
            find_on_ring(gaps, step);
        else
            find_on_segment(gaps, step);
        reduce_contacts(contacts_, first, reach_,
                        core_.is_closed ? most_contacts : most_contacts / 2);
    }

private:
    double gap(double s) const { return field_.ball_distance(core_.at(s), core_.radius); }

    void find_on_ring(const std::vector<double>& gaps, double step)
    {
        const int n = core_.samples;
        const double lowest = add_around_lowest(gaps, step);
        for (int i = 0; i < n; ++i) {
            if (gaps[i] > gaps[(i + n - 1) % n] || gaps[i] > gaps[(i + 1) % n]) continue;
            const double from_lowest = std::abs(std::remainder(i * step - lowest, core_.length));
            if (from_lowest > 2 * step) refine(i, step, gaps[i]);
        }
    }

    // Adds the ends of the segment, its points with minimal gaps, and the ends of the parts along
    // which the gap changes linearly, as above a flat face. The points between these need no
    // contacts, since the others keep them from penetrating too. As contacts they would share the
    // loads. Beyond the end of a face, their normals would be those of an edge, on which a sliding
    // capsule would catch.
    void find_on_segment(const std::vector<double>& gaps, double step)
    {
        const int last = core_.samples - 1;
        const auto is_linear = [&](int i) {
            return i > 0 && i < last &&
                   std::abs(gaps[i - 1] - 2 * gaps[i] + gaps[i + 1]) <= deviation();
        };
        for (int i = 0; i <= last; ++i) {
            if (is_linear(i)) continue;
            const bool begins = is_linear(i + 1), ends = is_linear(i - 1);
            if (begins && i > 0) add(end_of_line(i, -1, gaps, step));
            if (ends && i < last) add(end_of_line(i, 1, gaps, step));
            // If two samples are equal, only the second one is the least.
            const bool is_least =
                (i == 0 || gaps[i] <= gaps[i - 1]) && (i == last || gaps[i] < gaps[i + 1]);
            const bool is_end = i == 0 || i == last || begins || ends;
            if (i == 0 || i == last) add(i * step);
            if (is_least && !refine(i, step, gaps[i]) && !is_end) add(i * step);
        }
    }

    // A gap that differs from a linear one by at most this counts as linear [m].
    double deviation() const { return least_improvement * core_.meters(); }

    // The point beyond sample i where the gap stops being linear.
    // @param side  1 if the linear part ends at the sample, -1 if it begins there
    double end_of_line(int i, int side, const std::vector<double>& gaps, double step) const
    {
        constexpr int bisections = 30; // shorten the interval to 1e-9 of its length
        const double slope = (gaps[i] - gaps[i - side]) / step;
        double on = 0, off = step; // distances from the sample
        for (int k = 0; k < bisections; ++k) {
            const double middle = (on + off) / 2;
            const double line = gaps[i] + slope * middle;
            const bool is_on = std::abs(gap(i * step + side * middle) - line) <= deviation();
            (is_on ? on : off) = middle;
        }
        // The gap grows by δ²/2r at the distance δ beyond the end, r: radius. This is the largest δ
        // that counts as linear. If δ is not subtracted, the point may lie beyond the face.
        const double beyond = std::sqrt(2 * core_.radius * deviation());
        return i * step + side * std::max(on - beyond, 0.0);
    }

    // Adds points of a circle as contacts: eight fixed points if the other shape is equally near
    // everywhere, otherwise the point nearest to the other shape and the three points at
    // quarters of a turn from it. Fixed points of a torus that rolls would hit the other shape one
    // after the other like the spokes of a wheel without a rim.
    // @return the parameter of the nearest point
    double add_around_lowest(const std::vector<double>& gaps, double step)
    {
        // Gaps count as equal if they differ by less than this fraction of the core's length.
        constexpr double flat = 1e-6;
        const auto [low, high] = std::minmax_element(gaps.begin(), gaps.end());
        const bool is_flat = *high - *low < flat * core_.meters();
        const int i = is_flat ? 0 : static_cast<int>(low - gaps.begin()), points = is_flat ? 8 : 4;
        const auto gap_at = [&](double t) { return gap(t); };
        const double lowest = is_flat ? 0 : minimum(gap_at, (i - 1) * step, (i + 1) * step);
        for (int k = 0; k < points; ++k)
            if (const double s = lowest + core_.length / points * k; gap(s) < reach_) add(s);
        return lowest;
    }

    // Adds the place of the least gap near sample i, if it is less than at the sample.
    // @return whether it is
    bool refine(int i, double step, double at_sample)
    {
        const double low = core_.is_closed ? (i - 1) * step : std::max(i - 1, 0) * step;
        const double high =
            core_.is_closed ? (i + 1) * step : std::min((i + 1) * step, core_.length);
        const double s = minimum([&](double t) { return gap(t); }, low, high);
        const bool is_less = gap(s) < at_sample - least_improvement * core_.meters();
        if (is_less) add(s);
        return is_less;
    }

    void add(double s)
    {
        const Vector3d p = core_.at(s);
        const auto [gap, n] = field_.ball(p, core_.radius);
        if (gap < reach_) contacts_.push_back({pose2_ * (p - core_.radius * n), pose2_.R * n, gap});
    }

    const Core& core_;
    const DistanceField& field_;
    const Pose& pose2_;
    double reach_;
    std::vector<Contact>& contacts_;
};

// The contacts of a ball on a torus, whose core is a circle. Three points on this circle are
// tested, 120° apart, one of them nearest to the ball, so that a ball over the hole rests on three
// points.
void find_ball_torus_contacts(const Sphere& sphere, const Vector3d& center, const Torus& torus,
                              const Pose& pose, double reach, std::vector<Contact>& contacts)
{
    const Vector3d c = pose.R.transpose() * (center - pose.X);
    const double away = std::hypot(c.x(), c.z());
    const double angle = away > 0 ? std::atan2(c.z(), c.x()) : 0;
    for (int i = 0; i < 3; ++i) {
        const double a = angle + i * 2 * std::numbers::pi / 3;
        const Vector3d d = c - torus.radius * Vector3d(std::cos(a), 0, std::sin(a));
        const double distance = d.norm(), gap = distance - torus.tube - sphere.radius;
        if (gap >= reach) continue;
        const Vector3d n =
            pose.R * (distance > 0 ? Vector3d(d / distance) : Vector3d::UnitY().eval());
        contacts.push_back({center - (sphere.radius + gap / 2) * n, n, gap});
    }
}

// The contacts of a ball on a mesh: one for each local minimum of the distance from the center to
// the surface, so both walls of a corner are found. If the center is inside the mesh, there is only
// the contact of `DistanceField::ball`.
void find_ball_mesh_contacts(const Core& core, const SolidMesh& mesh, const DistanceField& field,
                             const Pose& pose2, double reach, std::vector<Contact>& contacts)
{
    const Vector3d c = core.at(0);
    const auto add = [&](const SurfaceDistance& ball) {
        const auto& [gap, n] = ball;
        if (gap < reach) contacts.push_back({pose2 * (c - core.radius * n), pose2.R * n, gap});
    };
    if (field.at_least(c) <= 0 && field.distance(c) <= 0) return add(field.ball(c, core.radius));
    std::vector<Vector3d> known;
    for (const TriangleTree::Found& found : mesh.triangles().local_minima(c, core.radius + reach)) {
        const Vector3d d = (found.point - c).normalized();
        constexpr double alike = 0.9; // cosine of 26°: a smaller angle means the same contact
        const bool is_new = std::all_of(known.begin(), known.end(),
                                        [&](const Vector3d& k) { return k.dot(d) < alike; });
        if (!is_new || known.size() >= most_contacts) continue;
        known.push_back(d);
        add(field.ball_towards(c, core.radius, found.point));
    }
}

} // namespace

void find_core_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                        const Pose& pose2, double reach, Counters& counters,
                        std::vector<Contact>& contacts)
{
    const Sphere* sphere = std::get_if<Sphere>(&shape1);
    const Torus* ring = std::get_if<Torus>(&shape2);
    if (sphere && ring)
        return find_ball_torus_contacts(*sphere, pose1.X, *ring, pose2, reach, contacts);

    const Matrix3d to_2 = pose2.R.transpose();
    const Pose pose{to_2 * pose1.R, to_2 * (pose1.X - pose2.X)};
    const DistanceField field(shape2, counters);
    const Core core = std::visit(CoreOf{pose}, shape1);
    const Mesh* mesh = std::get_if<Mesh>(&shape2);
    if (mesh && sphere)
        return find_ball_mesh_contacts(core, *mesh->solid, field, pose2, reach, contacts);
    const std::size_t first = contacts.size();
    AlongCore(core, field, pose2, reach, contacts).find();
    if (!mesh || mesh->solid->is_convex()) return;
    std::vector<Contact> points;
    find_point_contacts(shape1, pose1, *mesh->solid, pose2, reach, counters, points);
    constexpr double all = 1; // `share`: core contacts lie on shape 1, one whole gap from the mesh
    remove_points_ahead(points, shape1, pose1, std::span(contacts).subspan(first), all);
    contacts.insert(contacts.end(), points.begin(), points.end());
    reduce_contacts(contacts, first, reach);
}

} // namespace rigor
