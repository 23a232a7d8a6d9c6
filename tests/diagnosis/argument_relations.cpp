// SPDX-License-Identifier: MIT
// Relations of wrong answers to the right ones in which an argument has a part, and parts of the
// answer that are right.
#include "diagnosis/relations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor::diagnosis {

namespace {

constexpr double exact_fit = 1e-8; // how well a relation has to fit, relative to the answer

// A function of a feature that may be too much in the answer or be missing in it.
struct Power {
    const char* words; // {} stands for the feature
    double (*of)(double);
};
constexpr Power powers[] = {
    {"multiplied by {}", [](double f) { return f; }},
    {"divided by {}", [](double f) { return 1 / f; }},
    {"multiplied by the square of {}", [](double f) { return f * f; }},
    {"divided by the square of {}", [](double f) { return 1 / (f * f); }},
    {"multiplied by the root of {}", [](double f) { return std::sqrt(f); }},
    {"divided by the root of {}", [](double f) { return 1 / std::sqrt(f); }},
    {"divided by 1 + {}", [](double f) { return 1 / (1 + f); }},
    {"multiplied by 1 + {}", [](double f) { return 1 + f; }},
    {"multiplied by 1 - {}", [](double f) { return 1 - f; }},
    {"multiplied by {0} / (1 + {0})", [](double f) { return f / (1 + f); }},
    {"multiplied by (1 - {0}) / (1 + {0})", [](double f) { return (1 - f) / (1 + f); }},
};

// The words of a power of a feature and a constant for which all `values` are constant × power.
std::string explained(const std::vector<double>& values, const Pairs& pairs,
                      const std::vector<Feature>& features)
{
    for (const Feature& feature : features)
        for (const Power& power : powers) {
            double c = std::nan("");
            bool fits = true, varies = false;
            for (std::size_t i = 0; fits && i < values.size(); ++i) {
                const double p = power.of(feature.of(*pairs.list[i].arguments));
                if (!std::isfinite(p) || p == 0) {
                    fits = false;
                    break;
                }
                if (std::isnan(c)) c = values[i] / p;
                fits = std::abs(values[i] - c * p) <= exact_fit * std::abs(values[i]);
                varies |= std::abs(values[i] - values[0]) > clear * std::abs(values[0]);
            }
            if (!fits || !varies) continue;
            const std::string words = fmt::format(fmt::runtime(power.words), feature.words);
            return std::abs(c - 1) < exact_fit
                       ? words
                       : words + fmt::format(" and by the factor {}", number_in_words(c));
        }
    return "";
}

// The right answer times a power of a feature.
std::string factor_by_feature(const Pairs& all, const std::vector<Feature>& features)
{
    std::vector<double> ratios;
    Pairs pairs = {all.role, {}}; // without zeros, which every factor leaves alone
    std::copy_if(all.list.begin(), all.list.end(), std::back_inserter(pairs.list),
                 [](const Pair& p) { return norm(p.right) > p.noise || norm(p.answer) > p.noise; });
    if (pairs.list.size() < all.list.size() / 2) return "";
    for (const Pair& pair : pairs.list) {
        double square = 0, product = 0;
        for (std::size_t i = 0; i < pair.right.size(); ++i) {
            square += pair.right[i] * pair.right[i];
            product += pair.right[i] * pair.answer[i];
        }
        const double ratio = product / square;
        if (!std::isfinite(ratio) || ratio == 0) return "";
        std::vector<double> expected(pair.right.begin(), pair.right.end());
        for (double& x : expected)
            x *= ratio;
        if (!close(expected, pair.answer, exact_fit, pair.noise)) return "";
        ratios.push_back(ratio);
    }
    const std::string words = explained(ratios, pairs, features);
    if (!words.empty()) return "the right one " + words;
    const bool same_sign = std::all_of(ratios.begin(), ratios.end(),
                                       [&](double r) { return (r > 0) == (ratios[0] > 0); });
    if (pairs.role.size() == 1 || !same_sign) return "";
    return ratios[0] > 0 ? "the right one with a wrong length: its direction is right"
                         : "opposite to the right one, and of a wrong length";
}

// The right answer plus a constant times an argument, or an argument alone.
std::string argument_added(const Pairs& pairs, const Layout& arguments, bool is_alone)
{
    for (int i = 0; i < static_cast<int>(arguments.roles.size()); ++i) {
        const Role& role = arguments.roles[i];
        if (role.in_list || !role.same_shape(pairs.role) || role.form == Form::boolean) continue;
        double c = std::nan("");
        const bool fits = std::all_of(pairs.list.begin(), pairs.list.end(), [&](const Pair& pair) {
            const std::vector<Leaf> leaves = arguments.leaves(*pair.arguments, i);
            if (leaves.size() != 1) return false;
            const Numbers a = pair.arguments->of(leaves[0], role);
            std::vector<double> expected(pair.right.begin(), pair.right.end());
            double product = 0, square = 0;
            for (std::size_t k = 0; k < a.size(); ++k) {
                if (is_alone) expected[k] = 0;
                product += a[k] * (pair.answer[k] - expected[k]);
                square += a[k] * a[k];
            }
            if (std::isnan(c)) c = product / square;
            for (std::size_t k = 0; k < a.size(); ++k)
                expected[k] += c * a[k];
            return close(expected, pair.answer, exact_fit, pair.noise);
        });
        if (!fits || !std::isfinite(c) || c == 0) continue;
        const std::string times =
            std::abs(std::abs(c) - 1) < exact_fit ? "" : number_in_words(std::abs(c)) + " ";
        if (is_alone) return fmt::format("{}{}`{}`", c < 0 ? "-" : "", times, role.name);
        return fmt::format("the right one {} {}`{}`", c < 0 ? "minus" : "plus", times, role.name);
    }
    return "";
}

// The right vector with its part along a unit argument, or its part across it, changed.
std::string part_changed(const Pairs& pairs, const Layout& arguments)
{
    struct Change {
        double along, across; // the factors of the two parts
        const char* words;
    };
    constexpr Change changes[] = {{1, -1, "with the opposite sign of its part across"},
                                  {-1, 1, "with the opposite sign of its part along"},
                                  {1, 0, "without its part across"},
                                  {0, 1, "without its part along"}};
    if (!pairs.role.is_vector()) return "";
    for (int i = 0; i < static_cast<int>(arguments.roles.size()); ++i) {
        const Role& role = arguments.roles[i];
        if (role.in_list || !role.is_vector() || role.quantity.kind != Kind::unit) continue;
        for (const Change& change : changes)
            if (std::all_of(pairs.list.begin(), pairs.list.end(), [&](const Pair& pair) {
                    const std::vector<Leaf> leaves = arguments.leaves(*pair.arguments, i);
                    if (leaves.size() != 1) return false;
                    const Numbers numbers = pair.arguments->of(leaves[0], role);
                    const Vector3d n(numbers[0], numbers[1], numbers[2]);
                    const Vector3d j(pair.right[0], pair.right[1], pair.right[2]);
                    const Vector3d j_n = j.dot(n) * n;
                    const Vector3d expected = change.along * j_n + change.across * (j - j_n);
                    return close({expected.data(), 3}, pair.answer, exact_fit, pair.noise);
                }))
                return fmt::format("the right one {} `{}`", change.words, role.name);
    }
    return "";
}

// The right number plus a power of a feature.
std::string feature_added(const Pairs& pairs, const std::vector<Feature>& features)
{
    if (pairs.role.size() != 1 || pairs.role.form != Form::real) return "";
    std::vector<double> differences;
    for (const Pair& pair : pairs.list)
        differences.push_back(pair.answer[0] - pair.right[0]);
    for (const Feature& feature : features)
        for (const double power : {1.0, 2.0}) {
            const auto at = [&](std::size_t i) {
                return std::pow(feature.of(*pairs.list[i].arguments), power);
            };
            const double c = differences[0] / at(0);
            bool fits = std::isfinite(c) && c != 0;
            for (std::size_t i = 0; fits && i < differences.size(); ++i)
                fits = std::abs(differences[i] - c * at(i)) <= exact_fit * std::abs(differences[i]);
            if (fits)
                return fmt::format("the right one {} {} {}{}", c < 0 ? "minus" : "plus",
                                   number_in_words(std::abs(c)),
                                   power == 2 ? "times the square of " : "times ", feature.words);
        }
    return "";
}

} // namespace

std::string argument_itself(const Pairs& pairs, const Layout& arguments)
{
    if (pairs.list.empty() || pairs.role.form == Form::integer) return "";
    return argument_added(pairs, arguments, true);
}

std::string relation_to_arguments(const Pairs& pairs, const Layout& arguments,
                                  const std::vector<Feature>& features)
{
    if (pairs.list.empty() || pairs.role.form == Form::boolean || pairs.role.form == Form::integer)
        return "";
    std::string words = argument_added(pairs, arguments, false);
    if (words.empty()) words = part_changed(pairs, arguments);
    if (words.empty()) words = factor_by_feature(pairs, features);
    if (words.empty()) words = feature_added(pairs, features);
    return words;
}

std::string right_part(const Pairs& pairs)
{
    const Role& role = pairs.role;
    if (pairs.list.empty() || role.form != Form::real || role.size() == 1) return "";
    std::vector<int> wrong;
    for (int i = 0; i < role.size(); ++i)
        if (!std::all_of(pairs.list.begin(), pairs.list.end(), [&](const Pair& p) {
                return std::abs(p.answer[i] - p.right[i]) <= clear * norm(p.right);
            }))
            wrong.push_back(i);
    const int n = role.rows;
    const auto is_diagonal = [&](int i) { return i % n == i / n; };
    if (role.is_matrix()) {
        if (std::all_of(wrong.begin(), wrong.end(), is_diagonal))
            return "wrong on its diagonal only";
        if (std::none_of(wrong.begin(), wrong.end(), is_diagonal))
            return "right on its diagonal only";
    }
    if (2 * static_cast<int>(wrong.size()) > role.size()) return "";
    std::string text;
    for (const int i : wrong)
        text +=
            (text.empty() ? "" : ", ") +
            (role.columns == 1 ? fmt::format("({})", i) : fmt::format("({}, {})", i % n, i / n));
    return "wrong in the entries " + text + " only, counted from 0";
}

} // namespace rigor::diagnosis
