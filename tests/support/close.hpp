// SPDX-License-Identifier: MIT
// Comparison of values with a tolerance that has a class. A NaN is never close to anything.
//
//     REQUIRE_THAT(world_inertia(R, I), IsClose(expected, Rounding(16)));
//
// Values are doubles, integers, bools, fixed Eigen matrices, the plain structs of
// formulas/fields.hpp, and optionals, arrays and vectors of these. They are compared component by
// component, and the message names the worst one.
#pragma once

#include "formulas/fields.hpp"
#include "support/catch.hpp"
#include "support/verdict.hpp"

#include <initializer_list>
#include <string>
#include <vector>

namespace rigor::testing {

/// A bound on the absolute difference of each component.
struct Tolerance {
    std::string tolerance_class; // "R", "O", "S", "I"
    double absolute = 0;         // the bound itself, or
    double relative = 0;         // a factor of the norm of the expected field
    std::string reason;          // "16 eps × 2.5"
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

/// One number of a value, and its place in the value.
struct Component {
    std::string place; // "inertia(0, 1)"
    double value = 0;
    double scale = 0; // the norm of the field it belongs to
};

/// The numbers of a value. An empty optional has none, and `shape` says so.
struct Components {
    std::vector<Component> numbers;
    // sizes of vectors and presence of optionals, which must agree before numbers are compared
    std::string shape;
    std::string text; // to be read: vectors as (1, 2, 3), matrices by rows (1 2; 3 4)
    void add(const std::string& place, const double* data, int rows, int columns);
};

template <class T> struct IsOptional : std::false_type {
};
template <class T> struct IsOptional<std::optional<T>> : std::true_type {
};

template <class T> void take_apart(const T& value, const std::string& place, Components& parts)
{
    if constexpr (Plain<T>) {
        Fields<T>::each(value, [&](std::string_view name, const auto& field) {
            take_apart(field, place + (place.empty() ? "" : ".") + std::string(name), parts);
        });
    } else if constexpr (IsOptional<T>::value) {
        parts.shape += value ? "a value " : "empty ";
        if (!value) parts.text += "empty";
        if (value) take_apart(*value, place, parts);
    } else if constexpr (std::is_arithmetic_v<T>) {
        const double number = static_cast<double>(value);
        parts.add(place, &number, 1, 1);
    } else if constexpr (requires { value.colPivHouseholderQr(); }) {
        const auto& matrix = value.eval();
        parts.add(place, matrix.data(), static_cast<int>(matrix.rows()),
                  static_cast<int>(matrix.cols()));
    } else {
        parts.shape += std::to_string(value.size()) + " elements ";
        for (std::size_t i = 0; i < value.size(); ++i)
            take_apart(value[i], place + "[" + std::to_string(i) + "]", parts);
    }
}

template <class T> Components components(const T& value)
{
    Components parts;
    take_apart(value, "", parts);
    return parts;
}

/// The largest difference between two values.
struct Difference {
    bool any = false;
    std::string place;           // "inertia(0, 1)"
    double error = 0, bound = 0; // error and bound of that component
};

/// Compares two values. If they differ, this fills in the verdict of the test case.
Difference compare(const Components& actual, const Components& expected,
                   const Tolerance& tolerance);
std::string describe(const Components& expected, const Tolerance& tolerance,
                     const Difference& difference);

template <class T> class CloseMatcher : public Matcher<T> {
public:
    CloseMatcher(const T& expected, Tolerance tolerance)
        : expected_(components(expected)), tolerance_(std::move(tolerance))
    {
    }
    bool match(const T& actual) const override
    {
        difference_ = compare(components(actual), expected_, tolerance_);
        return !difference_.any;
    }

protected:
    std::string describe() const override
    {
        return rigor::testing::describe(expected_, tolerance_, difference_);
    }

private:
    Components expected_;
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

/// RᵀR = δ and det R = +1, to 16 eps.
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
/// must be.
void check_order(const std::vector<double>& errors, double order);

/// Class I, an exact inequality: value ≤ limit, with eps of slack relative to `scale`.
/// @param what  the value in words; another value that is its limit is named after ", by"
void check_at_most(double value, double limit, const std::string& what, double scale = 1);

/// The same for value ≥ limit.
void check_at_least(double value, double limit, const std::string& what, double scale = 1);

} // namespace rigor::testing

/// Prints a value as its numbers.
template <class T>
requires(rigor::Plain<T> ||
         requires(T t) { t.colPivHouseholderQr(); }) struct Catch::StringMaker<T> {
    static std::string convert(const T& value) { return rigor::testing::components(value).text; }
};
