// SPDX-License-Identifier: MIT
// The exchange of questions and replies with one worker process. Each question is answered in
// bounded time, or `Broken` is thrown and the session cannot be used any more.
#pragma once

#include "scene/trajectory/writer.hpp"
#include "worker/process.hpp"

#include <functional>

namespace rigor {

/// The time that a question may take. At first the limit is a fixed time, the floor. When the floor
/// is used up, the oracle (the worker of the reference) is asked how long it takes for the same
/// question, and the limit may grow.
struct Allowance {
    using Seconds = std::chrono::duration<double>;

    Seconds limit;       // the floor, until `used_up` raises it
    double multiple = 0; // the limit grows to `multiple` times the reference's time
    /// Measures the reference's time. The function is empty if there is no reference, and after the
    /// measurement.
    std::function<Seconds()> reference = {};
    bool by_silence = false; // whether the time starts again at 0 with each part of the stream
    Seconds waited = {}, reference_took = {};

    bool used_up();
    std::string verdict() const;
};

struct Question {
    Request kind;
    std::uint32_t argument = 0;
    std::span<const std::byte> payload;
    std::size_t largest = 0;        // largest size of the reply [bytes]
    std::size_t longest_stream = 0; // largest size of all that is streamed [bytes]
    const ByteSink* sink = nullptr; // in `Session::ask`, takes what is streamed; may be nullptr
    FormulaSet given = {};          // formulas whose answers the scene gets by `Session::give`
};

/// A reply as the worker wrote it. Only its status and its size have been checked.
struct Reply {
    ReplyStatus status;
    Bytes payload;
};

class Session {
public:
    Session(const std::filesystem::path& executable, const Limits& limits);

    /// Waits until the process is ready. @throws Broken, std::system_error
    void await_greeting(Allowance& allowance);

    /// Begins to end the process, without waiting for its end. The destructor waits.
    void begin_end() { process_.begin_end(); }

    /// See `Process::on_processor`.
    Allowance::Seconds on_processor() const { return process_.on_processor(); }

    /// Asks a question and waits for the reply, which is valid until the next question.
    /// @throws Broken, what the sink throws; after either, the session cannot be used any more
    const Reply& ask(const Question& question, Allowance& allowance);

    /// Does what `ask` does, in separate calls. `begin` sends the question, whose sink is not used.
    /// Then the caller calls `next_part` until it returns nothing, and `take_reply` once.
    /// @throws Broken
    void begin(const Question& question);
    /// Waits for the next part of the stream. @return the part; it is empty if the reply has come
    Bytes next_part(Allowance& allowance);
    const Reply& take_reply();

    /// Gives the worker an encoded answer that its scene waits for. This call waits only while the
    /// ring buffer of such answers is full. @throws Broken
    void give(FormulaIndex formula, std::span<const std::byte> answer, Allowance& allowance);

    /// What the worker had streamed before a failure (`Broken`), without the parts that were read
    /// already.
    Bytes rest_of_stream();

    /// What the worker printed since the last call of this function; of a long text only the first
    /// `Limits::output_kept` bytes.
    std::string take_output();

private:
    Allowance::Seconds counted(Allowance::Seconds passed, bool is_done);
    Allowance::Seconds counted_first(Allowance::Seconds passed, bool has_come);
    Bytes read_stream(std::uint32_t n);
    Bytes take_stream();
    void give_bytes(std::span<const std::byte> bytes, Allowance& allowance);
    void await_room(std::uint32_t used, Allowance& allowance);
    void collect_output();

    Limits limits_;
    Process process_;
    std::uint32_t sequence_ = 1; // number of the last question; number 1 stands for the greeting
    std::uint32_t taken_ = 0;    // how much of the stream was read, modulo 2^32 [bytes]
    std::uint32_t given_ = 0;    // how much was given to the scene, modulo 2^32 [bytes]
    bool gives_ = false;         // whether the client gives answers to the current scene
    std::size_t streamed_ = 0;   // how much of the stream was read, not modulo 2^32 [bytes]
    std::size_t largest_ = 0, longest_stream_ = 0; // limits of the last question [bytes]
    std::size_t printed_ = 0;             // how much was printed since the last question [bytes]
    Process::Progress seen_;              // at the last look
    Allowance::Seconds first_waits_ = {}; // those that do not count yet
    Reply reply_{};                       // a member, so that the next reply uses its memory again
    std::string output_;
};

} // namespace rigor
