// SPDX-License-Identifier: MIT
// A queue of limited size between threads.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace rigor {

template <class T> class Queue {
public:
    explicit Queue(std::size_t capacity) : capacity_(capacity) {}

    /// Waits for room and adds an item. @return whether the item was added; it is dropped if the
    /// queue is closed
    bool push(T item)
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return closed_ || items_.size() < capacity_; });
        if (closed_) return false;
        items_.push_back(std::move(item));
        changed_.notify_all();
        return true;
    }

    /// Waits for an item. @return nothing if the queue is closed and empty
    std::optional<T> pop()
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return closed_ || !items_.empty(); });
        if (items_.empty()) return std::nullopt;
        T item = std::move(items_.front());
        items_.pop_front();
        changed_.notify_all();
        return item;
    }

    /// Closes the queue for new items. The items in it can still be taken, unless `drop` is true.
    void close(bool drop = false)
    {
        const std::scoped_lock lock(mutex_);
        closed_ = true;
        if (drop) items_.clear();
        changed_.notify_all();
    }

private:
    std::size_t capacity_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<T> items_;
    bool closed_ = false;
};

} // namespace rigor
