// SPDX-License-Identifier: MIT
// Comparison of values with a tolerance that has a class. A NaN is never close to anything, and
// nothing is close by a tolerance that is not finite.
//
//     REQUIRE_THAT(world_inertia(R, I), IsClose(expected, Rounding(16)));
//
// Values (support/values/components.hpp) are compared component by component, and the message names
// one that is wrong. Every tolerance has a class, R, O, S or I, as described below. Comments also
// speak of class B, a bracket, which has no tolerance: the test checks that an outcome is one thing
// just below a limit and the other just above it.
#pragma once

#include "support/catch.hpp"
#include "support/values/components.hpp"
#include "support/verdict.hpp"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::testing {

/// A bound on the absolute difference of each component.
struct Tolerance {
    std::string tolerance_class; // "R", "O", "S", "I"
    double absolute = 0;         // the bound itself, or
    double relative = 0;         // a factor of the norm of the expected field
    // How the bound was made, for the message of a failure: "{} eps x {:.3g}" and its two numbers.
    // It becomes a text only then, since nearly all comparisons succeed.
    const char* format = "";
    double k = 0, scale = 0;
};

/// Class R, rounding: k eps times `scale`, the sum of the magnitudes of the terms.
Tolerance Rounding(double k, double scale);

/// Class R with the norm of each expected field as its scale. An expected 0 must be met exactly.
Tolerance Rounding(double k);

/// Class O: the upper bound of an error that falls with the step. `check_order` checks the order.
Tolerance Order(double cap);

/// Class S: 5 σ / √N, with σ of one sample and a fixed seed.
Tolerance Statistical(double sigma, double n);

/// Class R without any rounding: the values have the same bits.
Tolerance Exactly();

/// How two values differ.
struct Difference {
    // `unbounded`: the bound is not finite, so the comparison would accept anything
    enum Kind { none, size, not_finite, unbounded, number } kind = none;
    std::size_t index = 0;       // the number that exceeds its bound most, or is not finite
    double error = 0, bound = 0; // error and bound of that number
    std::string place;           // "inertia(0, 1)"
};

/// The difference between two values, without its place.
Difference difference_between(const Components& actual, const Components& expected,
                              const Tolerance& tolerance);

/// Fills in the verdict of the test case, if this is its first failure.
void note_difference(const Difference& difference, const ReadableComponents& actual,
                     const ReadableComponents& expected, const Tolerance& tolerance);

/// Compares two values. If they differ, this fills in the verdict of the test case.
template <class T>
Difference compare(const T& actual, const T& expected, const Tolerance& tolerance)
{
    const Components found = components(actual), wanted = components(expected);
    Difference difference = difference_between(found, wanted, tolerance);
    if (difference.kind == Difference::none) return difference;
    difference.place =
        difference.kind == Difference::size ? "its size" : component_name(actual, difference.index);
    note_difference(difference, {found, component_text(actual)}, {wanted, component_text(expected)},
                    tolerance);
    return difference;
}

/// The text of a failure. @param expected  the expected value as text
std::string describe(const std::string& expected, const Tolerance& tolerance,
                     const Difference& difference);

template <class T> class CloseMatcher : public Matcher<T> {
public:
    CloseMatcher(const T& expected, Tolerance tolerance)
        : expected_(expected), tolerance_(std::move(tolerance))
    {
    }
    bool match(const T& actual) const override
    {
        difference_ = compare(actual, expected_, tolerance_);
        return difference_.kind == Difference::none;
    }

protected:
    std::string describe() const override
    {
        const std::string text = component_text(expected_);
        return rigor::testing::describe(text.empty() ? components(expected_).shape : text,
                                        tolerance_, difference_);
    }

private:
    T expected_;
    Tolerance tolerance_;
    mutable Difference difference_; // result of the last match, for the message
};

/// The plain type behind an Eigen expression, or the type itself.
template <class T> struct Evaluated {
    using type = T;
};
template <class T>
requires requires
{
    typename T::PlainObject;
}
struct Evaluated<T> {
    using type = typename T::PlainObject;
};

template <class T>
CloseMatcher<typename Evaluated<T>::type> IsClose(const T& expected, const Tolerance& tolerance)
{
    return {expected, tolerance};
}

/// Matches exactly the same value: for bools, indices, empty optionals, and values that must not
/// change.
template <class T> CloseMatcher<typename Evaluated<T>::type> IsExactly(const T& expected)
{
    return {expected, Exactly()};
}

/// Whether the numbers of two values are close. If so, this counts as a check that has passed.
bool are_close(const Components& actual, const Components& expected, const Tolerance& tolerance);

/// REQUIRE_THAT(actual, IsClose(expected, tolerance)) with a note for the failure. As a function it
/// keeps the laws, which are compiled for each formula, short.
template <class T>
[[gnu::noinline]] void require_close(const T& actual, const T& expected, const Tolerance& tolerance,
                                     std::string_view note)
{
    if (are_close(components(actual), components(expected), tolerance)) return;
    INFO(note);
    REQUIRE_THAT(actual, IsClose(expected, tolerance));
}

/// RᵀR = δ and det R = +1, to 128 eps.
class RotationMatcher : public Matcher<Matrix3d> {
public:
    bool match(const Matrix3d& R) const override;

protected:
    std::string describe() const override;

private:
    mutable Difference difference_;
};
inline RotationMatcher IsRotation()
{
    return {};
}

/// Class O: errors at the steps h, h/2, h/4 … fall by a factor of 2^order each. The measured order
/// must lie within -0.2/+0.3 of `order` as long as the errors are above 1e3 eps. At least one pair
/// must be above this.
void check_order(const std::vector<double>& errors, double order);

/// Class I, an inequality: value ≤ limit, with a slack of 4 eps times `scale`.
/// @param what  the value in words; if the limit is another value, its name follows after ", by":
///              "|j_T|, by μ jₙ"
void check_at_most(double value, double limit, const std::string& what, double scale = 1);

/// The same for value ≥ limit.
void check_at_least(double value, double limit, const std::string& what, double scale = 1);

} // namespace rigor::testing

/// Prints a value as its numbers.
template <class T>
requires(rigor::Plain<T> ||
         requires(T t) { t.colPivHouseholderQr(); }) struct Catch::StringMaker<T> {
    static std::string convert(const T& value) { return rigor::testing::component_text(value); }
};
