// SPDX-License-Identifier: MIT
// Takes the place of the worker: greets as it does, and answers each question.
#pragma once

#include "channel_words.hpp"

#include <atomic>
#include <cstring>
#include <string>
#include <sys/mman.h>

struct Asked {
    bool for_scene; // otherwise for the result of a formula
    std::string payload;
};

struct Forged {
    std::string streamed, payload;
};

template <typename Number> std::string bytes_of(const Number& number)
{
    return {reinterpret_cast<const char*>(&number), sizeof number};
}

// @param answer_to  returns what is streamed and answered
template <typename AnswerTo> void serve_forged(const AnswerTo& answer_to)
{
    void* memory = mmap(nullptr, channel_size, PROT_READ | PROT_WRITE, MAP_SHARED, 3, 0);
    if (memory == MAP_FAILED) return; // without a client
    auto& words = *static_cast<ChannelWords*>(memory);
    char* const stream = static_cast<char*>(memory) + stream_start;
    char* const payload = static_cast<char*>(memory) + payload_start;
    for (std::uint32_t turn = 1;; ++turn) {
        // The first answer is a greeting. A sleep here would make the answers too late.
        while (turn > 1 && words.request != turn)
            __builtin_ia32_pause();
        const Forged forged = turn == 1 ? Forged{"", bytes_of(greeting())}
                                        : answer_to({words.kind != 0, {payload, 4096}});
        std::memcpy(stream, forged.streamed.data(), forged.streamed.size());
        std::memcpy(payload, forged.payload.data(), forged.payload.size());
        words.streamed = static_cast<std::uint32_t>(forged.streamed.size());
        words.status = 0; // done
        words.reply_size = forged.payload.size();
        std::atomic_thread_fence(std::memory_order_seq_cst);
        words.reply = turn;
    }
}
