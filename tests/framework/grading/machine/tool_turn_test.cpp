// SPDX-License-Identifier: MIT
#include "grading/machine/tool_turn.hpp"

#include "grading/class/isolated.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace rigor::testing::tool_turn_test {

namespace {

constexpr std::uint64_t gigabyte = std::uint64_t{1} << 30;

using Clock = std::chrono::steady_clock;

std::string now()
{
    return std::to_string(Clock::now().time_since_epoch().count());
}

// The largest number of intervals that have a time in common.
long most_at_once(const std::vector<std::pair<long, long>>& intervals)
{
    long most = 0;
    for (const auto& one : intervals)
        most = std::max(most, std::count_if(intervals.begin(), intervals.end(), [&](auto& other) {
                            return other.first <= one.first && one.first < other.second;
                        }));
    return most;
}

} // namespace

TEST_CASE("tool turn: the tools that run at a time find room in the memory that there is",
          "[build]")
{
    for (const unsigned processors : {1u, 2u, 8u, 64u})
        for (const std::uint64_t gigabytes : {3u, 4u, 16u, 23u, 512u}) {
            CAPTURE(processors, gigabytes);
            const ToolShare share = tool_share(processors, gigabytes * gigabyte);
            CHECK(share.at_once >= 1);
            CHECK(share.at_once <= processors);
            CHECK(share.memory >= gigabyte);
            CHECK(2 * share.at_once * share.memory <= gigabytes * gigabyte);
        }
    CHECK(tool_share(8, 16 * gigabyte).at_once == 6); // each needs a gigabyte and its assembler too
    CHECK(tool_share(8, 64 * gigabyte).at_once == 8);
    CHECK(tool_share(8, gigabyte).at_once == 1);
    CHECK(tool_share(8, gigabyte).memory == gigabyte);
    CHECK(tool_share(0, 0).at_once == 1);
}

TEST_CASE("tool turn: no more tools of forked processes run at a time than there are turns",
          "[build]")
{
    make_tool_turns();
    const unsigned turns = own_tool_share().at_once, jobs = turns + 2;
    std::vector<std::pair<long, long>> intervals;
    run_isolated(
        jobs, {jobs},
        [](std::size_t) {
            const ToolTurn turn;
            const std::string start = now();
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            return start + ' ' + now();
        },
        [&](const WorkDone& done) {
            const std::string text = done.text.value();
            intervals.emplace_back(std::stol(text), std::stol(text.substr(text.find(' '))));
        });
    CHECK(intervals.size() == jobs);
    CHECK(most_at_once(intervals) <= turns);
}

TEST_CASE("tool turn: a process that is killed gives its turn back", "[build]")
{
    make_tool_turns();
    for (unsigned i = 0; i < 3 * own_tool_share().at_once; ++i) {
        Isolated holder([] {
            const ToolTurn turn;
            std::this_thread::sleep_for(std::chrono::seconds(20));
            return std::string();
        });
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        holder.stop();
    }
    const auto start = Clock::now();
    const ToolTurn turn;
    CHECK(Clock::now() - start < std::chrono::seconds(10));
}

} // namespace rigor::testing::tool_turn_test
