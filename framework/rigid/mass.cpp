// SPDX-License-Identifier: MIT
#include "rigid/mass.hpp"

#include "formulas/inertia.hpp"
#include "geometry/pose.hpp"
#include "rigid/non_finite.hpp"

#include <cmath>

namespace rigor {

namespace {

MassProperties part_mass_properties(const Part& part)
{
    MassProperties properties;
    if (const Sphere* sphere = std::get_if<Sphere>(&part.shape))
        properties = solid_sphere(part.density, sphere->radius);
    if (const Box* box = std::get_if<Box>(&part.shape))
        properties = solid_box(part.density, box->size);

    if (!part.orientation.v.isZero(0) && !is_isotropic(properties.inertia))
        properties.inertia = world_inertia(rotation_matrix(part.orientation), properties.inertia);
    properties.center_of_mass += part.position;
    return properties;
}

} // namespace

MassProperties mass_properties(const std::vector<Part>& parts)
{
    if (parts.empty()) return {};
    MassProperties total = part_mass_properties(parts.front());
    for (std::size_t i = 1; i < parts.size(); ++i)
        total = combine(total, part_mass_properties(parts[i]));
    return total;
}

bool is_isotropic(const Matrix3d& inertia)
{
    const double i = inertia.trace() / 3;
    const double tolerance = 64 * std::numeric_limits<double>::epsilon() * std::abs(i);
    return ((inertia - i * Matrix3d::Identity()).array().abs() <= tolerance).all();
}

BodyInertia inverse_mass_properties(double mass, const Matrix3d& inertia)
{
    BodyInertia inverse;
    inverse.inverse_mass = 1 / mass;
    if (is_isotropic(inertia)) {
        const double i = inertia.trace() / 3;
        inverse.inverse_inertia = (i > 0 ? 1 / i : 0.0) * Matrix3d::Identity();
        return inverse;
    }
    const PrincipalAxes axes = principal_axes(inertia);
    const Matrix3d& Q = axes.rotation;
    inverse.inverse_inertia = Q * invert_moments(axes.moments).asDiagonal() * Q.transpose();
    return inverse;
}

Vector3d set_mass_from_parts(RigidBody& body)
{
    if (body.is_static) {
        set_mass(body, 0, Matrix3d::Zero());
        return Vector3d::Zero();
    }
    const MassProperties properties = mass_properties(body.parts);
    if (!properties.center_of_mass.allFinite())
        throw NonFiniteState(body.name, "center of mass", 0);
    for (Part& part : body.parts)
        part.position -= properties.center_of_mass;
    set_mass(body, properties.mass, properties.inertia);
    return properties.center_of_mass;
}

void set_mass(RigidBody& body, double mass, const Matrix3d& inertia)
{
    if (body.is_static) {
        body.mass = 0;
        body.inertia.setZero();
        body.inverse = {};
        body.is_isotropic = false;
        return;
    }
    body.mass = mass;
    body.inertia = inertia;
    if (!std::isfinite(mass)) throw NonFiniteState(body.name, "mass", 0);
    if (!inertia.allFinite()) throw NonFiniteState(body.name, "inertia", 0);
    body.is_isotropic = is_isotropic(inertia);
    body.inverse = inverse_mass_properties(mass, inertia);
    if (!std::isfinite(body.inverse.inverse_mass))
        throw NonFiniteState(body.name, "inverse mass", 0);
    if (!body.inverse.inverse_inertia.allFinite())
        throw NonFiniteState(body.name, "inverse inertia", 0);
}

} // namespace rigor
