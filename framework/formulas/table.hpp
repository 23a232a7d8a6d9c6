// SPDX-License-Identifier: MIT
// The table of all formulas: tag, topic, function and the names of its arguments. The worker's
// dispatch, the proxy, `rigor list` and every message about a formula are generated from this
// table; the types come from the declaration of the function.
#pragma once

#include "formulas/collision.hpp"
#include "formulas/contact.hpp"
#include "formulas/fracture.hpp"
#include "formulas/inertia.hpp"
#include "formulas/kinematics.hpp"
#include "formulas/pipeline.hpp"
#include "formulas/plasticity.hpp"
#include "formulas/rotation.hpp"
#include "formulas/validation.hpp"

#include <bitset>
#include <string>
#include <string_view>

// clang-format off
#define RIGOR_FORMULAS(FORMULA)                                                                    \
    FORMULA(A0.1,  pipeline,   kinetic_energy, mass, velocity, inertia, angular_velocity)          \
    FORMULA(A1.1,  kinematics, cross_matrix, w)                                                    \
    FORMULA(A1.2,  kinematics, world_point, R, X, p)                                               \
    FORMULA(A1.3,  kinematics, object_point, R, X, x)                                              \
    FORMULA(A1.4,  kinematics, angular_velocity, R_dot, R)                                         \
    FORMULA(A1.5,  kinematics, point_velocity, V, omega, X, x)                                     \
    FORMULA(A1.6,  kinematics, velocity_modes, X, x)                                               \
    FORMULA(A1.7,  kinematics, generalized_mass, particles, X)                                     \
    FORMULA(A1.8,  kinematics, net_wrench, forces, X)                                              \
    FORMULA(A1.9,  kinematics, equations_of_motion, state, inverse_mass, I_inverse, wrench)        \
    FORMULA(A1.12, kinematics, velocity_mode_rates, V, v)                                          \
    FORMULA(A1.13, kinematics, inertial_wrench, particles, X, V, omega)                            \
    FORMULA(A2.1,  inertia,    particle_mass_properties, particles)                                \
    FORMULA(A2.2,  inertia,    world_inertia, R, I_body)                                           \
    FORMULA(A2.3,  inertia,    world_inverse_inertia, R, I_body_inverse)                           \
    FORMULA(A2.4,  inertia,    principal_axes, I)                                                  \
    FORMULA(A2.5,  inertia,    invert_moments, moments)                                            \
    FORMULA(A2.6,  inertia,    solid_sphere, density, radius)                                      \
    FORMULA(A2.7,  inertia,    solid_box, density, size)                                           \
    FORMULA(A2.8,  inertia,    solid_cylinder, density, radius, height)                            \
    FORMULA(A2.9,  inertia,    solid_ellipsoid, density, radii)                                    \
    FORMULA(A2.10, inertia,    thin_rod, line_density, length)                                     \
    FORMULA(A2.11, inertia,    grid_mass_properties, samples, cell_size)                           \
    FORMULA(A2.12, inertia,    sampled_mass_properties, samples, volume)                           \
    FORMULA(A2.13, inertia,    mesh_mass_properties, mesh, density)                                \
    FORMULA(A2.14, inertia,    combine, a, b)                                                      \
    FORMULA(A2.17, inertia,    bounding_box_mass_properties, vertices, mass)                       \
    FORMULA(A3.1,  rotation,   advance_matrix, R, omega, time_step)                                \
    FORMULA(A3.2,  rotation,   gram_schmidt, R)                                                    \
    FORMULA(A3.3,  rotation,   euler_to_matrix, angles)                                            \
    FORMULA(A3.4,  rotation,   euler_rates, angles, omega)                                         \
    FORMULA(A3.5,  rotation,   multiply, a, b)                                                     \
    FORMULA(A3.6,  rotation,   conjugate, q)                                                       \
    FORMULA(A3.7,  rotation,   normalize, q)                                                       \
    FORMULA(A3.8,  rotation,   rotate, q, p)                                                       \
    FORMULA(A3.9,  rotation,   to_matrix, q)                                                       \
    FORMULA(A3.10, rotation,   quaternion_rate, q, omega)                                          \
    FORMULA(A3.11, rotation,   advance_exact, q, omega, time_step)                                 \
    FORMULA(A3.12, rotation,   advance_linear, q, omega, time_step)                                \
    FORMULA(A3.13, rotation,   max_time_step, omega)                                               \
    FORMULA(A3.14, rotation,   gravity_wrench, mass, gravity)                                      \
    FORMULA(A3.15, rotation,   step_symplectic_euler, state, body, wrench, time_step)              \
    FORMULA(A3.16, rotation,   step_buss, state, body, wrench, time_step)                          \
    FORMULA(A4.1,  collision,  sample_level_set, grid, p)                                          \
    FORMULA(A4.2,  collision,  level_set_normal, grid, p)                                          \
    FORMULA(A4.3,  collision,  relative_velocity, body1, body2, x)                                 \
    FORMULA(A4.4,  collision,  impulse_matrix, inverse_mass, I_inverse, X, x)                      \
    FORMULA(A4.5,  collision,  frictionless_impulse, K, v, n, restitution)                         \
    FORMULA(A4.6,  collision,  static_friction_impulse, K, v, n, restitution)                      \
    FORMULA(A4.7,  collision,  inside_friction_cone, j, n, friction)                               \
    FORMULA(A4.8,  collision,  sliding_friction_impulse, K, v, n, restitution, friction)           \
    FORMULA(A4.9,  collision,  collision_impulse, K, v, n, restitution, friction)                  \
    FORMULA(A4.10, collision,  apply_impulse, body, x, j)                                          \
    FORMULA(A4.11, collision,  deepest_approaching_point, contacts)                                     \
    FORMULA(A5.1,  contact,    contact_restitution, k, n)                                          \
    FORMULA(A5.2,  contact,    resolve_contacts, bodies, contacts, n)                              \
    FORMULA(A5.3,  contact,    contact_levels, rests_on, is_static)                                \
    FORMULA(A5.4,  contact,    shock_propagation, bodies, contacts, levels, n)                     \
    FORMULA(A5.5,  contact,    resolve_simultaneously, bodies, contacts, sweeps)                   \
    FORMULA(A6.1,  plasticity, deviator, stress)                                                   \
    FORMULA(A6.2,  plasticity, von_mises_principal, stress1, stress2, stress3)                     \
    FORMULA(A6.3,  plasticity, von_mises_frobenius, stress)                                        \
    FORMULA(A6.4,  plasticity, von_mises, stress)                                                  \
    FORMULA(A6.5,  plasticity, isotropic_stress, strain, lame_lambda, shear_modulus)               \
    FORMULA(A6.6,  plasticity, von_mises_from_strain, strain, shear_modulus)                       \
    FORMULA(A6.7,  plasticity, yield_strain, yield_stress, shear_modulus)                          \
    FORMULA(A6.8,  plasticity, plastic_flow, plastic_strain, stress, yield_stress, shear_modulus) \
    FORMULA(A7.1,  fracture,   smooth_stress, stresses, neighbours, volumes)                       \
    FORMULA(A7.2,  fracture,   principal_stress, stress)                                           \
    FORMULA(A7.3,  fracture,   crack_plane, stress, threshold)                                     \
    FORMULA(A7.4,  fracture,   closest_face, tetrahedron, normal)                                  \
    FORMULA(A7.5,  fracture,   split_along_faces, mesh, faces)                                     \
    FORMULA(A7.6,  fracture,   split_element, mesh, vertex, normal)                                \
    FORMULA(A7.7,  fracture,   virtual_nodes, mesh, cracks)                                        \
    FORMULA(A8.1,  validation, test_line_collision, collide)                                       \
    FORMULA(A8.2,  validation, test_spring_force, force)                                           \
    FORMULA(A8.3,  validation, test_tangent, tangent)                                              \
    FORMULA(A8.4,  validation, test_oscillator_step, step)                                         \
    FORMULA(A8.5,  validation, test_units, formula, example, arguments, result)
// clang-format on

namespace rigor {

/// A row of the table.
struct Formula {
    std::string_view tag;       // such as "A2.14"
    std::string_view topic;     // such as "inertia": student/inertia.cpp, assignments/a2-inertia/
    std::string_view name;      // such as "combine"
    std::string_view arguments; // names of the parameters, such as "a, b"
};

#define RIGOR_ROW(tag, topic, function, ...) Formula{#tag, #topic, #function, #__VA_ARGS__},
inline constexpr Formula formulas[] = {RIGOR_FORMULAS(RIGOR_ROW)};
#undef RIGOR_ROW

/// The index of a formula in the table, for example `FormulaIndex::combine`.
#define RIGOR_ROW(tag, topic, function, ...) function,
enum class FormulaIndex : unsigned { RIGOR_FORMULAS(RIGOR_ROW) };
#undef RIGOR_ROW

inline constexpr unsigned formula_count = std::size(formulas);

/// A set of formulas: bit i stands for the formula with index i in the table.
using FormulaSet = std::bitset<formula_count>;

/// The message about a stub: `A4.10 apply_impulse is not implemented yet (student/collision.cpp)`.
inline std::string describe(const NotImplemented& stub)
{
    const std::string_view thrown = stub.what();
    for (const Formula& formula : formulas) {
        const std::string topic(formula.topic), name(formula.name);
        if (thrown == topic + "::" + name)
            return std::string(formula.tag) + " " + name + " is not implemented yet (student/" +
                   topic + ".cpp)";
    }
    return std::string(thrown) + " is not implemented yet";
}

} // namespace rigor
