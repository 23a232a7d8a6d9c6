// SPDX-License-Identifier: MIT
// Takes the place of the worker: greets as it does, and answers each question for a scene.
#pragma once

#include "formulas/table.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>

constexpr std::size_t ring = std::size_t{4} << 20; // bytes of a stream

inline std::uint64_t fingerprint()
{
    std::uint64_t hash = 14695981039346656037u;
    const auto add = [&](std::string_view text) {
        for (const char c : text)
            hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    };
    add("rigor worker 3");
    for (const rigor::Formula& formula : rigor::formulas) {
        add(formula.tag);
        add(formula.name);
        add(formula.arguments);
    }
    return hash;
}

// @param stream_for  returns what is streamed for the text of a question
template <typename StreamFor> void serve_forged(const StreamFor& stream_for)
{
    constexpr std::size_t size = 2 * ring + (std::size_t{64} << 20) + 4096;
    void* memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, 3, 0);
    if (memory == MAP_FAILED) return; // nobody asks
    auto* words = static_cast<volatile std::uint32_t*>(memory);
    auto* stream = static_cast<char*>(memory) + 384;
    auto* payload = static_cast<char*>(memory) + 384 + 2 * ring;
    const std::uint64_t greeting = fingerprint();
    std::memcpy(payload, &greeting, sizeof greeting);
    for (std::uint32_t turn = 1;; ++turn) {
        while (turn > 1 && words[0] != turn) // the first answer is a greeting
            usleep(10);
        if (turn > 1) {
            const std::string streamed = stream_for(std::string(payload, 4096));
            std::memcpy(stream, streamed.data(), streamed.size());
            words[32] = static_cast<std::uint32_t>(streamed.size());
        }
        words[17] = 0;                                                              // done
        *reinterpret_cast<volatile std::uint64_t*>(words + 18) = turn == 1 ? 8 : 0; // bytes
        std::atomic_thread_fence(std::memory_order_seq_cst);
        words[16] = turn;
    }
}
