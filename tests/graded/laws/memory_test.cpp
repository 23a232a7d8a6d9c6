// SPDX-License-Identifier: MIT
// The law of no memory, for every formula: an answer depends on the arguments alone, and not on the
// calls before. Each call is made after one that has nothing in common with it, and after one that
// differs in a single argument.
#include "change.hpp"
#include "inputs.hpp"
#include "support/seeds.hpp"

#include <type_traits>

namespace rigor::testing {

namespace {

// The first arguments with one of them taken from the second, for each argument of a type that does
// not refer to the others.
template <class Arguments, std::size_t... i>
void mix(std::vector<Arguments>& calls, const Arguments& first, const Arguments& second,
         std::index_sequence<i...>)
{
    const auto exchange = [&]<std::size_t k>(std::integral_constant<std::size_t, k>) {
        using T = std::tuple_element_t<k, Arguments>;
        if constexpr (Plain<T> ? !std::is_same_v<T, TetrahedralMesh> && !std::is_same_v<T, LevelSet>
                               : !requires(T t) {
                                     t.resize(1);
                                     t.push_back(t[0]);
                                 }) {
            Arguments call = first;
            std::get<k>(call) = std::get<k>(second);
            calls.push_back(call);
        }
    };
    (exchange(std::integral_constant<std::size_t, i>()), ...);
}

template <FormulaIndex f, auto& formula> void check_memory()
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    using Call = Arguments<formula>;
    for (unsigned seed : seeds(10)) {
        const Call first = random_arguments<f, formula>(seed),
                   second = random_arguments<f, formula>(seed + 7000),
                   other = random_arguments<f, formula>(seed + 8000);
        std::vector<Call> calls = {second};
        mix(calls, first, second, std::make_index_sequence<std::tuple_size_v<Call>>());
        for (const Call& call : calls) {
            std::apply(formula, other);
            const auto expected = std::apply(formula, call);
            std::apply(formula, other);
            std::apply(formula, first);
            auto again = std::apply(formula, call);
            choose_as(again, expected, of.result);
            INFO("the same call, after another call");
            const auto& should = comparable(expected);
            REQUIRE_THAT(comparable(again), IsClose(should, universal(should)));
        }
    }
}

#define RIGOR_ROW(tag, topic, function, ...)                                                       \
    const bool memory_of_##function =                                                              \
        add_test(&check_memory<FormulaIndex::function, rigor::function>,                           \
                 #topic ": " #function " remembers nothing", "[" #tag "][" #topic "]");
RIGOR_FORMULAS(RIGOR_ROW)
#undef RIGOR_ROW

} // namespace

} // namespace rigor::testing
