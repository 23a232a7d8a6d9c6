// SPDX-License-Identifier: MIT
// The law of the frames, for every formula that is not tied to the axes by definition: if the whole
// scene is turned and moved, the result turns and moves with it. The scene is turned by the 24
// rotations of the cube and by random ones, and by small ones where all directions are along an
// axis: then the components that were zero are nearly zero.
#include "add_law.hpp"
#include "strata.hpp"
#include "support/seeds.hpp"
#include "support/sweep.hpp"

namespace rigor::testing {

namespace {

// One of the 24 rotations that map the axes to each other.
Matrix3d cube_rotation(unsigned which)
{
    Matrix3d Q = Matrix3d::Zero();
    const int first = static_cast<int>(which % 3), second = (first + 1 + which / 3 % 2) % 3;
    Q(first, 0) = which / 6 % 2 ? 1 : -1;
    Q(second, 1) = which / 12 % 2 ? 1 : -1;
    Q.col(2) = Q.col(0).cross(Q.col(1));
    return Q;
}

constexpr bool turns(const Quantity& q)
{
    return q.kind != Kind::number && q.kind != Kind::any_number && q.kind != Kind::index;
}

constexpr bool has_frame(FormulaIndex f)
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    bool any = false;
    for (std::size_t i = 0; i < of.count; ++i) {
        if (of.arguments[i].kind == Kind::along_axes) return false;
        any |= turns(of.arguments[i]);
    }
    return any;
}

// Whether a formula has a unit vector among its arguments, such as a normal.
bool has_normal(const FormulaQuantities& of)
{
    return std::any_of(of.arguments.begin(), of.arguments.begin() + of.count,
                       [](const Quantity& q) { return q.kind == Kind::unit; });
}

// Aligns the directions in an argument with the axes. If the formula has a normal, vectors stay as
// they are: a velocity could become perpendicular to the normal, where a contact opens. The
// matrices K of a contact also stay.
template <class T> void align(T& value, const Quantity& q, bool has_normal, Random& random)
{
    if constexpr (std::is_same_v<T, Vector3d>) {
        const bool is_free = q.kind == Kind::vector && !has_normal;
        if (q.kind == Kind::unit || is_free) draw_special(value, q, Stratum::aligned, random);
    } else if constexpr (std::is_same_v<T, Matrix3d>) {
        const bool is_turn = q.kind == Kind::rotation || q.kind == Kind::columns;
        const Quantity as = is_turn ? quantities::rotation : q;
        const Stratum turned = random.bits() % 2 == 0 ? Stratum::equal : Stratum::singular;
        if (q.dimension != quantities::per_M)
            draw_special(value, as, is_turn ? turned : Stratum::aligned, random);
    } else if constexpr (std::is_same_v<T, Quaternion>) {
        if (q.kind == Kind::orientation) draw_special(value, q, Stratum::singular, random);
    }
}

// The scene of a seed, and how it is turned.
template <FormulaIndex f, auto& formula>
std::pair<Arguments<formula>, Change> turned_scene(unsigned seed)
{
    Random random(seed + 6000);
    Arguments<formula> arguments = random_arguments<f, formula>(seed / 2);
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    if (seed % 2 == 0) {
        const bool is_exact = seed % 4 == 0;
        return {arguments,
                {{}, is_exact ? cube_rotation(seed / 4) : random.rotation(), random.vector()}};
    }
    const int power = 8 + static_cast<int>(seed / 2 % 24); // the angle is 2^-8 … 2^-31 rad
    const Eigen::AngleAxisd turn(std::ldexp(1, -power), random.unit_vector());
    std::size_t i = 0;
    std::apply(
        [&](auto&... argument) {
            (align(argument, of.arguments[i++], has_normal(of), random), ...);
        },
        arguments);
    return {arguments, {{}, turn.toRotationMatrix(), random.vector()}};
}

template <FormulaIndex f, auto& formula> void check_frames()
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    for (unsigned seed : seeds(sampled(96))) {
        const auto [arguments, c] = turned_scene<f, formula>(seed);
        Arguments<formula> others = arguments;
        change_arguments(others, of, c);

        const auto expected = std::apply(formula, arguments);
        auto found = changed(std::apply(formula, others), of.result, c.undone());
        choose_as(found, expected, of.result);

        const auto& should = comparable(expected);
        require_close(comparable(found), should, universal(should),
                      "the scene is turned and moved, and the result turned and moved back");
    }
}

struct Frames {
    static constexpr const char* words = "turns with the scene";
    static constexpr bool holds_for(FormulaIndex f) { return has_frame(f); }
    template <FormulaIndex f, auto& formula> static void check() { check_frames<f, formula>(); }
};

[[maybe_unused]] const bool added_frames = add_law<Frames>();

} // namespace

} // namespace rigor::testing
