// SPDX-License-Identifier: MIT
#include "rigid/parallel/thread_pool.hpp"

#include "support/catch.hpp"

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

using namespace rigor;

TEST_CASE("thread pool: each task is done once", "[rigid]")
{
    for (int threads : {1, 2, 4}) {
        ThreadPool pool(threads);
        for (int tasks : {0, 1, 2, 7, 100})
            for (int round = 0; round < 50; ++round) {
                CAPTURE(threads, tasks, round);
                std::vector<int> done(tasks, 0);
                pool.for_each_task(tasks, [&](int k) { ++done[k]; });
                REQUIRE(done == std::vector<int>(tasks, 1));
            }
    }
}

TEST_CASE("thread pool: ranges cover everything once", "[rigid]")
{
    ThreadPool pool(3);
    for (std::size_t count : {0, 1, 5, 64, 1000}) {
        CAPTURE(count);
        std::vector<int> done(count, 0);
        pool.for_each_range(count, 8, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
                ++done[i];
        });
        REQUIRE(done == std::vector<int>(count, 1));
    }
}

TEST_CASE("thread pool: the exception of the lowest task is thrown and work goes on", "[rigid]")
{
    for (int threads : {2, 3}) {
        ThreadPool pool(threads);
        const auto fail = [](int k) {
            if (k % 10 == 3) throw std::runtime_error(std::to_string(k));
        };
        REQUIRE_THROWS_WITH(pool.for_each_task(40, fail), "3");
        std::atomic<int> sum = 0;
        pool.for_each_task(40, [&](int k) { sum += k; });
        REQUIRE(sum == 780);
    }
}
