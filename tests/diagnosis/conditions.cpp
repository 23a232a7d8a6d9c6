// SPDX-License-Identifier: MIT
// The arguments for which an answer is wrong, if one feature of them decides.
#include "diagnosis/features.hpp"
#include "diagnosis/relations.hpp"
#include "diagnosis/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor::diagnosis {

namespace {

using List = std::vector<double>;

List values_of(const Feature& feature, const std::vector<const Case*>& cases)
{
    List values;
    for (const Case* c : cases)
        values.push_back(feature.of(c->arguments));
    return values;
}

template <class Predicate> bool all(const List& values, const Predicate& predicate)
{
    return std::all_of(values.begin(), values.end(), predicate);
}
template <class Predicate> bool none(const List& values, const Predicate& predicate)
{
    return std::none_of(values.begin(), values.end(), predicate);
}

// A test of one number that holds for all of `wrong` and for none of `right`.
std::string sign_test(const List& wrong, const List& right)
{
    const auto separates = [&](auto predicate) {
        return all(wrong, predicate) && none(right, predicate);
    };
    if (separates([](double f) { return f == 0; })) return "{} is 0";
    if (separates([](double f) { return f < 0; })) return "{} is negative";
    if (separates([](double f) { return f > 0; })) return "{} is positive";
    if (separates([](double f) { return f != 0; })) return "{} is not 0";
    if (separates([&](double f) { return f == wrong[0]; }))
        return "{} is " + number_in_words(wrong[0]);
    return "";
}

std::string threshold_test(const List& wrong, const List& right)
{
    const auto [wrong_low, wrong_high] = std::minmax_element(wrong.begin(), wrong.end());
    const auto [right_low, right_high] = std::minmax_element(right.begin(), right.end());
    const auto is_whole = [](double f) { return f == std::round(f); };
    if (all(wrong, is_whole) && all(right, is_whole)) { // a count
        if (*wrong_high < *right_low) return fmt::format("{{}} is less than {:g}", *right_low);
        if (*wrong_low > *right_high) return fmt::format("{{}} is more than {:g}", *right_high);
        return "";
    }
    // Rounding moves a number that should be 0, so a bound next to 0 is 0.
    constexpr double next_to_zero = 1e-9;
    const double largest = std::max(
        {std::abs(*wrong_low), std::abs(*wrong_high), std::abs(*right_low), std::abs(*right_high)});
    const bool is_below = *wrong_high<*right_low, is_above = *wrong_low> * right_high;
    const double low = is_below ? *wrong_high : *right_high,
                 high = is_below ? *right_low : *wrong_low;
    if ((is_below || is_above) && largest > 0 && std::min(*wrong_low, *right_low) < 0 &&
        std::min(std::abs(low), std::abs(high)) < next_to_zero * largest)
        return is_below ? "{} is negative" : "{} is positive";
    const auto middle = [](double a, double b) {
        return a > 0 && b > 0 ? std::sqrt(a * b) : (a + b) / 2;
    };
    if (is_below) return fmt::format("{{}} is below about {:.1g}", middle(low, high));
    if (is_above) return fmt::format("{{}} is above about {:.1g}", middle(low, high));
    return "";
}

} // namespace

std::string condition_of(const Layout& arguments, const std::vector<const Case*>& wrong,
                         const std::vector<const Case*>& right)
{
    if (wrong.empty() || right.empty()) return "";
    const std::vector<Feature> all_features = features(arguments);
    for (const auto test : {&sign_test, &threshold_test})
        for (const Feature& feature : all_features) {
            const List of_wrong = values_of(feature, wrong), of_right = values_of(feature, right);
            const auto is_nan = [](double f) { return std::isnan(f); };
            if (!none(of_wrong, is_nan) || !none(of_right, is_nan)) continue;
            const std::string words = test(of_wrong, of_right);
            if (!words.empty()) return fmt::format(fmt::runtime(words), feature.words);
        }
    return "";
}

} // namespace rigor::diagnosis
