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

/// Requires that the answer `found` is close to the one that other answers predict. If it is not
/// and there is a reference, the failure shows the call whose answer is farthest from that of the
/// reference. Otherwise it says that the expected value is a prediction.
///
/// @param calls  calls() returns the arguments of all calls whose answers were used, in a vector
/// @param law    what the law says of these answers, without a full stop
template <auto& formula, class Result, class Calls>
void require_predicted(const Result& found, const Result& predicted, const Tolerance& tolerance,
                       const Calls& calls, const std::string& law)
{
    const Difference difference =
        difference_between(components(found), components(predicted), tolerance);
    if (difference.kind != Difference::none && difference.kind != Difference::unbounded &&
        oracle()) {
        const auto all = calls();
        const auto* worst = all.data();
        double largest = difference.bound / 4; // a smaller error does not explain the failure
        for (const auto& call : all) {
            const double error = largest_difference(
                std::apply(formula, call), by_reference([&] { return std::apply(formula, call); }));
            if (!(error > largest)) continue;
            worst = &call;
            largest = error;
        }
        INFO(law + "; of the calls that were compared, the one shown here has the answer that is "
                   "farthest from the right one");
        const auto right = by_reference([&] { return std::apply(formula, *worst); });
        REQUIRE_THAT(std::apply(formula, *worst), IsClose(right, Order(difference.bound / 4)));
    }
    INFO(law + "; the expected value follows in this way from answers to other calls, which may be "
               "wrong themselves");
    REQUIRE_THAT(found, IsClose(predicted, tolerance));
}

} // namespace rigor::testing
