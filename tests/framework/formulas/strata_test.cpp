// SPDX-License-Identifier: MIT
// The random arguments of formulas: they are what the contract asks for, and each formula gets
// every class of special values that its arguments have.
#include "graded/laws/preconditions.hpp"

#include <fmt/format.h>
#include <limits>

namespace rigor::testing {

namespace {

// Counts the strata, which are classes of special values, that the numbers, vectors and matrices of
// an argument can have.
template <class T> void note_strata(T& value, const Quantity& q, StrataCounts& possible)
{
    if constexpr (std::is_same_v<T, Quaternion>)
        if (q.kind == Kind::orientation) {
            for (std::size_t s = 0; s < stratum_count; ++s)
                possible[s] += has_stratum<T>(q, static_cast<Stratum>(s));
            return;
        }
    const T same = value;
    each_pair(value, same, q, true, [&](auto& leaf, const auto&, const Quantity& of) {
        for (std::size_t s = 0; s < stratum_count; ++s)
            possible[s] +=
                has_stratum<std::remove_cvref_t<decltype(leaf)>>(of, static_cast<Stratum>(s));
    });
}

// A row of the table: how often each stratum was drawn. Adds to `empty` the strata that were never
// drawn although an argument has them.
template <FormulaIndex f, auto& formula> std::string row_of(std::string& empty)
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    StrataCounts drawn = {}, possible = {};
    for (unsigned seed = 0; seed < 150; ++seed) {
        Random random(seed + 9000);
        Arguments<formula> arguments = random_arguments<f, formula>(seed);
        std::size_t i = 0;
        std::apply(
            [&](auto&... argument) {
                ((note_strata(argument, of.arguments[i], possible),
                  redraw(argument, of.arguments[i], random, &drawn), ++i),
                 ...);
            },
            arguments);
    }
    std::string row = fmt::format("{:>28}", of.name);
    for (std::size_t s = 0; s < stratum_count; ++s) {
        row += fmt::format(" {:>9}", drawn[s]);
        if (possible[s] > 0 && drawn[s] == 0)
            empty += fmt::format("{}: {}; ", of.name, stratum_names[s]);
    }
    return row + "\n";
}

} // namespace

namespace {

template <FormulaIndex f, auto& formula> void check_preconditions()
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    const std::string_view names = formulas[static_cast<unsigned>(f)].arguments;
    for (unsigned seed = 0; seed < 200; ++seed) {
        CAPTURE(of.name, seed);
        Random random(seed + 9000);
        Arguments<formula> arguments = random_arguments<f, formula>(seed);
        REQUIRE(broken_preconditions<f>(arguments) == "");
        redraw_chosen(arguments, of, names, "", true, random); // every argument
        REQUIRE(broken_preconditions<f>(arguments) == "");
    }
}

} // namespace

TEST_CASE("formulas: random arguments are what the contract asks for", "[strata]")
{
#define RIGOR_ROW(tag, topic, function, ...)                                                       \
    check_preconditions<FormulaIndex::function, rigor::function>();
    RIGOR_FORMULAS(RIGOR_ROW)
#undef RIGOR_ROW
}

TEST_CASE("formulas: what the contract does not allow is told apart", "[strata]")
{
    using namespace quantities;
    REQUIRE(satisfies(Matrix3d(Matrix3d::Identity()), rotation));
    REQUIRE(!satisfies(Matrix3d(-Matrix3d::Identity()), rotation));
    REQUIRE(!satisfies(Matrix3d(1.001 * Matrix3d::Identity()), rotation));
    REQUIRE(!satisfies(Matrix3d(-Matrix3d::Identity()), inertia));
    Matrix3d skew = Matrix3d::Identity();
    skew(0, 1) = 1e-6;
    REQUIRE(!satisfies(skew, stress));
    REQUIRE(!satisfies(Vector3d(1, 1e-5, 0), unit));
    REQUIRE(!satisfies(-1.0, mass));
    REQUIRE(satisfies(-1.0, depth));
    REQUIRE(!satisfies(std::numeric_limits<double>::quiet_NaN(), depth));
    REQUIRE(!satisfies(Quaternion{1, {0.1, 0, 0}}, orientation));
}

TEST_CASE("formulas: no stratum of random arguments is empty", "[strata]")
{
    std::string table = fmt::format("{:>28}", "formula"), empty;
    for (const std::string_view name : stratum_names)
        table += fmt::format(" {:>9}", name);
    table += "\n";
#define RIGOR_ROW(tag, topic, function, ...)                                                       \
    table += row_of<FormulaIndex::function, rigor::function>(empty);
    RIGOR_FORMULAS(RIGOR_ROW)
#undef RIGOR_ROW
    INFO(table);
    REQUIRE(empty == "");
}

} // namespace rigor::testing
