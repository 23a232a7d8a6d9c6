// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/team.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace rigor {

/// Leaves what a vector is resized by as the memory was: each element is constructed before it is read.
template <class T> struct Unfilled : std::allocator<T> {
    template <class U> struct rebind {
        using other = Unfilled<U>;
    };

    template <class U> void construct(U*) noexcept {}
    template <class U, class... Args> void construct(U* at, Args&&... args)
    {
        std::construct_at(at, std::forward<Args>(args)...);
    }
};

/// A list that threads put together.
template <class T> using Joined = std::vector<T, Unfilled<T>>;

/// All parts, one after the other.
template <class T> Joined<T> join(std::vector<Joined<T>> parts, Team& team)
{
    if (parts.empty()) return {};
    if (parts.size() == 1) return std::move(parts[0]);
    std::vector<std::size_t> starts = {0};
    for (const Joined<T>& part : parts)
        starts.push_back(starts.back() + part.size());
    Joined<T> all(starts.back());
    team.share(static_cast<int>(parts.size()), [&](int k) {
        std::uninitialized_copy(parts[k].begin(), parts[k].end(), all.data() + starts[k]);
    });
    return all;
}

} // namespace rigor
