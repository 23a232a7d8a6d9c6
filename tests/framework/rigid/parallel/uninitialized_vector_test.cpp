// SPDX-License-Identifier: MIT
#include "rigid/parallel/uninitialized_vector.hpp"

#include "support/catch.hpp"

#include <numeric>
#include <string>

using namespace rigor;

TEST_CASE("uninitialized vector: lists of ranges become one list for any number of threads",
          "[rigid]")
{
    for (const int threads : {1, 2, 3})
        for (const std::size_t count : {0, 1, 7, 8, 100, 1000}) {
            CAPTURE(threads, count);
            ThreadPool pool(threads);
            // Each number has as many copies as its remainder after a division by 3.
            const auto copies = [](std::size_t first, std::size_t last) {
                UninitializedVector<std::size_t> list;
                for (std::size_t i = first; i < last; ++i)
                    list.insert(list.end(), i % 3, i);
                return list;
            };
            REQUIRE(concatenate_ranges(pool, count, 4, copies) == copies(0, count));
        }
}

TEST_CASE("uninitialized vector: elements that own memory are copied whole", "[rigid]")
{
    ThreadPool pool(2);
    const auto names = [](std::size_t first, std::size_t last) {
        std::vector<std::string> list;
        for (std::size_t i = first; i < last; ++i)
            list.push_back(std::string(40, 'x') + std::to_string(i));
        return list;
    };
    REQUIRE(concatenate_ranges(pool, 100, 1, names) == names(0, 100));
}

TEST_CASE("uninitialized vector: values that are given are written", "[rigid]")
{
    const UninitializedVector<int> three = {1, 2, 3};
    CHECK(std::accumulate(three.begin(), three.end(), 0) == 6);
    UninitializedVector<int> grown(2, 5);
    grown.resize(4, 7);
    CHECK(grown == UninitializedVector<int>{5, 5, 7, 7});
}
