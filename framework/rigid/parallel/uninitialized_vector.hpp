// SPDX-License-Identifier: MIT
// Vectors whose elements are written by several threads.
#pragma once

#include "rigid/parallel/thread_pool.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace rigor {

/// An allocator whose vector does not write new elements when it is resized: each element is
/// constructed before it is read.
template <class T> struct UninitializedAllocator : std::allocator<T> {
    template <class U> struct rebind {
        using other = UninitializedAllocator<U>;
    };

    template <class U> void construct(U*) noexcept {}
    template <class U, class... Args> void construct(U* at, Args&&... args)
    {
        std::construct_at(at, std::forward<Args>(args)...);
    }
};

template <class T> using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;

/// The lists that work(first, last) returns for ranges that cover [0, count), each of at least
/// `grain_size`, one after the other in a single list.
template <class Work>
auto concatenate_ranges(ThreadPool& pool, std::size_t count, std::size_t grain_size,
                        const Work& work) -> decltype(work(count, count))
{
    if (pool.range_count(count, grain_size) < 2) return work(std::size_t{0}, count);
    const auto parts = pool.collect_ranges(count, grain_size, work);
    std::vector<std::size_t> starts = {0};
    for (const auto& part : parts)
        starts.push_back(starts.back() + part.size());
    decltype(work(count, count)) all(starts.back());
    pool.for_each_task(static_cast<int>(parts.size()), [&](int k) {
        std::uninitialized_copy(parts[k].begin(), parts[k].end(), all.data() + starts[k]);
    });
    return all;
}

} // namespace rigor
