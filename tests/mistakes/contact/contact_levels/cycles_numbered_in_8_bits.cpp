// SPDX-License-Identifier: MIT
// Cycles are numbered in 8 bits for their common level, so the 257th shares that of the first.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static)
{
    const int count = static_cast<int>(rests_on.size());
    std::vector<int> level(count, 0), index(count, -1), low(count, 0), component(count, -1);
    std::vector<std::size_t> next(count, 0);
    std::vector<int> stack, path;
    int visited = 0, components = 0;
    std::vector<int> cycle(count, -1), cycle_level(256, 0);
    unsigned char cycles = 0;
    for (int root = 0; root < count; ++root) {
        if (index[root] >= 0) continue;
        path.push_back(root);
        while (!path.empty()) {
            const int a = path.back();
            if (index[a] < 0) {
                index[a] = low[a] = visited++;
                stack.push_back(a);
            }
            if (!is_static[a] && next[a] < rests_on[a].size()) {
                const int b = rests_on[a][next[a]++];
                if (index[b] < 0)
                    path.push_back(b);
                else if (component[b] < 0)
                    low[a] = std::min(low[a], index[b]);
                continue;
            }
            path.pop_back();
            if (!path.empty()) low[path.back()] = std::min(low[path.back()], low[a]);
            if (low[a] != index[a]) continue;
            std::vector<int> members;
            do {
                members.push_back(stack.back());
                component[stack.back()] = components;
                stack.pop_back();
            } while (members.back() != a);
            int highest = 0;
            for (const int m : members)
                if (!is_static[m])
                    for (const int b : rests_on[m])
                        if (component[b] != components) highest = std::max(highest, level[b]);
            for (const int m : members)
                level[m] = is_static[m] ? 0 : highest + 1;
            if (members.size() > 1) {
                for (const int m : members)
                    cycle[m] = cycles;
                cycle_level[cycles] = highest + 1;
                ++cycles;
            }
            ++components;
        }
    }
    for (int i = 0; i < count; ++i)
        if (cycle[i] >= 0) level[i] = cycle_level[cycle[i]];
    return level;
}

} // namespace rigor
