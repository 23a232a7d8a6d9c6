// SPDX-License-Identifier: MIT
// Vectors whose new elements are not initialized, since several threads write them afterwards, and
// the concatenation of lists that several threads make.
#pragma once

#include "rigid/parallel/thread_pool.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace rigor {

/// An allocator with which `resize` does not write the new elements of a vector. The code that
/// resizes the vector has to write each new element before anything reads it.
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

/// Calls work(first, last) as `ThreadPool::for_each_range` does. Each call returns a list; the
/// result is a single list of all their elements, in the order of the ranges.
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
