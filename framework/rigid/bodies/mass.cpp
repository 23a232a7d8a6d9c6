// SPDX-License-Identifier: MIT
// Mass properties of a body from its parts. Those of each part come from a closed form or from a
// formula of topic `inertia`. They are rotated and moved with the part, and combined over all
// parts. Then the principal axes give the inverse inertia and the axis of symmetry.
#include "rigid/bodies/mass.hpp"

#include "formulas/inertia.hpp"
#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/bodies/non_finite.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace rigor {

namespace {

// Mass properties of half a ball; the inertia is about the center of mass of this half. Its flat
// side is perpendicular to y, at y = direction · flat_side. Its round side points to +y if
// `direction` is 1, and to -y if it is -1.
MassProperties half_ball(double density, double radius, double direction, double flat_side)
{
    const double m = density * 2.0 / 3 * std::numbers::pi * radius * radius * radius;
    const double across = 83.0 / 320 * m * radius * radius, along = 0.4 * m * radius * radius;
    const Vector3d center(0, direction * (flat_side + 0.375 * radius), 0);
    return {m, center, Vector3d(across, along, across).asDiagonal()};
}

struct MassOf {
    double density;

    MassProperties operator()(const Sphere& s) const { return solid_sphere(density, s.radius); }
    MassProperties operator()(const Capsule& c) const
    {
        const MassProperties ends = combine(half_ball(density, c.radius, 1, c.height / 2),
                                            half_ball(density, c.radius, -1, c.height / 2));
        return combine(solid_cylinder(density, c.radius, c.height), ends);
    }
    MassProperties operator()(const Torus& t) const
    {
        // M = ρ 2π² R a²,  Iyy = M (R² + ¾ a²),  Ixx = Izz = M (½ R² + ⅝ a²)
        const double R2 = t.radius * t.radius, a2 = t.tube * t.tube;
        const double M = density * volume(t);
        const double across = M * (R2 / 2 + 0.625 * a2);
        return {M, Vector3d::Zero(), Vector3d(across, M * (R2 + 0.75 * a2), across).asDiagonal()};
    }
    MassProperties operator()(const Box& b) const { return solid_box(density, b.size); }
    MassProperties operator()(const Cylinder& c) const
    {
        return solid_cylinder(density, c.radius, c.height);
    }
    MassProperties operator()(const Cone& c) const
    {
        // M = ρ π/3 r² h,  Iyy = 3/10 M r²,  Ixx = Izz = 3/80 M (4 r² + h²)
        const double r2 = c.radius * c.radius, h2 = c.height * c.height;
        const double M = density * volume(c);
        const double across = 3.0 / 80 * M * (4 * r2 + h2);
        return {M, Vector3d::Zero(), Vector3d(across, 0.3 * M * r2, across).asDiagonal()};
    }
    MassProperties operator()(const Ellipsoid& e) const
    {
        return solid_ellipsoid(density, e.radii);
    }
    MassProperties operator()(const Mesh& m) const
    {
        return mesh_mass_properties(m.solid->mesh(), density);
    }
    MassProperties operator()(const Plane&) const { return {}; }
};

MassProperties part_mass_properties(const Part& part)
{
    MassProperties properties = std::visit(MassOf{part.density}, part.shape);
    if (!part.orientation.v.isZero(0)) {
        const Matrix3d R = rotation_matrix(part.orientation);
        if (!is_isotropic(properties.inertia))
            properties.inertia = world_inertia(R, properties.inertia);
        properties.center_of_mass = R * properties.center_of_mass;
    }
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

namespace {

// The symmetry axis of a body of revolution: the principal axis whose moment differs from the other
// two, if those two are equal up to rounding. Zero for any other body.
Vector3d symmetry_axis_of(const PrincipalAxes& axes)
{
    const Vector3d& m = axes.moments; // ascending
    const double tolerance = 64 * std::numeric_limits<double>::epsilon() * m.z();
    if (m.y() - m.x() <= tolerance) return axes.rotation.col(2);
    if (m.z() - m.y() <= tolerance) return axes.rotation.col(0);
    return Vector3d::Zero();
}

// I_body⁻¹ = Q diag(1/m) Qᵀ (Q: principal axes as columns, m: principal moments), by the formulas
// `principal_axes` and `invert_moments`; the inverse of a moment 0 is 0. For an isotropic inertia
// i δ (i: a number, δ: identity), no formula is called: the inverse is δ/i, or 0 if i = 0.
void invert_inertia(RigidBody& body)
{
    body.is_isotropic = is_isotropic(body.inertia);
    body.symmetry_axis.setZero();
    if (body.is_isotropic) {
        const double i = body.inertia.trace() / 3;
        body.principal_axes.setIdentity();
        body.inverse_moments.setConstant(i > 0 ? 1 / i : 0.0);
        body.inverse.inverse_inertia = (i > 0 ? 1 / i : 0.0) * Matrix3d::Identity();
        return;
    }
    const PrincipalAxes axes = principal_axes(body.inertia);
    const Matrix3d& Q = axes.rotation;
    body.principal_axes = Q;
    body.inverse_moments = invert_moments(axes.moments);
    body.inverse.inverse_inertia = Q * body.inverse_moments.asDiagonal() * Q.transpose();
    body.symmetry_axis = symmetry_axis_of(axes);
}

} // namespace

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
        body.principal_axes.setIdentity();
        body.inverse_moments.setZero();
        body.is_isotropic = false;
        body.symmetry_axis.setZero();
        return;
    }
    body.mass = mass;
    body.inertia = inertia;
    if (!std::isfinite(mass)) throw NonFiniteState(body.name, "mass", 0);
    if (!inertia.allFinite()) throw NonFiniteState(body.name, "inertia", 0);
    body.inverse.inverse_mass = 1 / mass;
    invert_inertia(body);
    if (!std::isfinite(body.inverse.inverse_mass))
        throw NonFiniteState(body.name, "inverse mass", 0);
    if (!body.inverse.inverse_inertia.allFinite())
        throw NonFiniteState(body.name, "inverse inertia", 0);
}

void let_turn_about(RigidBody& body, const Vector3d& axis)
{
    if (body.is_static) return;
    const Vector3d a = axis.isZero(0) ? axis : axis.normalized();
    body.only_axis = body.symmetry_axis = a;
    body.is_isotropic = false;
    body.inverse.inverse_inertia.setZero();
    // I_body⁻¹ = a aᵀ/(aᵀ I a)
    if (const double i = a.dot(body.inertia * a); i > 0)
        body.inverse.inverse_inertia = a * a.transpose() / i;
}

Vector3d own_angular_momentum(const RigidBody& body, const RigidState& state)
{
    if (!body.only_axis) return state.angular_momentum;
    // L = R I_body ω,  ω = I_body⁻¹ Rᵀ L
    const Matrix3d R = rotation_matrix(state.orientation);
    return R * (body.inertia *
                (body.inverse.inverse_inertia * (R.transpose() * state.angular_momentum)));
}

} // namespace rigor
