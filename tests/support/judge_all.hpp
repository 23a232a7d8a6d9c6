// SPDX-License-Identifier: MIT
// Other implementations of the formulas, judged one after the other.
#pragma once

#include <atomic>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace rigor::testing {

/// Line 2 of an implementation's source: a comment that says `what`.
inline std::string second_line(const std::filesystem::path& file, const std::string& what)
{
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    std::getline(in, line);
    if (!line.starts_with("// "))
        throw std::runtime_error(file.string() + ": expected line 2 to be a comment that " + what);
    return line.substr(3);
}

/// `judge(item)` for every item, by two threads.
template <class Item, class Judge> void judge_all(std::vector<Item>& items, const Judge& judge)
{
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < items.size(); i = next++)
            judge(items[i]);
    };
    std::thread other(work);
    work();
    other.join();
}

} // namespace rigor::testing
