// SPDX-License-Identifier: MIT
// The matrices of the camera and of the sun. The camera has a perspective projection and looks at
// the picture's target. The sun stands behind the left shoulder of the camera and has a parallel
// projection onto the shadow map, which fits a ball around the bodies near the target that cast
// shadows.
#include "render/gl/light.hpp"

#include "render/gl/layout.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {
namespace {

using Eigen::Matrix4f;

/// Unit axes as rows: right, up and back for an observer who looks along `forward`.
Matrix3f looking_along(const Vector3f& forward)
{
    const Vector3f back = -forward.normalized();
    const Vector3f up = std::abs(back.y()) < 0.999F ? Vector3f::UnitY() : Vector3f::UnitZ();
    Matrix3f rows;
    rows.row(0) = up.cross(back).normalized();
    rows.row(1) = back.cross(rows.row(0).transpose());
    rows.row(2) = back;
    return rows;
}

Vector3f forward_of(const Picture& picture)
{
    const Vector3f forward = picture.target - picture.eye;
    return forward.norm() > 1e-6F ? forward : -Vector3f::UnitZ().eval();
}

/// The perspective projection. Its y points down the screen, so that rows are read from the top, as
/// image files need them.
/// @param strip  share of the width, at the right border, in which the scene is not drawn
Matrix4f to_clip(const Picture& picture, float aspect, float strip)
{
    const float angle = std::clamp(picture.field_of_view, 1.0F, 170.0F);
    const float scale = 1 / std::tan(angle * std::numbers::pi_v<float> / 360);
    const float distance = camera_distance(picture);
    const float near = 0.02F * distance, far = 60 * distance;
    Matrix4f perspective = Matrix4f::Zero();
    perspective(0, 0) = scale / aspect;
    perspective(1, 1) = -scale;
    perspective(2, 2) = (far + near) / (near - far);
    perspective(2, 3) = 2 * far * near / (near - far);
    perspective(3, 2) = -1;
    const Matrix3f rows = looking_along(forward_of(picture));
    Matrix4f camera = Matrix4f::Identity();
    camera.topLeftCorner<3, 3>() = rows;
    camera.topRightCorner<3, 1>() = -(rows * picture.eye);
    Matrix4f smaller = Matrix4f::Identity();
    smaller(0, 0) = smaller(1, 1) = 1 - strip;
    smaller(0, 3) = -strip;
    return smaller * perspective * camera;
}

/// The direction to the sun: over the left shoulder of the camera, so that what the camera sees is
/// lit.
Vector3f towards_sun(const Picture& picture)
{
    const Matrix3f rows = looking_along(forward_of(picture));
    Vector3f level = rows.row(2).transpose() - 0.9F * rows.row(0).transpose();
    level.y() = 0;
    if (level.norm() < 1e-3F) level = Vector3f::UnitX();
    return (0.85F * level.normalized() + 1.15F * Vector3f::UnitY()).normalized();
}

struct Ball {
    Vector3f center = Vector3f::Zero();
    float radius = 1;
};

/// A ball around all bodies near the camera's target that cast shadows.
Ball around_casters(const Picture& picture)
{
    const float reach = 6 * camera_distance(picture);
    const Vector3f nearest = picture.target - Vector3f::Constant(reach),
                   farthest = picture.target + Vector3f::Constant(reach);
    Vector3f low = Vector3f::Constant(INFINITY), high = Vector3f::Constant(-INFINITY);
    const auto include = [&](const Vector3f& position, const Vector3f& half) {
        if (!((position - picture.target).norm() < reach)) return;
        low = low.cwiseMin((position - half).cwiseMax(nearest));
        high = high.cwiseMax((position + half).cwiseMin(farthest));
    };
    for (const auto* casters : {&picture.boxes, &picture.balls})
        for (const Instance& caster : *casters)
            include(caster.position, caster.axes.cwiseAbs().rowwise().sum());
    for (const Model& model : picture.models)
        for (const Instance& caster : model.instances)
            include(caster.position, Vector3f::Constant(model.surface->radius));
    for (const DeformedVertex& corner : picture.deformed)
        include(corner.position, Vector3f::Zero());
    if (!(low.x() <= high.x())) return {picture.target, 1};
    // The radius grows in steps, so that the edges of shadows do not crawl from frame to frame.
    const float radius = std::max((high - low).norm() / 2, 1e-3F * reach);
    return {(low + high) / 2, std::exp2(std::ceil(4 * std::log2(radius)) / 4)};
}

} // namespace

float camera_distance(const Picture& picture)
{
    return forward_of(picture).norm();
}

View view_of(const Picture& picture, int width, int height)
{
    View view{};
    const int strip = picture.color_scale ? color_bar_strip(width, height) : 0;
    const Matrix4f clip = to_clip(picture, static_cast<float>(width) / static_cast<float>(height),
                                  static_cast<float>(strip) / static_cast<float>(width));
    std::copy_n(clip.data(), 16, view.to_clip);

    const Vector3f sun = towards_sun(picture);
    const Ball casters = around_casters(picture);
    const float texel = 2 * casters.radius / shadow_side;
    const Matrix3f rows = looking_along(-sun);
    Vector3f center = rows * casters.center;
    center.head<2>() = (center.head<2>() / texel).array().floor() * texel;
    Matrix4f light = Matrix4f::Identity();
    light.topLeftCorner<3, 3>() = rows / (2 * casters.radius);
    light.topRightCorner<3, 1>() = Vector3f::Constant(0.5F) - center / (2 * casters.radius);
    light.row(2) *= -1; // depth grows away from the sun
    light(2, 3) += 1;
    std::copy_n(light.data(), 16, view.to_light);

    std::copy_n(picture.eye.data(), 3, view.eye);
    std::copy_n(sun.data(), 3, view.light);
    view.light[3] = 1.5F * texel;
    view.screen[0] = static_cast<float>(width);
    view.screen[1] = static_cast<float>(height);
    view.screen[2] = 1.0F / shadow_side;
    return view;
}

} // namespace rigor
