// SPDX-License-Identifier: MIT
// The formula that a test of topic `validation` examines, and the judgement of the test about it.
//
// The formula itself stays with the grader, in another process, so that a test can learn nothing
// about it but its results. A test is a function of the results that are known so far. If a test
// needs a result that is not known yet, an exception ends the test and passes the question to the
// grader. The grader answers the question, and the test begins again with one more known result.
// So a test must make the same calls whenever it gets the same results.
#pragma once

#include "formulas/fields.hpp"

#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace rigor {

/// One call of a formula under test: the numbers of its arguments and those of its result, in the
/// order of the declaration, each vector component by component.
struct KnownCall {
    std::vector<double> arguments, result;
};

/// The exception by which a test asks for a result that is not known yet. The test must not catch
/// it: otherwise the grader does not see the question, and takes what the test returns as its
/// judgement.
struct UnknownCall {
    int calls_before = 0;
    std::vector<double> arguments;
};

/// The judgement of a test about its formula. See `accepted` and `rejected`.
struct Judgement {
    int rejected_in = 0; // the line of the test that rejected the formula, 0 if it was accepted
    // If the test was ended by an UnknownCall: the number of calls before the unknown one, and the
    // arguments of the unknown one.
    int calls_before = 0;
    std::vector<double> question;
};

/// The judgement that the formula keeps all laws that the test knows: `return accepted();`
inline Judgement accepted()
{
    return {};
}

/// The judgement that the formula breaks a law: `return rejected(); // the momentum changes`. If
/// the formula was in fact right, the report names the line of this `rejected()`.
inline Judgement rejected(int line = __builtin_LINE())
{
    return {line, 0, {}};
}

namespace numbers {

/// Appends the numbers that `value` consists of to the list `to`.
template <class T> void append(std::vector<double>& to, const T& value)
{
    if constexpr (std::is_same_v<T, double>)
        to.push_back(value);
    else if constexpr (Plain<T>)
        Fields<T>::each(value, [&](std::string_view, const auto& field) { append(to, field); });
    else
        to.insert(to.end(), value.data(), value.data() + value.size());
}

/// Reads `value` from the numbers, beginning at index `at`, and moves `at` behind the last number
/// that was read. If `value` is a list, it takes all remaining numbers.
template <class T> void take(T& value, const std::vector<double>& from, std::size_t& at)
{
    if constexpr (std::is_same_v<T, double>) {
        value = from.at(at++);
    } else if constexpr (Plain<T>) {
        Fields<T>::each(value, [&](std::string_view, auto& field) { take(field, from, at); });
    } else if constexpr (std::is_same_v<T, std::vector<double>>) {
        value.assign(from.begin() + static_cast<std::ptrdiff_t>(at), from.end());
        at = from.size();
    } else {
        for (int i = 0; i < static_cast<int>(value.size()); ++i)
            value[i] = from.at(at++);
    }
}

template <class T> T taken(const std::vector<double>& from)
{
    T value{};
    std::size_t at = 0;
    take(value, from, at);
    return value;
}

} // namespace numbers

/// A formula under test. It is called like a function, with finite arguments.
template <class Result, class... Argument> class UnderTest {
public:
    std::vector<KnownCall> known; // in the order in which the test makes the calls

    Result operator()(const Argument&... argument) const
    {
        std::vector<double> arguments;
        (numbers::append(arguments, argument), ...);
        for (const double number : arguments)
            if (!std::isfinite(number))
                throw std::invalid_argument("the test calls the formula with a number that is "
                                            "not finite");
        if (calls_ == known.size() || known[calls_].arguments != arguments)
            throw UnknownCall{static_cast<int>(calls_), arguments};
        return numbers::taken<Result>(known[calls_++].result);
    }

private:
    mutable std::size_t calls_ = 0;
};

RIGOR_FIELDS(KnownCall, arguments, result)
RIGOR_FIELDS(Judgement, rejected_in, calls_before, question)
template <class Result, class... Argument> struct Fields<UnderTest<Result, Argument...>> {
    using listed = void;
    template <class Value, class Visit> static void each(Value& value, Visit&& visit)
    {
        RIGOR_FIELD(known)
    }
};

} // namespace rigor
