// SPDX-License-Identifier: MIT
// The dimension of every argument and result of the formulas and of every field of their structs,
// and how its value changes when the scene is turned. The headers of the topics say the same in
// words. The graded tests derive laws from this table, such as the same result in all units
// (tests/graded/laws/). A law is left out for a formula to which it does not apply.
#pragma once

#include "formulas/dimension.hpp"
#include "formulas/fields.hpp"
#include "formulas/table.hpp"

#include <array>
#include <initializer_list>
#include <iterator>

namespace rigor {

/// The kind of a quantity: which values are allowed, and what a value becomes when all of world
/// space and all of object space are turned by a rotation Q and moved by d.
enum class Kind {
    number,     // does not change; ≥ 0 in the arguments of the tests
    any_number, // does not change; of either sign
    index,      // does not change; an integer or a bool
    vector,     // v becomes Q v
    unit,       // n becomes Q n; |n| = 1
    direction,  // n becomes Q n or -Q n, both are correct
    point,      // x becomes Q x + d
    matrix,     // A becomes Q A Qᵀ
    symmetric,  // A becomes Q A Qᵀ; symmetric
    definite,   // A becomes Q A Qᵀ; symmetric and positive semi-definite
    rotation,   // R becomes Q R Qᵀ; a rotation
    columns,    // A becomes Q A; each column is a vector
    // Each 3×3 block B becomes Q B Qᵀ. The dimension of block (i, j) is that of block (0, 0) times
    // lengthⁱ⁺ʲ.
    blocks,
    quaternion,  // (s, v) becomes (s, Q v)
    orientation, // (s, v) becomes (s, Q v); unit
    chosen,      // several values are correct, so no law follows from a rotation
    along_axes,  // tied to the axes by definition, so no law follows from a rotation
    fields       // a struct: each field has its own quantity
};

struct Quantity {
    Dimension dimension;
    Kind kind = Kind::number;
};

namespace quantities {

inline constexpr Dimension none = {}, M = {1, 0, 0}, L = {0, 1, 0}, per_T = {0, 0, -1};
inline constexpr Dimension per_M = {-1, 0, 0}, L2 = L * L, L3 = L * L * L, per_L = {0, -1, 0};
inline constexpr Dimension pascal = M * per_L * per_T * per_T;

inline constexpr Quantity ratio = {none, Kind::number}, fields = {none, Kind::fields},
                          integer = {none, Kind::index}, unit = {none, Kind::unit},
                          direction = {none, Kind::direction};
inline constexpr Quantity mass = {M, Kind::number}, inverse_mass = {per_M, Kind::number},
                          density = {M * per_L * per_L * per_L, Kind::number},
                          line_density = {M * per_L, Kind::number};
inline constexpr Quantity size = {L, Kind::number}, depth = {L, Kind::any_number},
                          sizes = {L, Kind::along_axes}, volume = {L3, Kind::number},
                          point = {L, Kind::point}, displacement = {L, Kind::vector},
                          duration = {{0, 0, 1}, Kind::number};
inline constexpr Quantity velocity = {L * per_T, Kind::vector},
                          speed = {L * per_T, Kind::any_number},
                          acceleration = {L * per_T * per_T, Kind::vector},
                          angular_velocity = {per_T, Kind::vector};
inline constexpr Quantity force = {M * L * per_T * per_T, Kind::vector},
                          torque = {M * L2 * per_T * per_T, Kind::vector},
                          energy = {M * L2 * per_T * per_T, Kind::number},
                          impulse = {M * L * per_T, Kind::vector},
                          angular_momentum = {M * L2 * per_T, Kind::vector};
inline constexpr Quantity inertia = {M * L2, Kind::definite}, moments = {M * L2, Kind::along_axes},
                          inverse_moments = {per_M * per_L * per_L, Kind::along_axes},
                          inverse_inertia = {per_M * per_L * per_L, Kind::definite},
                          impulse_matrix = {per_M, Kind::definite};
inline constexpr Quantity rotation = {none, Kind::rotation}, columns = {none, Kind::columns},
                          angles = {none, Kind::along_axes}, axes = {none, Kind::chosen},
                          rotation_rate = {per_T, Kind::matrix},
                          quaternion = {none, Kind::quaternion},
                          orientation = {none, Kind::orientation},
                          quaternion_rate = {per_T, Kind::quaternion},
                          angle_rates = {per_T, Kind::along_axes};
inline constexpr Quantity stress = {pascal, Kind::symmetric}, strain = {none, Kind::symmetric},
                          pressure = {pascal, Kind::number}, principal = {pascal, Kind::any_number};
inline constexpr Quantity modes = {none, Kind::blocks}, mode_rates = {per_T, Kind::blocks},
                          masses = {M, Kind::blocks}, rate_matrix = {per_T, Kind::matrix},
                          matrix = {none, Kind::matrix}, long_columns = {L, Kind::columns},
                          along_axes = {none, Kind::along_axes};

} // namespace quantities

/// The quantities of the fields of T, in their order in `Fields<T>`.
template <class T> struct FieldQuantities;

#define RIGOR_OF(name) quantities::name,
#define RIGOR_FIELD_QUANTITIES(Type, ...)                                                          \
    template <> struct FieldQuantities<Type> {                                                     \
        static constexpr Quantity of[] = {RIGOR_EACH(RIGOR_OF, __VA_ARGS__)};                      \
    };

// The fields s and v of a quaternion have no dimension in this list. Both have the dimension of the
// whole quaternion, for example 1/s for `quaternion_rate`.
template <> struct FieldQuantities<Quaternion> {
    static constexpr Quantity of[] = {{{}, Kind::any_number}, {{}, Kind::vector}};
};
RIGOR_FIELD_QUANTITIES(Particle, mass, point)
RIGOR_FIELD_QUANTITIES(PointForce, force, point)
RIGOR_FIELD_QUANTITIES(Wrench, force, torque)
RIGOR_FIELD_QUANTITIES(MassProperties, mass, point, inertia)
RIGOR_FIELD_QUANTITIES(PrincipalAxes, axes, moments)
RIGOR_FIELD_QUANTITIES(DensitySample, point, density)
RIGOR_FIELD_QUANTITIES(TriangleMesh, point, integer)
RIGOR_FIELD_QUANTITIES(MatrixState, point, rotation, velocity, angular_momentum)
RIGOR_FIELD_QUANTITIES(MatrixStateRate, velocity, rotation_rate, acceleration, torque)
RIGOR_FIELD_QUANTITIES(RigidState, point, orientation, velocity, angular_momentum)
RIGOR_FIELD_QUANTITIES(BodyInertia, inverse_mass, inverse_inertia)
RIGOR_FIELD_QUANTITIES(Body, inverse_mass, inverse_inertia, point, velocity, angular_velocity,
                       angular_momentum)
RIGOR_FIELD_QUANTITIES(ContactPoint, point, unit, depth, velocity)
RIGOR_FIELD_QUANTITIES(BodyContact, integer, integer, point, unit, depth, ratio, speed, impulse)
RIGOR_FIELD_QUANTITIES(ContactResult, fields, impulse)
RIGOR_FIELD_QUANTITIES(LevelSet, sizes, size, integer, depth)
RIGOR_FIELD_QUANTITIES(TetrahedralMesh, point, integer)
RIGOR_FIELD_QUANTITIES(MeshFace, integer, integer)
RIGOR_FIELD_QUANTITIES(PrincipalStress, principal, direction)
RIGOR_FIELD_QUANTITIES(VertexOrigin, integer, integer, ratio)
RIGOR_FIELD_QUANTITIES(SplitMesh, fields, fields, integer)
RIGOR_FIELD_QUANTITIES(ElementCrack, integer, point, unit)
RIGOR_FIELD_QUANTITIES(EmbeddedMesh, fields, integer, integer, integer, ratio)
RIGOR_FIELD_QUANTITIES(Dimension, integer, integer, integer)
// The numbers of a formula under test may have any kind, so a rotation gives no law for them.
RIGOR_FIELD_QUANTITIES(KnownCall, along_axes, along_axes)
RIGOR_FIELD_QUANTITIES(Judgement, integer, integer, along_axes)
template <class Result, class... Argument> struct FieldQuantities<UnderTest<Result, Argument...>> {
    static constexpr Quantity of[] = {quantities::along_axes};
};

// FORMULA(function, result, arguments …), in the order of the table in formulas/table.hpp. If a
// formula works in any unit, as `normalize` does, one of the possible units is used here.
// clang-format off
#define RIGOR_FORMULA_QUANTITIES(FORMULA)                                                          \
    FORMULA(kinetic_energy, energy, mass, velocity, inertia, angular_velocity)              \
    FORMULA(cross_matrix, rate_matrix, angular_velocity)                                    \
    FORMULA(world_point, point, rotation, point, displacement)                              \
    FORMULA(object_point, displacement, rotation, point, point)                             \
    FORMULA(angular_velocity, angular_velocity, rotation_rate, rotation)                    \
    FORMULA(point_velocity, velocity, velocity, angular_velocity, point, point)             \
    FORMULA(velocity_modes, modes, point, point)                                            \
    FORMULA(generalized_mass, masses, fields, point)                                        \
    FORMULA(net_wrench, fields, fields, point)                                              \
    FORMULA(equations_of_motion, fields, fields, inverse_mass, inverse_inertia, fields)     \
    FORMULA(velocity_mode_rates, mode_rates, velocity, velocity)                            \
    FORMULA(inertial_wrench, fields, fields, point, velocity, angular_velocity)             \
    FORMULA(particle_mass_properties, fields, fields)                                       \
    FORMULA(world_inertia, inertia, rotation, inertia)                                      \
    FORMULA(world_inverse_inertia, inverse_inertia, rotation, inverse_inertia)              \
    FORMULA(principal_axes, fields, inertia)                                                \
    FORMULA(invert_moments, inverse_moments, moments)                                       \
    FORMULA(solid_sphere, fields, density, size)                                            \
    FORMULA(solid_box, fields, density, sizes)                                              \
    FORMULA(solid_cylinder, fields, density, size, size)                                    \
    FORMULA(solid_ellipsoid, fields, density, sizes)                                        \
    FORMULA(thin_rod, fields, line_density, size)                                           \
    FORMULA(grid_mass_properties, fields, fields, size)                                     \
    FORMULA(sampled_mass_properties, fields, fields, volume)                                \
    FORMULA(mesh_mass_properties, fields, fields, density)                                  \
    FORMULA(combine, fields, fields, fields)                                                \
    FORMULA(bounding_box_mass_properties, fields, sizes, mass)                              \
    FORMULA(advance_matrix, matrix, rotation, angular_velocity, duration)                   \
    FORMULA(gram_schmidt, columns, long_columns)                                            \
    FORMULA(euler_to_matrix, along_axes, angles)                                            \
    FORMULA(euler_rates, angle_rates, angles, angle_rates)                                  \
    FORMULA(multiply, quaternion_rate, quaternion, quaternion_rate)                         \
    FORMULA(conjugate, quaternion_rate, quaternion_rate)                                    \
    FORMULA(normalize, orientation, quaternion_rate)                                        \
    FORMULA(rotate, displacement, orientation, displacement)                                \
    FORMULA(to_matrix, rotation, orientation)                                               \
    FORMULA(quaternion_rate, quaternion_rate, orientation, angular_velocity)                \
    FORMULA(advance_exact, orientation, orientation, angular_velocity, duration)            \
    FORMULA(advance_linear, orientation, orientation, angular_velocity, duration)           \
    FORMULA(max_time_step, duration, angular_velocity)                                      \
    FORMULA(gravity_wrench, fields, mass, acceleration)                                     \
    FORMULA(step_symplectic_euler, fields, fields, fields, fields, duration)                \
    FORMULA(step_buss, fields, fields, fields, fields, duration)                            \
    FORMULA(sample_level_set, depth, fields, sizes)                                         \
    FORMULA(level_set_normal, along_axes, fields, sizes)                                    \
    FORMULA(relative_velocity, velocity, fields, fields, point)                             \
    FORMULA(impulse_matrix, impulse_matrix, inverse_mass, inverse_inertia, point, point)    \
    FORMULA(frictionless_impulse, impulse, impulse_matrix, velocity, unit, ratio)           \
    FORMULA(static_friction_impulse, impulse, impulse_matrix, velocity, unit, ratio)        \
    FORMULA(inside_friction_cone, integer, impulse, unit, ratio)                            \
    FORMULA(sliding_friction_impulse, impulse, impulse_matrix, velocity, unit, ratio, ratio) \
    FORMULA(collision_impulse, impulse, impulse_matrix, velocity, unit, ratio, ratio)       \
    FORMULA(apply_impulse, fields, fields, point, impulse)                                  \
    FORMULA(deepest_approaching_point, integer, fields)                                     \
    FORMULA(contact_restitution, ratio, integer, integer)                                   \
    FORMULA(resolve_contacts, fields, fields, fields, integer)                              \
    FORMULA(contact_levels, integer, integer, integer)                                      \
    FORMULA(shock_propagation, fields, fields, fields, integer, integer)                    \
    FORMULA(resolve_simultaneously, fields, fields, fields, integer)                        \
    FORMULA(deviator, stress, stress)                                                       \
    FORMULA(von_mises_principal, pressure, principal, principal, principal)                 \
    FORMULA(von_mises_frobenius, pressure, stress)                                          \
    FORMULA(von_mises, pressure, stress)                                                    \
    FORMULA(isotropic_stress, stress, strain, pressure, pressure)                           \
    FORMULA(von_mises_from_strain, pressure, strain, pressure)                              \
    FORMULA(yield_strain, ratio, pressure, pressure)                                        \
    FORMULA(plastic_flow, strain, strain, stress, pressure, pressure)                       \
    FORMULA(smooth_stress, stress, stress, integer, volume)                                 \
    FORMULA(principal_stress, fields, stress)                                               \
    FORMULA(crack_plane, direction, stress, principal)                                      \
    FORMULA(closest_face, integer, point, unit)                                             \
    FORMULA(split_along_faces, fields, fields, fields)                                      \
    FORMULA(split_element, fields, fields, integer, unit)                                   \
    FORMULA(virtual_nodes, fields, fields, fields)                                          \
    FORMULA(test_line_collision, fields, along_axes)                                        \
    FORMULA(test_spring_force, fields, along_axes)                                          \
    FORMULA(test_tangent, fields, along_axes)                                               \
    FORMULA(test_oscillator_step, fields, along_axes)                                       \
    FORMULA(test_units, fields, along_axes, along_axes, integer, integer)
// clang-format on

/// The quantities of a formula: its result, and its arguments in their order.
struct FormulaQuantities {
    std::string_view name;
    Quantity result;
    std::array<Quantity, 6> arguments;
    std::size_t count; // how many arguments there are
};

#define RIGOR_ROW(function, first, ...)                                                            \
    FormulaQuantities{                                                                             \
        #function,                                                                                 \
        quantities::first,                                                                         \
        {RIGOR_EACH(RIGOR_OF, __VA_ARGS__)},                                                       \
        std::size(std::initializer_list<Quantity>{RIGOR_EACH(RIGOR_OF, __VA_ARGS__)})},
inline constexpr FormulaQuantities formula_quantities[] = {RIGOR_FORMULA_QUANTITIES(RIGOR_ROW)};
#undef RIGOR_ROW

} // namespace rigor
