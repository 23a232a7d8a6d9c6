// SPDX-License-Identifier: MIT
// Random arguments of any formula. Numbers are drawn from the sets that the table of quantities
// names; indices, meshes and contacts that belong together come from the cases of their topics.
#pragma once

#include "formulas/quantities.hpp"
#include "graded/contact/contact_cases.hpp"
#include "graded/fracture/fracture_cases.hpp"
#include "support/random.hpp"

#include <tuple>

namespace rigor::testing {

template <class Result, class... Argument>
std::tuple<std::remove_cvref_t<Argument>...> arguments_of(Result (*)(Argument...));

template <auto& formula> using Arguments = decltype(arguments_of(&formula));

/// Draws a value from the set that `q` names.
template <class T> void draw(T& value, const Quantity& q, Random& random);

inline Matrix3d draw_matrix(const Quantity& q, Random& random)
{
    Matrix3d A;
    A << random.vector(), random.vector(), random.vector();
    switch (q.kind) {
    case Kind::rotation:
        return random.rotation();
    case Kind::definite: // an inertia of a real body, or its inverse
        if (q.dimension.length == 0) return random.positive_definite();
        return q.dimension.mass > 0 ? random.inertia() : Matrix3d(random.inertia().inverse());
    case Kind::symmetric:
        return (A + A.transpose()) / 2;
    case Kind::columns:
        return random.rotation() + 0.2 * A;
    default:
        return A;
    }
}

template <class T> void draw(T& value, const Quantity& q, Random& random)
{
    if constexpr (std::is_same_v<T, Body>) {
        value = random.body();
    } else if constexpr (std::is_same_v<T, Quaternion>) {
        value = q.kind == Kind::orientation ? random.quaternion()
                                            : Quaternion{random.uniform(-1, 1), random.vector()};
    } else if constexpr (Plain<T>) {
        const Quantity* of = FieldQuantities<T>::of;
        Fields<T>::each(value, [&](std::string_view, auto& field) { draw(field, *of++, random); });
    } else if constexpr (std::is_same_v<T, double>) {
        value = q.kind == Kind::any_number ? random.uniform(-1, 1) : random.uniform(0.1, 1);
        if (q.dimension == quantities::duration.dimension) value /= 16; // small turns
    } else if constexpr (std::is_same_v<T, Vector3d>) {
        value = q.kind == Kind::unit ? random.unit_vector() : random.vector();
        if (q.kind == Kind::along_axes) value = value.cwiseAbs().array() + 0.1;
    } else if constexpr (std::is_same_v<T, Matrix3d>) {
        value = draw_matrix(q, random);
    } else if constexpr (std::is_same_v<T, std::vector<bool>>) {
        return; // drawn later, together with the list that it belongs to
    } else if constexpr (requires { value.resize(1); }) {
        value.resize(1 + random.bits() % 5);
        for (auto& element : value)
            draw(element, q, random);
    } else if constexpr (requires { value[0]; }) {
        for (auto& element : value)
            draw(element, q, random);
    }
}

/// Cracks of a small solid: up to two planes through each of its tetrahedra.
inline std::vector<ElementCrack> random_cracks(const TetrahedralMesh& mesh, Random& random)
{
    std::vector<ElementCrack> cracks;
    for (int t = 0; t < static_cast<int>(mesh.tetrahedra.size()); ++t)
        for (std::uint64_t n = random.bits() % 3; n > 0; --n) {
            const auto x = corners_of(mesh, t);
            const double s = random.uniform(0.3, 0.7);
            const Vector3d middle = (x[0] + x[1] + x[2] + x[3]) / 4;
            cracks.push_back(
                {t, s * x[random.bits() % 4] + (1 - s) * middle, random.unit_vector()});
        }
    return cracks;
}

inline LevelSet random_level_set(Random& random)
{
    LevelSet grid{random.vector(), random.uniform(0.2, 0.5), {}, {}};
    std::size_t nodes = 1;
    for (int& n : grid.size)
        nodes *= static_cast<std::size_t>(n = 2 + random_index(random, 3));
    for (std::size_t i = 0; i < nodes; ++i)
        grid.distances.push_back(random.uniform(-1, 1));
    return grid;
}

inline std::vector<std::vector<int>> random_links(std::size_t from, std::size_t to, Random& random)
{
    std::vector<std::vector<int>> links(from);
    for (auto& each : links)
        for (std::uint64_t n = random.bits() % 4; n > 0; --n)
            each.push_back(random_index(random, to));
    return links;
}

/// Arguments of the formula at index f of the table, drawn with this seed.
template <FormulaIndex f, auto& formula> Arguments<formula> random_arguments(unsigned seed)
{
    using F = FormulaIndex;
    Random random(seed);
    Arguments<formula> arguments;
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    std::size_t i = 0;
    std::apply([&](auto&... argument) { (draw(argument, of.arguments[i++], random), ...); },
               arguments);

    if constexpr (f == F::frictionless_impulse || f == F::static_friction_impulse ||
                  f == F::sliding_friction_impulse || f == F::collision_impulse) {
        CollidingPair pair = colliding_pair(seed);
        double friction = random.uniform(0.1, 1);
        // away from the borders of the cone and of jamming, where rounding decides
        while (std::abs(margin(pair, friction)) < 1e-3 || !slides_easily(pair, friction))
            friction *= 0.9;
        std::get<0>(arguments) = pair.K;
        std::get<1>(arguments) = pair.v;
        std::get<2>(arguments) = pair.n;
        if constexpr (std::tuple_size_v<Arguments<formula>> == 5) std::get<4>(arguments) = friction;
    }
    if constexpr (f == F::mesh_mass_properties) {
        const TetrahedralMesh solid = jiggled(unit_tetrahedron(), random);
        std::get<0>(arguments) = {solid.vertices, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
    }
    if constexpr (f == F::sample_level_set || f == F::level_set_normal) {
        const LevelSet grid = random_level_set(random);
        std::get<0>(arguments) = grid;
        std::get<1>(arguments) = grid.origin + 0.5 * random.vector();
    }
    if constexpr (f == F::test_units)
        std::get<2>(arguments).resize(std::get<1>(arguments).size()); // a dimension for each number
    if constexpr (f == F::contact_restitution)
        arguments = {random_index(random, 10), random_index(random, 12)};
    if constexpr (f == F::contact_levels) {
        const std::size_t n = 1 + random.bits() % 8;
        std::vector<bool> is_static;
        for (std::size_t k = 0; k < n; ++k)
            is_static.push_back(random.bits() % 3 == 0);
        arguments = {random_links(n, n, random), is_static};
    }
    if constexpr (f == F::resolve_contacts || f == F::shock_propagation ||
                  f == F::resolve_simultaneously) {
        ContactCase pile = pile_of_balls(seed);
        for (BodyContact& c : pile.contacts)
            c.impulse = c.normal * random.uniform(0, 0.1);
        std::get<0>(arguments) = pile.bodies;
        std::get<1>(arguments) = pile.contacts;
        constexpr std::size_t last = std::tuple_size_v<Arguments<formula>> - 1;
        std::get<last>(arguments) = 1 + random_index(random, 4);
        if constexpr (f == F::shock_propagation) {
            auto& levels = std::get<2>(arguments);
            levels.clear();
            for (const Body& body : pile.bodies)
                levels.push_back(body.is_static() ? 0 : 1 + random_index(random, 3));
        }
    }
    if constexpr (f == F::smooth_stress) {
        const std::size_t n = std::get<0>(arguments).size();
        std::get<1>(arguments) = random_links(n, n, random);
        std::get<2>(arguments).assign(n, 0);
        for (double& volume : std::get<2>(arguments))
            volume = random.uniform(0.1, 1);
    }
    if constexpr (f == F::split_along_faces || f == F::split_element || f == F::virtual_nodes) {
        const TetrahedralMesh solid = jiggled(block(2, 1, 1), random);
        std::get<0>(arguments) = solid;
        if constexpr (f == F::split_element)
            std::get<1>(arguments) = random_index(random, solid.vertices.size());
        if constexpr (f == F::virtual_nodes) std::get<1>(arguments) = random_cracks(solid, random);
        if constexpr (f == F::split_along_faces) {
            std::get<1>(arguments).clear();
            for (int n = 0; n < 12; ++n)
                std::get<1>(arguments).push_back(
                    {random_index(random, solid.tetrahedra.size()), random_index(random, 4)});
        }
    }
    return arguments;
}

} // namespace rigor::testing
