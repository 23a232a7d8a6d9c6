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

/// What work(first, last) returns for stretches of [0, count), each of at least `least`: one after the other.
template <class Work>
auto join(Team& team, std::size_t count, std::size_t least, const Work& work)
    -> decltype(work(count, count))
{
    if (team.stretches_of(count, least) < 2) return work(std::size_t{0}, count);
    const auto parts = team.collect(count, least, work);
    std::vector<std::size_t> starts = {0};
    for (const auto& part : parts)
        starts.push_back(starts.back() + part.size());
    decltype(work(count, count)) all(starts.back());
    team.share(static_cast<int>(parts.size()), [&](int k) {
        std::uninitialized_copy(parts[k].begin(), parts[k].end(), all.data() + starts[k]);
    });
    return all;
}

} // namespace rigor
