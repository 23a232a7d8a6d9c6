// SPDX-License-Identifier: MIT
// The fields of the plain types, by name and in order. All code that sends, compares or prints a
// value, or checks it for NaN, uses these lists and skips a field that is missing in them. So the
// name of a new field must be added to the list for its struct. The lists are here; those of the
// structs for topic `validation` are in validation.hpp and under_test.hpp.
#pragma once

#include "formulas/types.hpp"

#include <string_view>

namespace rigor {

/// The list of the fields of T: `Fields<Body>::each(body, visit)` calls visit(name, field) for each
/// field. Below there is one row for each struct of types.hpp.
template <class T> struct Fields;

/// A struct for which there is a list of fields.
template <class T>
concept Plain = requires
{
    typename Fields<std::remove_cvref_t<T>>::listed;
};

#define RIGOR_FIELD(name) visit(std::string_view(#name), value.name);
#define RIGOR_FIELDS(Type, ...)                                                                    \
    template <> struct Fields<Type> {                                                              \
        using listed = void;                                                                       \
        template <class Value, class Visit> static void each(Value& value, Visit&& visit)          \
        {                                                                                          \
            RIGOR_EACH(RIGOR_FIELD, __VA_ARGS__)                                                   \
        }                                                                                          \
    };

// RIGOR_EACH(macro, ...) expands `macro` for each of up to 41 arguments.
#define RIGOR_PARENTHESES ()
#define RIGOR_EXPAND(...) RIGOR_EXPAND_3(RIGOR_EXPAND_3(RIGOR_EXPAND_3(__VA_ARGS__)))
#define RIGOR_EXPAND_3(...) RIGOR_EXPAND_2(RIGOR_EXPAND_2(RIGOR_EXPAND_2(__VA_ARGS__)))
#define RIGOR_EXPAND_2(...) RIGOR_EXPAND_1(RIGOR_EXPAND_1(RIGOR_EXPAND_1(__VA_ARGS__)))
#define RIGOR_EXPAND_1(...) __VA_ARGS__
#define RIGOR_EACH(macro, ...) __VA_OPT__(RIGOR_EXPAND(RIGOR_EACH_NEXT(macro, __VA_ARGS__)))
#define RIGOR_EACH_NEXT(macro, first, ...)                                                         \
    macro(first) __VA_OPT__(RIGOR_EACH_AGAIN RIGOR_PARENTHESES(macro, __VA_ARGS__))
#define RIGOR_EACH_AGAIN() RIGOR_EACH_NEXT

RIGOR_FIELDS(Quaternion, s, v)
RIGOR_FIELDS(Particle, mass, position)
RIGOR_FIELDS(PointForce, force, point)
RIGOR_FIELDS(Wrench, force, torque)
RIGOR_FIELDS(MassProperties, mass, center_of_mass, inertia)
RIGOR_FIELDS(PrincipalAxes, rotation, moments)
RIGOR_FIELDS(DensitySample, position, density)
RIGOR_FIELDS(TriangleMesh, vertices, triangles)
RIGOR_FIELDS(MatrixState, position, rotation, velocity, angular_momentum)
RIGOR_FIELDS(MatrixStateRate, position_rate, rotation_rate, velocity_rate, angular_momentum_rate)
RIGOR_FIELDS(RigidState, position, orientation, velocity, angular_momentum)
RIGOR_FIELDS(BodyInertia, inverse_mass, inverse_inertia)
RIGOR_FIELDS(Body, inverse_mass, inverse_inertia, position, velocity, angular_velocity,
             angular_momentum)
RIGOR_FIELDS(ContactPoint, point, normal, depth, relative_velocity)
RIGOR_FIELDS(BodyContact, body1, body2, point, normal, depth, friction, separation_speed, impulse)
RIGOR_FIELDS(ContactResult, bodies, impulses)
RIGOR_FIELDS(LevelSet, origin, cell_size, size, distances)
RIGOR_FIELDS(TetrahedralMesh, vertices, tetrahedra)
RIGOR_FIELDS(MeshFace, tetrahedron, face)
RIGOR_FIELDS(PrincipalStress, stress, direction)
RIGOR_FIELDS(VertexOrigin, first, second, fraction)
RIGOR_FIELDS(SplitMesh, mesh, origins, parents)
RIGOR_FIELDS(ElementCrack, tetrahedron, point, normal)
RIGOR_FIELDS(EmbeddedMesh, mesh, vertex_parents, parents, real, fractions)

} // namespace rigor
