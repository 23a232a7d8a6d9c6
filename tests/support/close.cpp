// SPDX-License-Identifier: MIT
// Comparison of values with a tolerance, component by component. A component that is not finite
// fails at once. Otherwise the component that exceeds its bound most is reported. The first failure
// of a test case goes into its verdict.
#include "support/close.hpp"

#include "support/largest_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

// A value in short, followed by its wrong component in full.
std::string with_component(const Components& value, const Component& component)
{
    if (value.numbers.size() == 1) return number(component.value);
    return fmt::format("{}; {}: {}", value.text, component.place, number(component.value));
}

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

double& largest_error_in_tolerances()
{
    static double largest = 0;
    return largest;
}

Tolerance Rounding(double k, double scale)
{
    return {"R", k * eps * scale, 0, fmt::format("{} eps x {:.3g}", k, scale)};
}

Tolerance Rounding(double k)
{
    return {"R", 0, k * eps, fmt::format("{} eps x its norm", k)};
}

Tolerance Order(double cap)
{
    return {"O", cap, 0, fmt::format("cap {:.3g}", cap)};
}

Tolerance Statistical(double sigma, double n)
{
    return {"S", 5 * sigma / std::sqrt(n), 0, fmt::format("5 x {:.3g} / sqrt({})", sigma, n)};
}

Tolerance Exactly()
{
    return {"R", 0, 0, "the same value"};
}

void Components::add(const std::string& place, const double* data, int rows, int columns)
{
    constexpr std::size_t longest = 600;
    const bool room = text.size() < longest;
    double norm = 0;
    for (int i = 0; i < rows * columns; ++i)
        norm = std::hypot(norm, data[i]);
    if (room && !place.empty()) text += (text.empty() ? "" : "  ") + place + " ";
    if (room && rows * columns > 1) text += "(";
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double value = data[row + rows * column];
            std::string where = place;
            if (columns > 1)
                where += fmt::format("({}, {})", row, column);
            else if (rows > 1)
                where += fmt::format("({})", row);
            numbers.push_back({where, value, norm});
            if (!room) continue;
            if (column > 0) text += " ";
            if (column == 0 && row > 0) text += columns > 1 ? "; " : ", ";
            text += fmt::format("{:.6g}", value);
        }
    if (room && rows * columns > 1) text += ")";
    if (room && text.size() >= longest) text += " …";
}

Difference compare(const Components& actual, const Components& expected, const Tolerance& tolerance)
{
    const auto& found = actual.numbers;
    const auto& wanted = expected.numbers;
    if (actual.shape != expected.shape || found.size() != wanted.size()) {
        const Difference difference = {true, "its size", infinity, 0};
        note("failed", expected.shape + expected.text, actual.shape + actual.text,
             tolerance.tolerance_class, difference);
        return difference;
    }
    Difference worst;
    std::size_t at = 0;
    double worst_excess = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double a = found[i].value, e = wanted[i].value;
        const double bound =
            tolerance.absolute > 0 ? tolerance.absolute : tolerance.relative * wanted[i].scale;
        if (!std::isfinite(a) && !(a == e)) { // fails at any tolerance
            const Difference difference = {true, found[i].place, infinity, bound};
            note("not_finite", expected.text, actual.text, tolerance.tolerance_class, difference);
            return difference;
        }
        const double error = a == e ? 0 : std::abs(a - e);
        if (error == 0 || error <= bound) { // 0 also for ∞ = ∞, where the bound may be NaN
            note_error(error, bound);
            continue;
        }
        const double excess = bound > 0 ? error / bound : infinity;
        if (worst.any && (excess < worst_excess || error <= worst.error)) continue;
        worst = {true, found[i].place, error, bound};
        worst_excess = excess;
        at = i;
    }
    if (worst.any)
        note("failed", with_component(expected, wanted[at]), with_component(actual, found[at]),
             tolerance.tolerance_class, worst);
    return worst;
}

std::string describe(const Components& expected, const Tolerance& tolerance,
                     const Difference& difference)
{
    const std::string should = expected.text.empty() ? expected.shape : expected.text;
    std::string text = fmt::format("should be {} (class {}, {})", should, tolerance.tolerance_class,
                                   tolerance.reason);
    if (difference.any)
        text += fmt::format("; error {:.3g} > {:.3g}{}", difference.error, difference.bound,
                            difference.place.empty() ? "" : " in " + difference.place);
    return text;
}

bool RotationMatcher::match(const Matrix3d& R) const
{
    const Matrix3d RtR = R.transpose() * R;
    const Tolerance tolerance = Rounding(16, 1);
    difference_ = compare(components(RtR), components(Matrix3d(Matrix3d::Identity())), tolerance);
    if (!difference_.any)
        difference_ = compare(components(R.determinant()), components(1.0), tolerance);
    return !difference_.any;
}

std::string RotationMatcher::describe() const
{
    return fmt::format(
        "should be a rotation: RᵀR = δ and det R = 1 (class R, 16 eps); error {:.3g}",
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
                 fmt::format("order {:.3f}", found), "O", {true, "", order - found, below});
        if (!(found <= order + above))
            note("failed", fmt::format("order {}, at most {:.1f}", order, order + above),
                 fmt::format("order {:.3f}", found), "O", {true, "", found - order, above});
        REQUIRE(found >= order - below);
        REQUIRE(found <= order + above);
        ++pairs;
    }
    INFO("no error is above rounding: the order cannot be seen");
    REQUIRE(pairs > 0);
}

namespace {

// A value that must be on one side of a limit.
struct Bounded {
    double value, excess; // by how much the value is beyond the limit
    std::string law;      // "jₙ at least 0"
};

void check_bound(const Bounded& bounded, double scale)
{
    const auto& [value, excess, law] = bounded;
    const double slack = 4 * eps * scale;
    const bool finite = std::isfinite(value), holds = finite && excess <= slack;
    if (holds) note_error(excess, slack);
    if (!holds)
        note(finite ? "failed" : "not_finite", law, number(value), "I",
             {true, "", finite ? excess : value, slack});
    INFO(law);
    CAPTURE(value);
    REQUIRE(finite);
    REQUIRE(holds);
}

} // namespace

void check_at_most(double value, double limit, const std::string& what, double scale)
{
    check_bound({value, value - limit, what + " at most " + number(limit)}, scale);
}

void check_at_least(double value, double limit, const std::string& what, double scale)
{
    check_bound({value, limit - value, what + " at least " + number(limit)}, scale);
}

} // namespace rigor::testing
