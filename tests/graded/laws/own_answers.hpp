// SPDX-License-Identifier: MIT
// Some laws predict an answer of a formula from its answers to other calls. If the law is broken,
// one of these answers is wrong, but the law does not say which one.
#pragma once

#include "formulas/quantities.hpp"
#include "support/close.hpp"
#include "worker/proxy/proxy.hpp"

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace rigor::testing {

/// Eight times the rounding error of the worst solution known, which inverts a matrix of condition
/// 100 and multiplies by it.
constexpr double rounding = 0x1p-41;

/// The largest difference between the numbers of two results; infinity if they differ in shape.
template <class Result> double largest_difference(const Result& a, const Result& b)
{
    const Components left = components(a), right = components(b);
    if (left.shape != right.shape || left.numbers.size() != right.numbers.size()) return INFINITY;
    double largest = 0;
    for (std::size_t i = 0; i < left.numbers.size(); ++i)
        if (left.numbers[i] != right.numbers[i])
            largest = std::max(largest, std::abs(left.numbers[i] - right.numbers[i]));
    return largest;
}

/// Shows the call whose answer is farthest from that of the reference, if it is farther than a
/// quarter of `bound`: a smaller error does not explain the failure.
template <auto& formula, class Call>
void require_worst(const std::vector<Call>& calls, double bound, const std::string& law)
{
    const Call* worst = calls.data();
    double largest = bound / 4;
    for (const Call& call : calls) {
        const double error = largest_difference(
            std::apply(formula, call), by_reference([&] { return std::apply(formula, call); }));
        if (!(error > largest)) continue;
        worst = &call;
        largest = error;
    }
    const auto right = by_reference([&] { return std::apply(formula, *worst); });
    require_close(std::apply(formula, *worst), right, Order(bound / 4),
                  law + "; of the calls that were compared, the one shown here has the answer that "
                        "is farthest from the right one");
}

/// Requires that the answer `found` is close to the one that other answers predict. If it is not
/// and there is a reference, the failure shows the call whose answer is farthest from that of the
/// reference. Otherwise it says that the expected value is a prediction.
///
/// @param calls  calls() returns the arguments of all calls whose answers were used, in a vector
/// @param law    law() says what the law says of these answers, without a full stop
template <auto& formula, class Result, class Calls, class Law>
void require_predicted(const Result& found, const Result& predicted, const Tolerance& tolerance,
                       const Calls& calls, const Law& law)
{
    const Components numbers = components(found), wanted = components(predicted);
    if (are_close(numbers, wanted, tolerance)) return;
    const Difference difference = difference_between(numbers, wanted, tolerance);
    if (difference.kind != Difference::unbounded && oracle())
        require_worst<formula>(calls(), difference.bound, law());
    require_close(found, predicted, tolerance,
                  law() + "; the expected value follows in this way from answers to other calls, "
                          "which may be wrong themselves");
}

} // namespace rigor::testing
