// SPDX-License-Identifier: MIT
// The loop of a worker: it takes one request after the other from the shared memory, and answers.
#pragma once

#include "worker/engine/scenes.hpp"
#include "worker/protocol/channel.hpp"
#include "worker/protocol/wire.hpp"

#include <string>

namespace rigor {

/// Thrown by a call of a formula that the implementation does not define.
struct MissingFormula {
    unsigned index;
};

/// Answers the requests of one client until the process is killed.
class Server {
public:
    Server(Channel& channel, bool is_reference) : channel_(channel), is_reference_(is_reference) {}

    /// Tells the client that the worker is ready.
    void greet();
    void serve_next();

private:
    void answer();
    void run_scenes(Request kind, std::span<const std::byte> payload);
    void await_request();
    void stream(std::span<const std::byte> bytes);
    FormulaSet given_formulas() const;
    void take_answer(FormulaIndex formula, wire::Bytes& answer);
    void take_bytes(std::span<std::byte> bytes);
    void reply(ReplyStatus status, std::span<const std::byte> payload);
    void reply_text(ReplyStatus status, std::string text);

    Channel& channel_;
    bool is_reference_;
    wire::Bytes answer_; // the current answer; its memory is kept for the next one
    // The number of bytes that the scene has streamed, and this number when the client was last
    // woken because of enough new bytes, both modulo 2^32.
    std::uint32_t streamed_ = 0, announced_ = 0;
    std::uint32_t used_ = 0;     // number of bytes read from the client's answers to the scene
    std::uint32_t sequence_ = 1; // number of the current request; the greeting has number 1
};

/// The main function of a worker: takes the shared memory from its client and serves forever.
/// @param is_reference  whether the formulas are the reference's, see SceneRequest
/// @return the exit status; the function returns only if no client started the worker
int run_worker(bool is_reference);

} // namespace rigor
