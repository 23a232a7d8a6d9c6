// SPDX-License-Identifier: MIT
// What an honest worker does: it computes, prints, throws, takes large blocks of memory and gives
// them back, sorts, and looks at clocks. It prints a line for each.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

bool throws()
{
    try {
        return std::vector<int>(3).at(7) == 0;
    } catch (const std::out_of_range&) {
        return true;
    }
}

bool runs_out_of_memory()
{
    try {
        std::vector<double> most(std::size_t{1} << 40);
        return most[7] != 0;
    } catch (const std::bad_alloc&) {
        return true;
    }
}

// Growing a block of this size moves its pages (mremap).
bool grows_large_blocks()
{
    void* block = std::malloc(std::size_t{8} << 20);
    for (std::size_t size = 16; block && size <= 128; size *= 2) {
        block = std::realloc(block, size << 20);
        if (block) static_cast<char*>(block)[(size << 20) - 1] = 1;
    }
    std::free(block);
    return block != nullptr;
}

int compare(const void* a, const void* b)
{
    const int x = *static_cast<const int*>(a), y = *static_cast<const int*>(b);
    return (x > y) - (x < y);
}

// The list is so large that `qsort` asks the system how much memory there is.
bool sorts()
{
    std::vector<int> numbers(100000);
    std::iota(numbers.rbegin(), numbers.rend(), 0);
    std::qsort(numbers.data(), numbers.size(), sizeof(int), compare);
    return std::is_sorted(numbers.begin(), numbers.end());
}

bool looks_at_clocks()
{
    const auto start = std::chrono::steady_clock::now();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::chrono::steady_clock::now() > start && std::time(nullptr) > 0 && std::clock() >= 0;
}

} // namespace

int main()
{
    std::setvbuf(stdout, nullptr, _IOLBF, 0); // as workers do
    std::printf("sine %.3f\n", std::sin(1.0) + std::pow(2.0, 0.5) + std::atan2(1, 2));
    std::cout << "stream " << 1.5 << ' ' << std::map<int, int>{{1, 2}}.size() << std::endl;
    std::printf("throw %d\n", throws());
    std::printf("no memory %d\n", runs_out_of_memory());
    std::printf("large blocks %d\n", grows_large_blocks());
    std::printf("sort %d\n", sorts());
    std::printf("random %d\n", std::mt19937(std::random_device()())() != 0);
    std::printf("clocks %d\n", looks_at_clocks());
    std::fprintf(stderr, "the end\n");
}
