// SPDX-License-Identifier: MIT
// The lengths of lists that a test gives a formula. A loop that takes several elements at a time is
// wrong for some lengths alone, and an index that is too narrow for long lists alone.
#pragma once

#include "formulas/types.hpp"

#include <cmath>
#include <vector>

namespace rigor::testing {

constexpr int narrow = 0x100, wide = 0x10000; // the number of indices with 8 and 16 bits
constexpr int long_list = 1'048'583; // beyond a million and 2^20; no multiple of 2, 3, 4, 5, 7, 8

/// The lengths from `least` on, up to about `most`: all up to 1100, so that for blocks of any size
/// up to that each number of elements beside whole blocks occurs, and beyond that the lengths
/// behind multiples of 64 and round numbers.
inline std::vector<int> lengths(int least, int most)
{
    std::vector<int> result;
    const auto add = [&](int n) {
        if (n <= most + 1) result.push_back(n);
    };
    for (int n = least; n <= 1100; ++n)
        add(n);
    for (int size = 18 * 64; size <= 4096; size += 64)
        add(size + 1);
    for (const int size : {1200, 1500, 2000, 3000, 5000, 8192, 10000, wide})
        add(size + 1);
    if (long_list <= most) add(long_list);
    return result;
}

/// Numbers from 1 to 8 whose sums have more digits than single precision holds. A million of them,
/// each multiplied by an integer up to 121, add up exactly in a double.
inline double dyadic(int i)
{
    return 1 + i % 7 + std::ldexp(i % 5, -16);
}

/// Point masses on the x axis. Places are small integers, so that Σ m, Σ m x and Σ m x² are exact.
inline std::vector<Particle> beads(int n)
{
    std::vector<Particle> result(n);
    for (int i = 0; i < n; ++i)
        result[i] = {dyadic(i), {1.0 + i % 11, 0, 0}};
    return result;
}

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
