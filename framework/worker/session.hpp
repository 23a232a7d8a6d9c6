// SPDX-License-Identifier: MIT
// The conversation with one worker process. Each question is answered in bounded time, or the
// conversation is broken.
#pragma once

#include "scene/trajectory/writer.hpp"
#include "worker/process.hpp"

namespace rigor {

/// The time that a question may take. The oracle is asked only after the floor is used up.
struct Allowance {
    using Seconds = std::chrono::duration<double>;

    Seconds limit;                           // the floor at first
    double multiple = 0;                     // factor for the time of the reference
    std::function<Seconds()> reference = {}; // empty if there is none or it has been asked
    bool by_silence = false;                 // whether a part of the trajectory restarts the time
    Seconds waited = {}, reference_took = {};

    bool used_up();
    std::string verdict() const;
};

struct Question {
    Request kind;
    std::uint32_t argument = 0;
    std::span<const std::byte> payload;
    std::size_t largest = 0;        // largest size of an answer [bytes]
    const ByteSink* sink = nullptr; // takes the trajectory
};

/// A reply as the worker wrote it. Only its size has been checked.
struct Reply {
    Status status;
    Bytes payload;
};

class Session {
public:
    Session(const std::filesystem::path& executable, const Limits& limits);

    /// Waits until the process is ready. @throws Broken
    void await_greeting();

    /// Asks a question and waits for the reply.
    /// @throws Broken, what the sink throws; the session cannot be used any more then
    Reply ask(const Question& question, Allowance& allowance);

    /// The rest of the trajectory that came before the conversation broke.
    Bytes rest_of_stream();

    /// The beginning of what was printed since the last call of this function.
    std::string take_output();

private:
    void await_reply(Allowance& allowance, const ByteSink* sink);
    Allowance::Seconds usable(Allowance::Seconds passed,
                              std::optional<Allowance::Seconds>& starved) const;
    Reply take_reply(std::size_t largest);
    bool hand_on_stream(const ByteSink& sink);
    void collect_output();

    Limits limits_;
    Process process_;
    std::uint32_t sequence_ = 1; // number of the last question; 1 asks whether it is ready
    std::uint32_t taken_ = 0;    // how much of the stream was read, modulo 2^32 [bytes]
    std::size_t handed_on_ = 0;  // how much of the stream was passed on [bytes]
    std::size_t printed_ = 0;    // how much was printed since the last question [bytes]
    std::string output_;
};

} // namespace rigor
