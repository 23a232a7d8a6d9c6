// SPDX-License-Identifier: MIT
// Helpers to judge many implementations of the formulas.
#pragma once

#include <atomic>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace rigor::testing {

/// The text of line 2 of an implementation's source, which must be a comment.
/// @param what  what the comment must do, for the error message: "says what is different"
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

/// Calls `judge(item)` for every item, on two threads.
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
