// SPDX-License-Identifier: MIT
// The conversation with one worker process: one question after the other, each answered in bounded
// time, or the conversation is broken.
#pragma once

#include "scene/trajectory/writer.hpp"
#include "worker/process.hpp"

namespace rigor {

/// How long a question may still take. The oracle is asked only once the floor is used up.
struct Allowance {
    using Seconds = std::chrono::duration<double>;

    Seconds limit;                           // so far: the floor
    double multiple = 0;                     // times what the reference takes
    std::function<Seconds()> reference = {}; // empty: there is none, or it has been asked
    bool by_silence = false;                 // what arrives starts the time anew
    Seconds waited = {}, reference_took = {};

    bool used_up();
    std::string verdict() const;
};

struct Question {
    Request kind;
    std::uint32_t argument = 0;
    std::span<const std::byte> payload;
    std::size_t largest = 0;        // bytes an answer can have
    const ByteSink* sink = nullptr; // for the trajectory
};

/// As the worker wrote it: nothing of it has been checked but its size.
struct Reply {
    Status status;
    Bytes payload;
};

class Session {
public:
    Session(const std::filesystem::path& executable, const Limits& limits);

    /// Waits until the process is ready. @throws Broken
    void await_greeting();

    /// @throws Broken, what the sink throws: of no use any more then
    Reply ask(const Question& question, Allowance& allowance);

    /// What came of the trajectory before the conversation broke.
    Bytes rest_of_stream();

    /// The beginning of what was printed since the last call of this.
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
    std::uint32_t sequence_ = 1; // the last question's; the first asks whether it is ready
    std::uint32_t taken_ = 0;    // how much of the stream, modulo 2^32 [bytes]
    std::size_t handed_on_ = 0;  // how much of the stream [bytes]
    std::size_t printed_ = 0;    // since the last question [bytes]
    std::string output_;
};

} // namespace rigor
