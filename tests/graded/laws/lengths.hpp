// SPDX-License-Identifier: MIT
// The lengths of lists that a test gives a formula. A loop that takes several elements at a time is
// wrong for some lengths alone, and an index that is too narrow for long lists alone.
#pragma once

#include "formulas/types.hpp"

#include <vector>

namespace rigor::testing {

constexpr int narrow = 0x100, wide = 0x10000; // the number of indices with 8 and 16 bits
constexpr int long_list = 1'048'583; // beyond a million and 2^20; no multiple of 2, 3, 4, 5, 7, 8

/// The lengths from `least` on, up to about `most`, in order: all up to 300, and behind them those
/// at which a loop over blocks of a usual size may go wrong.
inline std::vector<int> lengths(int least, int most)
{
    const auto may_go_wrong = [](int n) {
        if (n <= 300) return true;
        if (n > 1100) return n % 64 == 1 || n % 500 == 1; // one more than whole blocks
        const bool is_beside = (n + 1) % 64 <= 2 || (n + 1) % 100 <= 2; // or they are whole
        return is_beside || n % 8 == 1 || n % 10 == 1;
    };
    std::vector<int> result;
    for (int n = least; n <= 4100; ++n)
        if (may_go_wrong(n)) result.push_back(n);
    result.insert(result.end(), {5001, 8193, 10001, wide + 1, long_list});
    std::erase_if(result, [&](int n) { return n > most + 1; });
    return result;
}

/// Numbers from 1 to 8 whose sums have more digits than single precision holds. A million of them,
/// each multiplied by an integer up to 121, add up exactly in a double.
inline double dyadic(int i)
{
    return 1 + i % 7 + 0x1p-16 * (i % 5);
}

/// Point masses on the x axis, as a list of particles or of samples whose density is the mass.
/// Places are small integers, so that all sums are exact.
template <class Element> struct Beads {
    std::vector<Element> list;
    double mass = 0, first = 0, second = 0; // Σ m [kg], Σ m x [kg m], Σ m x² [kg m²]

    explicit Beads(int n = 0) { grow(n); }
    /// Appends beads until there are n.
    void grow(int n)
    {
        if (n > wide) list.reserve(static_cast<std::size_t>(n)); // as much as is needed
        for (int i = static_cast<int>(list.size()); i < n; ++i) {
            const double m = dyadic(i), x = 1.0 + i % 11;
            if constexpr (std::is_same_v<Element, Particle>)
                list.push_back({m, {x, 0, 0}});
            else
                list.push_back({{x, 0, 0}, m});
            mass += m;
            first += m * x;
            second += m * x * x;
        }
    }
};

/// How many elements that count for nothing a test puts among others: a loop that gives up too
/// early finds only these.
constexpr int idle_elements[] = {1, 10, 300, 5000, 70000};

/// The list with copies of an element in front of it and again behind its first element.
template <class T> std::vector<T> among(int count, const T& element, const std::vector<T>& list)
{
    std::vector<T> result(static_cast<std::size_t>(count), element);
    result.push_back(list.front());
    result.insert(result.end(), static_cast<std::size_t>(count), element);
    result.insert(result.end(), list.begin() + 1, list.end());
    return result;
}

} // namespace rigor::testing
