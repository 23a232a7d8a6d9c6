// SPDX-License-Identifier: MIT
#include "render/stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rigor {
namespace {

constexpr double out_of_sight = 1e6; // a body farther out than this is not drawn [m]

/// Okabe and Ito (2008), "Color Universal Design": told apart by all common kinds of sight. A little
/// softer here, since large surfaces glare.
Vector4f palette(std::size_t index)
{
    static constexpr std::array<std::array<double, 3>, 7> colors = {{{0.16, 0.47, 0.71},
                                                                     {0.91, 0.55, 0.13},
                                                                     {0.13, 0.60, 0.49},
                                                                     {0.80, 0.34, 0.20},
                                                                     {0.46, 0.72, 0.88},
                                                                     {0.76, 0.50, 0.66},
                                                                     {0.91, 0.78, 0.31}}};
    const auto& c = colors[index % colors.size()];
    return linear_color(c[0], c[1], c[2]);
}

const Vector4f resting = linear_color(0.66, 0.68, 0.71); // static bodies
const Vector4f dark = linear_color(0.16, 0.20, 0.26);
const Vector4f red = linear_color(0.83, 0.20, 0.18), green = linear_color(0.15, 0.60, 0.25),
               blue = linear_color(0.13, 0.36, 0.80);
const Vector4f turning = linear_color(0.56, 0.20, 0.68);  // ω
const Vector4f momentum = linear_color(0.92, 0.52, 0.05); // L
const Vector4f impulse = linear_color(0.86, 0.10, 0.42);
const Vector4f ghostly = linear_color(0.42, 0.30, 0.62, 0.30);
const Vector4f difference = linear_color(0.86, 0.10, 0.42);

/// The rotation of a quaternion of any length; students may send one that is not unit.
Matrix3d rotation_of(const Quaternion& q)
{
    const double length = std::sqrt(q.s * q.s + q.v.squaredNorm());
    if (!(length > 1e-150) || !std::isfinite(length)) return Matrix3d::Identity();
    return Eigen::Quaterniond(q.s / length, q.v.x() / length, q.v.y() / length, q.v.z() / length)
        .toRotationMatrix();
}

double radius_of(const Shape& shape)
{
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
    if (const auto* box = std::get_if<Box>(&shape)) return box->size.norm() / 2;
    return 0;
}

/// Grows with `value` and stays below 1: a half at `half`.
double saturated(double value, double half)
{
    return value / (value + half);
}

} // namespace

Stage::Stage(const Scene& scene, const std::vector<RecordedBody>& bodies, const Overlays& overlays)
    : scene_(scene), overlays_(overlays)
{
    if (bodies.size() != scene.bodies.size())
        throw InputError(fmt::format("{}: expected a record of {} bodies, found {}", scene.name,
                                     scene.bodies.size(), bodies.size()));
    bool has_plane = false;
    std::size_t moving = 0;
    double lowest = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const BodyDescription& body = scene.bodies[i];
        Actor actor{body.name, bodies[i].is_static, {}, Matrix3d::Zero(), bodies[i].mass, 0, 0,
                    resting};
        for (const Part& part : body.parts) {
            has_plane = has_plane || std::holds_alternative<Plane>(part.shape);
            const Vector3d position = part.position - bodies[i].center_of_mass;
            actor.parts.push_back({part, position, rotation_of(part.orientation)});
            actor.radius = std::max(actor.radius, position.norm() + radius_of(part.shape));
        }
        if (!actor.is_static) {
            actor.color = palette(moving++);
            actor.inverse_inertia = bodies[i].inertia.inverse();
            actor.mean_inertia = bodies[i].inertia.trace() / 3;
            lowest = std::min(lowest, body.position.y() - 1.5 * actor.radius);
        }
        if (body.color)
            actor.color = linear_color(body.color->x(), body.color->y(), body.color->z());
        actors_.push_back(std::move(actor));
    }

    start_.eye = scene.camera.position.cast<float>();
    start_.target = scene.camera.target.cast<float>();
    start_.field_of_view = static_cast<float>(scene.camera.field_of_view);
    const double distance = (scene.camera.position - scene.camera.target).norm();
    const double height =
        2 * distance * std::tan(scene.camera.field_of_view * std::numbers::pi / 360);
    thickness_ = static_cast<float>(0.0045 * height);
    start_.grid_spacing = static_cast<float>(std::pow(10, std::floor(std::log10(height / 2.5))));
    if (!has_plane && overlays.grid)
        start_.grounds.push_back(
            {Matrix3f::Identity(), Vector3f(0, static_cast<float>(lowest), 0), false, true});
}

void Stage::add_body(Picture& picture, const Actor& actor, const RigidState& state,
                     bool ghost) const
{
    if (!(state.position.norm() < out_of_sight)) return;
    const Matrix3d R = rotation_of(state.orientation);
    for (const Placed& placed : actor.parts) {
        const Matrix3f axes = (R * placed.rotation).cast<float>();
        const Vector3f position = (R * placed.position + state.position).cast<float>();
        const Vector4f& color = ghost ? ghostly : actor.color;
        if (const auto* sphere = std::get_if<Sphere>(&placed.part.shape))
            (ghost ? picture.ghost_balls : picture.balls)
                .push_back({axes * static_cast<float>(sphere->radius), position, color});
        else if (const auto* box = std::get_if<Box>(&placed.part.shape))
            (ghost ? picture.ghost_boxes : picture.boxes)
                .push_back({axes * (box->size / 2).cast<float>().asDiagonal(), position, color});
        else if (!ghost)
            picture.grounds.push_back({axes, position, true, overlays_.grid});
    }
}

void Stage::add_arrows(Picture& picture, const Actor& actor, const RigidState& state) const
{
    if (actor.is_static || !(state.position.norm() < out_of_sight)) return;
    const Matrix3d R = rotation_of(state.orientation);
    const Vector3f center = state.position.cast<float>();
    const auto arrow = [&](const Vector3d& v, float thickness, const Vector4f& color) {
        add_arrow(picture, center, (state.position + v).cast<float>(), thickness * thickness_,
                  color);
    };
    if (overlays_.axes) {
        const std::array<Vector4f, 3> colors = {red, green, blue};
        for (int i = 0; i < 3; ++i)
            arrow(1.35 * actor.radius * R.col(i), 0.8F, colors[i]);
    }
    // Lengths saturate: a slow turn is seen and a fast one stays in the picture. L is measured as
    // the ω it would be for a body of the mean inertia, and is drawn thinner and longer, so that
    // both are seen where they are parallel.
    constexpr double half = 2; // [rad/s]
    const Vector3d& L = state.angular_momentum;
    const Vector3d w = R * (actor.inverse_inertia * (R.transpose() * L));
    if (overlays_.angular_velocity && w.norm() > 0)
        arrow(w.normalized() * actor.radius * (0.4 + 1.9 * saturated(w.norm(), half)), 1.25F,
              turning);
    if (overlays_.angular_momentum && L.norm() > 0)
        arrow(L.normalized() * actor.radius *
                  (0.6 + 2.3 * saturated(L.norm() / actor.mean_inertia, half)),
              0.8F, momentum);
}

void Stage::add_contacts(Picture& picture, const Frame& frame) const
{
    const float dot = 2.2F * thickness_;
    for (const ContactRecord& contact : frame.contacts) {
        if (!(contact.point.norm() < out_of_sight)) continue;
        const Vector3f point = contact.point.cast<float>();
        picture.dots.push_back({dot * Matrix3f::Identity(), point, dark});
        const auto count = static_cast<int>(actors_.size());
        if (contact.body1 < 0 || contact.body1 >= count) continue;
        const Actor& body = actors_[contact.body1];
        const double j = contact.impulse.norm();
        if (!(body.mass > 0) || !(j > 0)) continue;
        const double length = 60 * thickness_ * saturated(j / body.mass, 1.5); // at 1.5 m/s a half
        add_arrow(picture, point, (contact.point + contact.impulse / j * length).cast<float>(),
                  0.9F * thickness_, impulse);
    }
}

/// A spring is a coil: the same turns whatever its length.
void Stage::add_springs(Picture& picture, const Frame& frame) const
{
    constexpr int turns = 9, corners = 10 * turns;
    const auto end = [&](int body, const Vector3d& point) -> Vector3d {
        if (body < 0 || body >= static_cast<int>(frame.bodies.size())) return point;
        const RigidState& state = frame.bodies[body];
        return state.position + rotation_of(state.orientation) * point;
    };
    for (const Spring& spring : scene_.springs) {
        const Vector3d from = end(spring.body1, spring.point1),
                       to = end(spring.body2, spring.point2);
        const Vector3d way = to - from;
        if (!(way.norm() > 1e-9) || !(from.norm() < out_of_sight) || !(to.norm() < out_of_sight))
            continue;
        const Vector3d u = way.unitOrthogonal(), v = way.normalized().cross(u);
        Vector3d last = from;
        for (int i = 1; i <= corners; ++i) {
            const double t = static_cast<double>(i) / corners;
            const double wide = std::min(1.0, 8 * std::min(t, 1 - t)) * 4 * thickness_;
            const double angle = 2 * std::numbers::pi * turns * t;
            const Vector3d next =
                from + t * way + wide * (std::cos(angle) * u + std::sin(angle) * v);
            add_rod(picture, last.cast<float>(), next.cast<float>(), 0.6F * thickness_, dark);
            last = next;
        }
    }
}

bool Stage::shows_text() const
{
    return overlays_.axes || overlays_.angular_velocity || overlays_.angular_momentum ||
           overlays_.contacts || overlays_.labels;
}

void Stage::add_legend(Picture& picture, const Frame& frame) const
{
    if (!shows_text()) return;
    picture.texts.push_back(
        {fmt::format("{}   t = {:.3f} s", scene_.name, frame.time), dark, true, {}});
    const auto line = [&](const std::string& text, const Vector4f& color) {
        picture.texts.push_back({text, color, false, {}});
    };
    if (overlays_.axes) {
        line("→ x body axis", red);
        line("→ y body axis", green);
        line("→ z body axis", blue);
    }
    if (overlays_.angular_velocity) line("→ ω angular velocity", turning);
    if (overlays_.angular_momentum) line("→ L angular momentum", momentum);
    if (overlays_.contacts) {
        line("● contact", dark);
        line("→ impulse", impulse);
    }
    if (!overlays_.labels) return;
    for (std::size_t i = 0; i < actors_.size(); ++i) {
        const Vector3d& X = frame.bodies[i].position;
        if (actors_[i].radius == 0 || !(X.norm() < out_of_sight)) continue;
        const Vector3d above = X + 1.1 * actors_[i].radius * Vector3d::UnitY();
        picture.texts.push_back({actors_[i].name, dark, false, above.cast<float>()});
    }
}

Picture Stage::empty_picture(const Frame& frame) const
{
    if (frame.bodies.size() != actors_.size())
        throw InputError(fmt::format("{}: step {}: expected {} bodies, found {}", scene_.name,
                                     frame.step, actors_.size(), frame.bodies.size()));
    return start_;
}

Picture Stage::picture(const Frame& frame) const
{
    Picture picture = empty_picture(frame);
    for (std::size_t i = 0; i < actors_.size(); ++i) {
        add_body(picture, actors_[i], frame.bodies[i], false);
        add_arrows(picture, actors_[i], frame.bodies[i]);
    }
    if (overlays_.contacts) add_contacts(picture, frame);
    add_springs(picture, frame);
    add_legend(picture, frame);
    return picture;
}

Picture Stage::comparison(const Frame& frame, const Frame& other, const std::string& name,
                          const std::string& other_name) const
{
    empty_picture(other); // has the same bodies
    Picture result = picture(frame);
    std::size_t apart = 0;
    for (std::size_t i = 0; i < actors_.size(); ++i) {
        const RigidState &state1 = frame.bodies[i], &state2 = other.bodies[i];
        const double moved = (state1.position - state2.position).norm();
        const double turned =
            (rotation_of(state1.orientation) - rotation_of(state2.orientation)).norm();
        constexpr double seen = 0.004; // of the body's radius: less cannot be seen
        if (!(moved + turned * actors_[i].radius > seen * actors_[i].radius)) continue;
        ++apart;
        add_body(result, actors_[i], state2, true);
        if (moved < out_of_sight)
            add_rod(result, state1.position.cast<float>(), state2.position.cast<float>(),
                    0.8F * thickness_, difference);
    }
    if (!shows_text())
        result.texts.push_back(
            {fmt::format("{}   t = {:.3f} s", scene_.name, frame.time), dark, true, {}});
    result.texts.push_back({fmt::format("■ {}", name), dark, false, {}});
    result.texts.push_back({fmt::format("□ {}", other_name),
                            Vector4f(ghostly.x(), ghostly.y(), ghostly.z(), 1),
                            false,
                            {}});
    result.texts.push_back(
        {fmt::format("{} of {} bodies lie apart", apart, actors_.size()), difference, false, {}});
    return result;
}

} // namespace rigor
