// SPDX-License-Identifier: MIT
// The law of the frames, for every formula that is not tied to the axes by definition: if the whole
// scene is turned and moved, the result turns and moves with it. The scene is turned by the 24
// rotations of the cube and by random ones.
#include "change.hpp"
#include "inputs.hpp"
#include "support/seeds.hpp"

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

bool turns(const Quantity& q)
{
    return q.kind != Kind::number && q.kind != Kind::any_number && q.kind != Kind::index;
}

bool has_frame(FormulaIndex f)
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    bool any = false;
    for (std::size_t i = 0; i < of.count; ++i) {
        if (of.arguments[i].kind == Kind::along_axes) return false;
        any |= turns(of.arguments[i]);
    }
    return any;
}

template <FormulaIndex f, auto& formula> void check_frames()
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    for (unsigned seed : seeds(48)) {
        Random random(seed + 6000);
        const bool is_exact = seed % 2 == 0;
        const Change c = {
            {}, is_exact ? cube_rotation(seed / 2) : random.rotation(), random.vector()};
        const Arguments<formula> arguments = random_arguments<f, formula>(seed);
        Arguments<formula> others = arguments;
        change_arguments(others, of, c);

        const auto expected = std::apply(formula, arguments);
        auto found = changed(std::apply(formula, others), of.result, c.undone());
        choose_as(found, expected, of.result);

        INFO("the scene is turned and moved, and the result turned and moved back");
        const auto& should = comparable(expected);
        REQUIRE_THAT(comparable(found), IsClose(should, universal(should)));
    }
}

#define RIGOR_ROW(tag, topic, function, ...)                                                       \
    const bool frames_of_##function =                                                              \
        has_frame(FormulaIndex::function) &&                                                       \
        add_test(&check_frames<FormulaIndex::function, rigor::function>,                           \
                 #topic ": " #function " turns with the scene", "[" #tag "][" #topic "]");
RIGOR_FORMULAS(RIGOR_ROW)
#undef RIGOR_ROW

} // namespace

} // namespace rigor::testing
