// SPDX-License-Identifier: MIT
#include "render/picture.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {
namespace {

float linear(double encoded)
{
    const double c = std::clamp(encoded, 0.0, 1.0);
    return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
}

/// A matrix whose columns are two vectors of length `radius` perpendicular to `direction`, and
/// `direction` itself.
Matrix3f along(const Vector3f& direction, float radius)
{
    const Vector3f z = direction.normalized();
    const Vector3f other = std::abs(z.y()) < 0.9F ? Vector3f::UnitY() : Vector3f::UnitX();
    const Vector3f x = other.cross(z).normalized();
    Matrix3f axes;
    axes.col(0) = radius * x;
    axes.col(1) = radius * z.cross(x);
    axes.col(2) = direction;
    return axes;
}

} // namespace

Vector4f linear_color(double red, double green, double blue, double opacity)
{
    return {linear(red), linear(green), linear(blue), static_cast<float>(opacity)};
}

void add_rod(Picture& picture, const Vector3f& from, const Vector3f& to, float radius,
             const Vector4f& color)
{
    const Vector3f direction = to - from;
    // A rod without a length, or with a NaN in its ends, is not drawn.
    if (!(direction.norm() > 1e-6F * radius)) return;
    picture.rods.push_back({along(direction, radius), from, color});
}

void add_arrow(Picture& picture, const Vector3f& from, const Vector3f& to, float radius,
               const Vector4f& color)
{
    const Vector3f direction = to - from;
    const float length = direction.norm();
    if (!(length > 0.5F * radius)) return; // too short to be seen
    const float head = std::min(6 * radius, length);
    const Vector3f neck = to - direction * (head / length);
    add_rod(picture, from, neck, radius, color);
    picture.cones.push_back({along(to - neck, std::min(2.4F * radius, head / 2)), neck, color});
}

} // namespace rigor
