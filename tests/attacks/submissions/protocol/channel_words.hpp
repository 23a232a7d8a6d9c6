// SPDX-License-Identifier: MIT
// What an attacker who has read the framework knows of the memory that a worker shares with its
// client. A test of the framework's room `worker/protocol` keeps it true.
#pragma once

#include "formulas/table.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

// The beginning of the channel.
struct ChannelWords {
    volatile std::uint32_t request;
    std::uint32_t kind; // 0: a call of a formula
    std::uint32_t argument, unused;
    std::uint64_t request_size;
    std::uint32_t rest[10];
    volatile std::uint32_t reply;
    volatile std::uint32_t status;
    volatile std::uint64_t reply_size;
    std::uint32_t more[12];
    volatile std::uint32_t streamed;
};

constexpr std::size_t ring_size = std::size_t{4} << 20; // [bytes], of each of the two rings
constexpr std::size_t stream_start = 256;               // [bytes] from the start of the channel
constexpr std::size_t payload_start = 384 + 2 * ring_size;
constexpr std::size_t channel_size = payload_start + (std::size_t{64} << 20);

// What a worker says first.
inline std::uint64_t greeting()
{
    std::uint64_t hash = 14695981039346656037u;
    const auto add = [&](std::string_view text) {
        for (const char c : text)
            hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    };
    add("rigor worker 4");
    for (const rigor::Formula& formula : rigor::formulas) {
        add(formula.tag);
        add(formula.name);
        add(formula.arguments);
    }
    return hash;
}
