// SPDX-License-Identifier: MIT
// Arguments whose result nearly cancels: Newton's method moves numbers of the arguments until a
// component of the result, or a whole vector or matrix of it, is 0 although its terms are not.
#pragma once

#include "preconditions.hpp"
#include "special_arguments.hpp"

#include <functional>

namespace rigor::testing {

/// The largest magnitude of a number that is moved, so that no term becomes large.
constexpr double largest_move = 4;

/// The smallest value to which a mass, a duration and the like are moved.
constexpr double least_size = 0x1p-6;

/// A number of the arguments that may move; `mirror` is the other entry of a symmetric matrix.
struct Movable {
    double* number;
    double* mirror = nullptr;
    bool is_size = false; // not negative

    void set(double x) const
    {
        *number = x;
        if (mirror) *mirror = x;
    }
};

/// Numbers that move together: one, those of a vector or a matrix, or those of an argument.
using Movables = std::vector<Movable>;

template <class T> void add_movables(T& leaf, const Quantity& of, std::vector<Movables>& groups)
{
    const bool is_constrained = of.kind == Kind::unit || of.kind == Kind::rotation ||
                                of.kind == Kind::orientation || of.kind == Kind::index;
    if (is_constrained || of.dimension == quantities::impulse_matrix.dimension) return;
    Movables group;
    if constexpr (std::is_same_v<T, double>) {
        group.push_back({&leaf, nullptr, of.kind == Kind::number});
    } else {
        const bool is_symmetric =
            leaf.cols() == 3 && (of.kind == Kind::symmetric || of.kind == Kind::definite);
        for (int j = 0; j < leaf.cols(); ++j)
            for (int i = 0; i < (is_symmetric ? j + 1 : 3); ++i)
                group.push_back({&leaf(i, j), is_symmetric && i != j ? &leaf(j, i) : nullptr});
    }
    groups.push_back(group);
}

/// Draws numbers that move together. They point into `arguments`.
template <class Arguments>
Movables draw_movables(Arguments& arguments, const FormulaQuantities& of, Random& random)
{
    std::vector<std::vector<Movables>> all; // for each argument the groups of its parts
    std::size_t k = 0;
    const auto collect = [&](auto& argument) {
        using Argument = std::remove_cvref_t<decltype(argument)>;
        const Quantity& q = of.arguments[k++];
        std::vector<Movables> groups;
        if constexpr (!std::is_same_v<Argument, LevelSet>) {
            const Argument same = argument;
            constexpr bool is_body = std::is_same_v<Argument, Body>;
            each_pair(argument, same, q, is_body,
                      [&](auto& leaf, const auto&, const Quantity& its) {
                          add_movables(leaf, its, groups);
                      });
        }
        if (!groups.empty()) all.push_back(groups);
    };
    std::apply([&](auto&... argument) { (collect(argument), ...); }, arguments);
    const std::vector<Movables>& groups = all[random.bits() % all.size()];
    const Movables& group = groups[random.bits() % groups.size()];
    const std::uint64_t choice = random.bits() % 4;
    if (choice == 0) return {group[random.bits() % group.size()]};
    if (choice == 1) return group;
    Movables together;
    for (const Movables& each : groups)
        together.insert(together.end(), each.begin(), each.end());
    return together;
}

/// The numbers of a result that shall cancel together.
struct Targets {
    std::vector<std::vector<std::size_t>> blocks; // vectors, and matrices or their 3×3 blocks
    std::size_t count = 0;

    void block(const Place&, const NumberBlock& block)
    {
        for (int j = 0; j < block.columns; j += 3)
            for (int i = 0; i < block.rows; i += 3) {
                std::vector<std::size_t> numbers;
                for (int l = j; l < std::min(j + 3, block.columns); ++l)
                    for (int k = i; k < std::min(i + 3, block.rows); ++k)
                        numbers.push_back(count + static_cast<std::size_t>(l * block.rows + k));
                blocks.push_back(numbers);
            }
        count += static_cast<std::size_t>(block.size());
    }
    void size(std::size_t) {}
    void presence(bool) {}
};

/// Draws a block of the numbers of a result, or one of its numbers.
template <class Result> std::vector<std::size_t> draw_target(const Result& result, Random& random)
{
    Targets targets;
    walk_through(result, {}, targets);
    if (targets.blocks.empty()) return {};
    const auto& block = targets.blocks[random.bits() % targets.blocks.size()];
    if (one_in(2, random)) return block;
    return {block[random.bits() % block.size()]};
}

using Numbers = std::vector<double>;
/// The numbers of the result for the present arguments; none if these are not allowed.
using Evaluate = std::function<Numbers()>;

inline Eigen::VectorXd chosen(const Numbers& numbers, const std::vector<std::size_t>& target)
{
    Eigen::VectorXd result(static_cast<int>(target.size()));
    for (std::size_t i = 0; i < target.size(); ++i)
        result[static_cast<int>(i)] = target[i] < numbers.size() ? numbers[target[i]] : NAN;
    return result;
}

/// Moves numbers, as little as possible, until the target is 0. @return whether they arrive
inline bool move_to_zero(const Movables& movables, const std::vector<std::size_t>& target,
                         const Evaluate& evaluate)
{
    constexpr double step = 0x1p-18;
    Eigen::MatrixXd J(static_cast<int>(target.size()), static_cast<int>(movables.size()));
    for (int iteration = 0; iteration < 6; ++iteration) {
        const Eigen::VectorXd y = chosen(evaluate(), target);
        if (!y.allFinite()) return false;
        if (y.lpNorm<Eigen::Infinity>() < 0x1p-46) return true;
        for (int i = 0; i < J.cols(); ++i) {
            const Movable& movable = movables[static_cast<std::size_t>(i)];
            const double x = *movable.number;
            movable.set(x + step);
            J.col(i) = (chosen(evaluate(), target) - y) / step;
            movable.set(x);
        }
        if (!J.allFinite() || J.lpNorm<Eigen::Infinity>() < 0x1p-8) return false;
        Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
        svd.setThreshold(0x1p-8); // directions that change the target by less are left alone
        const Eigen::VectorXd move = svd.solve(y);
        for (int i = 0; i < J.cols(); ++i) {
            const Movable& movable = movables[static_cast<std::size_t>(i)];
            movable.set(*movable.number - move[i]);
            if (!(std::abs(*movable.number) <= largest_move)) return false;
            if (movable.is_size && *movable.number < least_size) return false;
        }
    }
    return chosen(evaluate(), target).lpNorm<Eigen::Infinity>() < 0x1p-42;
}

} // namespace rigor::testing
