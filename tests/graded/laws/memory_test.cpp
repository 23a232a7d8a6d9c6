// SPDX-License-Identifier: MIT
// The law of no memory, for every formula: an answer depends on the arguments alone, and not on the
// calls before. Each call is made after one that has nothing in common with it, and after one that
// differs in a single argument, in a list by a single element, or in a single part of an argument,
// such as the sign of one number.
#include "add_law.hpp"
#include "change.hpp"
#include "one_change.hpp"
#include "support/seeds.hpp"
#include "support/sweep.hpp"

#include <type_traits>

namespace rigor::testing {

namespace {

template <class T>
concept List = requires(T list)
{
    list.resize(1);
    list.push_back(list[0]);
};

// What a list takes from the same list of another call: everything, or one element. All random
// meshes have the same tetrahedra, so faces and cracks fit every mesh. Flags, levels and neighbors
// refer to their own call, so such a list changes one element of its own instead. Contacts refer to
// their bodies and take nothing.
enum class Exchange { everything, element, own, nothing };

template <class Element> constexpr Exchange exchange_of()
{
    if (std::is_same_v<Element, MeshFace> || std::is_same_v<Element, ElementCrack>)
        return Exchange::everything;
    if (std::is_same_v<Element, BodyContact>) return Exchange::nothing;
    if (std::is_same_v<Element, bool> || std::is_same_v<Element, int> ||
        std::is_same_v<Element, std::vector<int>>)
        return Exchange::own;
    if (std::is_same_v<Element, double> || Plain<Element> ||
        requires(Element matrix) { matrix.colPivHouseholderQr(); })
        return Exchange::element;
    return Exchange::nothing;
}

// Changes an element so that it stays valid. Level 0 belongs to static bodies.
template <class Element> Element other_element(const Element& element)
{
    if constexpr (std::is_same_v<Element, bool>)
        return !element;
    else if constexpr (std::is_same_v<Element, int>)
        return element > 0 ? element + 1 : element;
    else
        return {};
}

// Changes a single element of a list, one near its middle that can change.
template <class T> void change_one(T& list)
{
    const std::size_t count = list.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t e = (count / 2 + i) % count;
        const auto other = other_element<typename T::value_type>(list[e]);
        if (other == list[e]) continue;
        list[e] = other;
        return;
    }
}

// The first arguments with one of them taken from the second, for each argument that does not refer
// to the others. Most lists get a single element, in their middle, so that their length, their
// first and their last element stay the same.
template <class Arguments, std::size_t... i>
void mix(std::vector<Arguments>& calls, const Arguments& first, const Arguments& second,
         std::index_sequence<i...>)
{
    const auto exchange = [&]<std::size_t k>(std::integral_constant<std::size_t, k>) {
        using T = std::tuple_element_t<k, Arguments>;
        Arguments call = first;
        auto& argument = std::get<k>(call);
        const auto& other = std::get<k>(second);
        if constexpr (!List<T>) {
            argument = other;
        } else {
            constexpr Exchange part = exchange_of<typename T::value_type>();
            if constexpr (part == Exchange::nothing) return;
            if constexpr (part == Exchange::everything) argument = other;
            if constexpr (part == Exchange::own) change_one(argument);
            if constexpr (part == Exchange::element)
                if (!argument.empty() && !other.empty())
                    argument[argument.size() / 2] = other.front();
        }
        calls.push_back(call);
    };
    (exchange(std::integral_constant<std::size_t, i>()), ...);
}

// Compares the results of the same call after two different ones. They have the same bits, apart
// from sums over the tetrahedra of a mesh, which may be in any order.
template <class Result> void check_again(Result again, const Result& expected, const Quantity& q)
{
    choose_as(again, expected, q);
    const auto& should = comparable(expected);
    const bool is_same = std::is_same_v<std::remove_cvref_t<decltype(should)>, Result>;
    require_close(comparable(again), should, is_same ? Exactly() : universal(should),
                  "the expected value is the formula's own answer to this call before; either may "
                  "be wrong");
}

// Compares the result of a call with that of the same call in other units. An answer that is kept
// for good may be wrong whenever the call is repeated, but the call in other units is a new one.
template <FormulaIndex f, auto& formula, class Result>
void check_in_other_units(Arguments<formula> call, const Result& expected)
{
    if constexpr (has_units(f)) {
        const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
        const Change units = {Dimension{4, 2, -2}};
        change_arguments(call, of, units);
        Result found = changed(std::apply(formula, call), of.result, units.undone());
        choose_as(found, expected, of.result);
        const auto& should = comparable(expected);
        require_close(
            comparable(found), should, universal(should),
            "the same call in other units, after another call that differs in a single part");
    }
}

// Makes two calls that differ in a single part, directly one after the other, in both orders.
template <FormulaIndex f, auto& formula> void check_memory_of_parts()
{
    const Quantity& result = formula_quantities[static_cast<unsigned>(f)].result;
    for (unsigned seed : seeds(sampled(5))) {
        Random random(seed);
        const Arguments<formula> first = random_arguments<f, formula>(seed),
                                 other = random_arguments<f, formula>(seed + 8000);
        std::apply(formula, other);
        const auto of_first = std::apply(formula, first);
        for (const Arguments<formula>& call : with_one_change<f>(first, 64, random)) {
            std::apply(formula, other);
            const auto expected = std::apply(formula, call);
            check_in_other_units<f, formula>(call, expected);
            INFO("the same call, after another call that differs from it in a single part");
            check_again(std::apply(formula, first), of_first, result);
            check_again(std::apply(formula, call), expected, result);
        }
    }
}

template <FormulaIndex f, auto& formula> void check_memory()
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    using Call = Arguments<formula>;
    for (unsigned seed : seeds(sampled(10))) {
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
            INFO("the same call, after another call");
            check_again(std::apply(formula, call), expected, of.result);
        }
    }
}

struct Memory {
    static constexpr const char* words = "remembers nothing";
    static constexpr bool holds_for(FormulaIndex) { return true; }
    template <FormulaIndex f, auto& formula> static void check()
    {
        check_memory<f, formula>();
        check_memory_of_parts<f, formula>();
    }
};

[[maybe_unused]] const bool added_memory = add_law<Memory>();

} // namespace

} // namespace rigor::testing
