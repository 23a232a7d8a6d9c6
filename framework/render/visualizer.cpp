// SPDX-License-Identifier: MIT
// Makes pictures from the states of a scene. What stays the same in a run, such as colors,
// surfaces, camera and ground, is made once; each frame then places the bodies, the deformable
// solids and the overlays. A comparison also draws, as ghosts, the bodies and solids of a second
// run that lie apart from those of the first.
#include "render/visualizer.hpp"

#include "errors/input_error.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "render/colors.hpp"
#include "render/overlays.hpp"
#include "render/shape_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

std::size_t moving_count(const std::vector<DrawnBody>& bodies)
{
    return static_cast<std::size_t>(std::count_if(
        bodies.begin(), bodies.end(), [](const DrawnBody& body) { return !body.is_static; }));
}

/// Whether two boxes have faces in one plane, with equal outward normals.
/// @param axis  the axis of the second box that is normal to its face
bool share_plane(const Part& part1, const Vector3d& size1, const Part& part2, const Vector3d& size2,
                 int axis)
{
    const Matrix3d R1 = rotation_matrix(part1.orientation), R2 = rotation_matrix(part2.orientation);
    constexpr double parallel_rounding = 1e-9; // largest 1 - |cosine| of two parallel normals
    constexpr double same_plane = 1e-6; // largest distance of the planes / size of the second box
    const Vector3d n = R2.col(axis);
    const double apart = n.dot(part2.position - part1.position);
    for (int i = 0; i < 3; ++i) {
        if (std::abs(std::abs(n.dot(R1.col(i))) - 1) > parallel_rounding) continue;
        const double thicker = (size2[axis] - size1[i]) / 2;
        const double nearest = std::min(std::abs(thicker + apart), std::abs(thicker - apart));
        if (nearest < same_plane * size2[axis]) return true;
    }
    return false;
}

/// If two boxes of a body have faces in one plane, the later box is drawn a little thinner.
/// Otherwise the visible face, and its edges, would change from pixel to pixel.
void part_planes(std::vector<Part>& parts)
{
    // The box loses this fraction of its size. The value was chosen by trial, and is too small to
    // be seen.
    constexpr double thinner = 4e-4;
    for (std::size_t j = 0; j < parts.size(); ++j)
        for (std::size_t i = 0; i < j; ++i) {
            const auto* earlier = std::get_if<Box>(&parts[i].shape);
            auto* later = std::get_if<Box>(&parts[j].shape);
            if (!earlier || !later) continue;
            for (int axis = 0; axis < 3; ++axis)
                if (share_plane(parts[i], earlier->size, parts[j], later->size, axis))
                    later->size[axis] *= 1 - thinner;
        }
}

} // namespace

Visualizer::Visualizer(const Scene& scene, const std::vector<RecordedBody>& bodies,
                       const Overlays& overlays)
    : scene_(scene), overlays_(overlays)
{
    if (bodies.size() != scene.bodies.size())
        throw InputError(fmt::format("{}: expected a record of {} bodies, found {}", scene.name,
                                     scene.bodies.size(), bodies.size()));
    bool has_plane = false;
    double lowest = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        add_body(scene.bodies[i], bodies[i]);
        const DrawnBody& body = bodies_.back();
        has_plane = has_plane || std::any_of(body.parts.begin(), body.parts.end(), is_plane);
        if (!body.is_static)
            lowest = std::min(lowest, scene.bodies[i].position.y() - 1.5 * body.radius);
    }
    solids_ = SolidVisualizer(scene.solids, overlays, moving_count(bodies_));
    for (std::size_t i = 0; i < scene.solids.size(); ++i)
        lowest = std::min(lowest, scene.solids[i].position.y() - 1.5 * solids_.radius(i));
    start_.eye = scene.camera.position.cast<float>();
    start_.target = scene.camera.target.cast<float>();
    start_.field_of_view = static_cast<float>(scene.camera.field_of_view);
    const double angle = scene.camera.field_of_view * std::numbers::pi / 180;
    const double height =
        2 * (scene.camera.position - scene.camera.target).norm() * std::tan(angle / 2);
    thickness_ = static_cast<float>(0.0045 * height);
    start_.grid_spacing = static_cast<float>(std::pow(10, std::floor(std::log10(height / 2.5))));
    if (!has_plane && overlays.grid)
        start_.grounds.push_back(
            {Matrix3f::Identity(), Vector3f(0, static_cast<float>(lowest), 0), false, true});
}

void Visualizer::add_body(const BodyDescription& described, const RecordedBody& recorded)
{
    DrawnBody body;
    body.name = described.name;
    body.is_static = recorded.is_static;
    body.parts = described.parts;
    body.center_of_mass = recorded.center_of_mass;
    part_planes(body.parts);
    for (Part& part : body.parts) {
        part.position -= recorded.center_of_mass;
        if (!is_plane(part)) body.radius = std::max(body.radius, bounding_radius(part));
        body.models.push_back(model_of(part.shape));
    }
    body.color = colors::resting;
    if (!body.is_static) {
        body.color = colors::palette(moving_count(bodies_));
        body.mass = recorded.mass;
        body.inverse_inertia = recorded.inertia.completeOrthogonalDecomposition().pseudoInverse();
        body.mean_inertia = recorded.inertia.trace() / 3;
    }
    if (described.color)
        body.color = linear_color(described.color->x(), described.color->y(), described.color->z());
    bodies_.push_back(std::move(body));
}

namespace {

// The key of a surface: the kind and the sizes of a round shape, or the mesh. A box, ball,
// ellipsoid or plane has no key.
struct SurfaceKeyOf {
    using Key = std::optional<SurfaceKey>;
    Key operator()(const Capsule& c) const { return SurfaceKey(nullptr, {1, c.radius, c.height}); }
    Key operator()(const Torus& t) const { return SurfaceKey(nullptr, {2, t.radius, t.tube}); }
    Key operator()(const Cylinder& c) const { return SurfaceKey(nullptr, {3, c.radius, c.height}); }
    Key operator()(const Cone& c) const { return SurfaceKey(nullptr, {4, c.radius, c.height}); }
    Key operator()(const Mesh& m) const { return SurfaceKey(m.solid.get(), {0, 0, 0}); }
    template <class Other> Key operator()(const Other&) const { return {}; }
};

} // namespace

int Visualizer::model_of(const Shape& shape)
{
    const auto key = std::visit(SurfaceKeyOf{}, shape);
    if (!key) return -1;
    const auto [known, is_new] =
        model_numbers_.try_emplace(*key, static_cast<int>(start_.models.size()));
    if (is_new) {
        start_.models.push_back({std::make_shared<Surface>(surface_of(shape)), {}});
        start_.ghost_models.push_back({start_.models.back().surface, {}});
    }
    return known->second;
}

void Visualizer::draw_body(Picture& picture, const DrawnBody& body, const RigidState& state,
                           bool ghost) const
{
    if (!in_sight(state.position)) return;
    const Pose frame = pose_of(state);
    const Vector4f& color = ghost ? colors::ghostly : body.color;
    for (std::size_t i = 0; i < body.parts.size(); ++i) {
        const Part& part = body.parts[i];
        const Pose pose = part_pose(frame, part);
        const Matrix3f axes = pose.R.cast<float>();
        const Vector3f position = pose.X.cast<float>();
        auto& balls = ghost ? picture.ghost_balls : picture.balls;
        if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
            balls.push_back({axes * static_cast<float>(sphere->radius), position, color});
        } else if (const auto* ellipsoid = std::get_if<Ellipsoid>(&part.shape)) {
            balls.push_back({axes * ellipsoid->radii.cast<float>().asDiagonal(), position, color});
        } else if (const auto* box = std::get_if<Box>(&part.shape)) {
            (ghost ? picture.ghost_boxes : picture.boxes)
                .push_back({axes * (box->size / 2).cast<float>().asDiagonal(), position, color});
        } else if (const int number = body.models[i]; number >= 0) {
            Model& model = (ghost ? picture.ghost_models : picture.models)[number];
            model.instances.push_back({axes, axes * model.surface->center + position, color});
        } else if (!ghost) {
            picture.grounds.push_back({axes, position, true, overlays_.grid});
        }
    }
}

Picture Visualizer::empty_picture(const Frame& frame) const
{
    if (frame.bodies.size() != bodies_.size())
        throw InputError(fmt::format("{}: step {}: expected {} bodies, found {}", scene_.name,
                                     frame.step, bodies_.size(), frame.bodies.size()));
    if (frame.solids.size() != solids_.count())
        throw InputError(fmt::format("{}: step {}: expected {} solids, found {}", scene_.name,
                                     frame.step, solids_.count(), frame.solids.size()));
    return start_;
}

Picture Visualizer::picture(const Frame& frame) const
{
    Picture picture = empty_picture(frame);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        draw_body(picture, bodies_[i], frame.bodies[i], false);
        add_arrows(picture, bodies_[i], frame.bodies[i], overlays_, thickness_);
    }
    if (!frame.solids.empty()) solids_.draw(picture, frame);
    add_springs(picture, frame, bodies_, scene_.springs, thickness_);
    if (overlays_.contacts) add_contacts(picture, frame, bodies_, thickness_);
    if (overlays_.axes || overlays_.angular_velocity || overlays_.angular_momentum ||
        overlays_.contacts || overlays_.labels)
        add_title(picture, scene_.name, frame.time);
    add_legend(picture, overlays_);
    if (overlays_.labels) add_names(picture, frame, bodies_, scene_.solids, thickness_);
    return picture;
}

namespace {

bool lies_apart(const DrawnBody& body, const RigidState& state1, const RigidState& state2)
{
    const double moved = (state1.position - state2.position).norm();
    const Matrix3d turned =
        rotation_matrix(state1.orientation) - rotation_matrix(state2.orientation);
    return moved + turned.norm() * body.radius > visible_distance * body.radius;
}

} // namespace

Picture Visualizer::comparison(const Frame& frame, const Frame& other, const std::string& name,
                               const std::string& other_name) const
{
    empty_picture(other); // only checks the numbers of bodies and solids of `other`
    Picture result = picture(frame);
    std::size_t apart = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const RigidState &state1 = frame.bodies[i], &state2 = other.bodies[i];
        if (!lies_apart(bodies_[i], state1, state2)) continue;
        ++apart;
        draw_body(result, bodies_[i], state2, true);
        if (in_sight(state1.position) && in_sight(state2.position))
            add_rod(result, state1.position.cast<float>(), state2.position.cast<float>(),
                    0.8F * thickness_, colors::difference);
    }
    for (std::size_t i = 0; i < frame.solids.size(); ++i)
        if (solids_.lies_apart(i, frame.solids[i], other.solids[i])) {
            ++apart;
            solids_.draw_ghost(result, other.solids[i]);
        }
    if (result.texts.empty()) add_title(result, scene_.name, frame.time);
    const auto line = [&](const std::string& text, const Vector4f& color) {
        result.texts.push_back({text, colors::opaque(color), false, {}});
    };
    line(fmt::format("■ {}", name), colors::dark);
    line(fmt::format("□ {}", other_name), colors::ghostly);
    line(fmt::format("{} of {} bodies lie apart", apart, bodies_.size() + frame.solids.size()),
         colors::difference);
    return result;
}

} // namespace rigor
