// SPDX-License-Identifier: MIT
// Comparison of values with a tolerance, component by component. A component that is not finite
// fails at once, and so does one whose bound is not finite: such a bound comes from numbers so
// large that their norm is not finite, and would accept anything. Otherwise the component that
// exceeds its bound most is reported, or of several with the bound 0 the one with the largest
// error. The first failure in a test case goes into its verdict.
#include "support/close.hpp"

#include "support/largest_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor::testing {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

// The shortest text that reads back as the same number.
std::string number(double value)
{
    return fmt::format("{}", value);
}

void note(const std::string& status, const std::string& expected, const std::string& actual,
          const std::string& tolerance_class, const Difference& difference)
{
    Verdict& v = verdict();
    if (!v.status.empty()) return; // only the first failure is reported
    v.status = status;
    v.expected = expected;
    v.actual = actual;
    v.error = difference.error;
    v.tolerance = difference.bound;
    v.tolerance_class = tolerance_class;
    v.place = difference.place;
}

void note_error(double error, double tolerance)
{
    double& largest = largest_error_in_tolerances();
    if (tolerance > 0) largest = std::max(largest, error / tolerance);
}

constexpr double infinity = std::numeric_limits<double>::infinity();

// The bound of number i; not finite if the numbers that it comes from are too large for a norm.
double bound_of(const Tolerance& tolerance, const Components& expected, std::size_t i)
{
    if (tolerance.absolute != 0) return tolerance.absolute;
    return tolerance.relative == 0 ? 0 : tolerance.relative * expected.scale(i);
}

} // namespace

double& largest_error_in_tolerances()
{
    static double largest = 0;
    return largest;
}

Tolerance Rounding(double k, double scale)
{
    return {"R", k * eps * scale, 0, "{} eps x {:.3g}", k, scale};
}

Tolerance Rounding(double k)
{
    return {"R", 0, k * eps, "{} eps x its norm", k};
}

Tolerance Order(double cap)
{
    return {"O", cap, 0, "cap {:.3g}", cap};
}

Tolerance Statistical(double sigma, double n)
{
    return {"S", 5 * sigma / std::sqrt(n), 0, "5 x {:.3g} / sqrt({})", sigma, n};
}

Tolerance Exactly()
{
    return {"R", 0, 0, "the same value"};
}

Difference difference_between(const Components& actual, const Components& expected,
                              const Tolerance& tolerance)
{
    if (actual.shape != expected.shape || actual.numbers.size() != expected.numbers.size())
        return {Difference::size, 0, infinity, 0, {}};
    Difference worst;
    double worst_excess = 0;
    const bool is_bounded = std::isfinite(tolerance.absolute);
    for (std::size_t i = 0; i < actual.numbers.size(); ++i) {
        const double a = actual.numbers[i], e = expected.numbers[i];
        if (a == e && is_bounded) continue; // also for ∞ = ∞
        const double bound = bound_of(tolerance, expected, i);
        if (!std::isfinite(a)) // fails at any tolerance
            return {Difference::not_finite, i, infinity, bound, {}};
        const double error = std::abs(a - e);
        if (!std::isfinite(bound)) return {Difference::unbounded, i, error, bound, {}};
        if (error <= bound) {
            note_error(error, bound);
            continue;
        }
        const double excess = bound > 0 ? error / bound : infinity;
        if (std::pair(excess, error) <= std::pair(worst_excess, worst.error)) continue;
        worst = {Difference::number, i, error, bound, {}};
        worst_excess = excess;
    }
    return worst;
}

bool are_close(const Components& actual, const Components& expected, const Tolerance& tolerance)
{
    if (difference_between(actual, expected, tolerance).kind != Difference::none) return false;
    SUCCEED();
    return true;
}

namespace {

// What a verdict says of one of two values that differ: the value in short, followed by its wrong
// number in full.
std::string in_verdict(const ReadableComponents& value, const Difference& difference)
{
    if (difference.kind == Difference::size) return value.parts.shape + value.text;
    if (difference.kind == Difference::not_finite) return value.text;
    const std::string wrong = number(value.parts.numbers[difference.index]);
    if (value.parts.numbers.size() == 1) return wrong;
    return fmt::format("{}; {}: {}", value.text, difference.place, wrong);
}

} // namespace

void note_difference(const Difference& difference, const ReadableComponents& actual,
                     const ReadableComponents& expected, const Tolerance& tolerance)
{
    note(difference.kind == Difference::not_finite ? "not_finite" : "failed",
         in_verdict(expected, difference), in_verdict(actual, difference),
         tolerance.tolerance_class, difference);
}

std::string describe(const std::string& expected, const Tolerance& tolerance,
                     const Difference& difference)
{
    std::string text =
        fmt::format("should be {} (class {}, {})", expected, tolerance.tolerance_class,
                    fmt::format(fmt::runtime(tolerance.format), tolerance.k, tolerance.scale));
    const std::string place = difference.place.empty() ? "" : " in " + difference.place;
    if (difference.kind == Difference::unbounded)
        text += "; nothing is accepted, since the tolerance is not finite: the numbers that it "
                "comes from are too large" +
                place;
    else if (difference.kind != Difference::none)
        text += fmt::format("; error {:.3g} > {:.3g}{}", difference.error, difference.bound, place);
    return text;
}

bool RotationMatcher::match(const Matrix3d& R) const
{
    const Matrix3d RtR = R.transpose() * R;
    const Tolerance tolerance = Rounding(128, 1); // eigenvectors are off by up to 7 eps
    difference_ = compare(RtR, Matrix3d(Matrix3d::Identity()), tolerance);
    if (difference_.kind == Difference::none)
        difference_ = compare(R.determinant(), 1.0, tolerance);
    return difference_.kind == Difference::none;
}

std::string RotationMatcher::describe() const
{
    return fmt::format(
        "should be a rotation: RᵀR = δ and det R = 1 (class R, 128 eps); error {:.3g}",
        difference_.error);
}

void check_order(const std::vector<double>& errors, double order)
{
    REQUIRE(errors.size() >= 2);
    // The error of a finite step has terms of higher order too. With the step sizes of our tests
    // they change the order by less than this; a method of another order is off by 1.
    constexpr double below = 0.2, above = 0.3;
    constexpr double rounding = 1e3 * eps; // an error that rounding makes shows no order
    int pairs = 0;
    CAPTURE(order);
    for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
        CAPTURE(errors[i], errors[i + 1]);
        REQUIRE(std::isfinite(errors[i]));
        REQUIRE(std::isfinite(errors[i + 1]));
        if (errors[i + 1] <= rounding) break;
        const double found = std::log2(errors[i] / errors[i + 1]);
        if (!(found >= order - below))
            note("failed", fmt::format("order {}, at least {:.1f}", order, order - below),
                 fmt::format("order {:.3f}", found), "O",
                 {Difference::number, 0, order - found, below, ""});
        if (!(found <= order + above))
            note("failed", fmt::format("order {}, at most {:.1f}", order, order + above),
                 fmt::format("order {:.3f}", found), "O",
                 {Difference::number, 0, found - order, above, ""});
        REQUIRE(found >= order - below);
        REQUIRE(found <= order + above);
        ++pairs;
    }
    INFO("no error is above rounding: the order cannot be seen");
    REQUIRE(pairs > 0);
}

namespace {

// Checks that a value exceeds a limit by no more than the slack.
// @param law  the law as text, computed only if it is broken: "jₙ at least 0"
template <class Law> void check_bound(double value, double excess, double scale, const Law& law)
{
    const double slack = 4 * eps * scale;
    // An excess or a slack that is not finite comes from numbers that are too large.
    const bool finite = std::isfinite(value),
               is_bounded = std::isfinite(excess) && std::isfinite(slack);
    if (finite && is_bounded && excess <= slack) {
        note_error(excess, slack);
        SUCCEED(); // so that Catch2 counts the comparison
        return;
    }
    note(finite ? "failed" : "not_finite", law(), number(value), "I",
         {Difference::number, 0, finite ? excess : value, slack, ""});
    INFO(law() + (is_bounded || !finite ? ""
                                        : "; nothing is accepted, since the limit or its "
                                          "tolerance is not finite"));
    CAPTURE(value);
    REQUIRE(finite);
    REQUIRE(excess <= slack);
    REQUIRE(is_bounded);
}

} // namespace

void check_at_most(double value, double limit, const std::string& what, double scale)
{
    check_bound(value, value - limit, scale, [&] { return what + " at most " + number(limit); });
}

void check_at_least(double value, double limit, const std::string& what, double scale)
{
    check_bound(value, limit - value, scale, [&] { return what + " at least " + number(limit); });
}

} // namespace rigor::testing
