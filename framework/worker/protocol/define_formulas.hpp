// SPDX-License-Identifier: MIT
// Defines every formula of the table (formulas/table.hpp) from its declaration.
// `RIGOR_FORMULAS(RIGOR_DEFINE_FORMULA)` turns the row
// `FORMULA(A2.14, inertia, combine, a, b)` into
//
//     MassProperties combine(const MassProperties& a, const MassProperties& b)
//     {
//         return answer<FormulaIndex::combine, Signature<decltype(&combine)>>(a, b);
//     }
//
// A file that includes this one defines the function template `answer` before it uses the macro.
#pragma once

#include "formulas/table.hpp"

#include <tuple>

namespace rigor {

/// The types of a function's result and parameters, taken from its declaration.
template <class Function> struct Signature;
template <class R, class... Argument> struct Signature<R (*)(Argument...)> {
    using Result = R;
    using Pointer = R (*)(Argument...);
    template <int i> using Parameter = std::tuple_element_t<i, std::tuple<Argument...>>;
};

} // namespace rigor

#define RIGOR_SIGNATURE(f) ::rigor::Signature<decltype(&::rigor::f)>
#define RIGOR_PARAMETER(f, i, name) RIGOR_SIGNATURE(f)::Parameter<i> name
#define RIGOR_LIST(...) __VA_ARGS__
#define RIGOR_DEFINE(f, names, ...)                                                                \
    RIGOR_SIGNATURE(f)::Result f(__VA_ARGS__)                                                      \
    {                                                                                              \
        return answer<FormulaIndex::f, RIGOR_SIGNATURE(f)>(RIGOR_LIST names);                      \
    }
#define RIGOR_DEFINE_1(f, a) RIGOR_DEFINE(f, (a), RIGOR_PARAMETER(f, 0, a))
#define RIGOR_DEFINE_2(f, a, b)                                                                    \
    RIGOR_DEFINE(f, (a, b), RIGOR_PARAMETER(f, 0, a), RIGOR_PARAMETER(f, 1, b))
#define RIGOR_DEFINE_3(f, a, b, c)                                                                 \
    RIGOR_DEFINE(f, (a, b, c), RIGOR_PARAMETER(f, 0, a), RIGOR_PARAMETER(f, 1, b),                 \
                 RIGOR_PARAMETER(f, 2, c))
#define RIGOR_DEFINE_4(f, a, b, c, d)                                                              \
    RIGOR_DEFINE(f, (a, b, c, d), RIGOR_PARAMETER(f, 0, a), RIGOR_PARAMETER(f, 1, b),              \
                 RIGOR_PARAMETER(f, 2, c), RIGOR_PARAMETER(f, 3, d))
#define RIGOR_DEFINE_5(f, a, b, c, d, e)                                                           \
    RIGOR_DEFINE(f, (a, b, c, d, e), RIGOR_PARAMETER(f, 0, a), RIGOR_PARAMETER(f, 1, b),           \
                 RIGOR_PARAMETER(f, 2, c), RIGOR_PARAMETER(f, 3, d), RIGOR_PARAMETER(f, 4, e))
#define RIGOR_SELECT(_1, _2, _3, _4, _5, define, ...) define
#define RIGOR_DEFINE_FORMULA(tag, topic, f, ...)                                                   \
    RIGOR_SELECT(__VA_ARGS__, RIGOR_DEFINE_5, RIGOR_DEFINE_4, RIGOR_DEFINE_3, RIGOR_DEFINE_2,      \
                 RIGOR_DEFINE_1, )                                                                 \
    (f, __VA_ARGS__)
