// SPDX-License-Identifier: MIT
// The formulas as functions that ask a worker. Link the library `proxy`, say which worker, and call
// `combine(a, b)`: the same headers, an implementation in another process.
#pragma once

#include "worker/client.hpp"

#include <filesystem>
#include <optional>

namespace rigor {

/// From now on the formulas ask this worker. The oracle, if there is one, says how long a slow call
/// may take, and answers `by_reference`.
void use_worker(const std::filesystem::path& executable,
                const std::optional<std::filesystem::path>& oracle = {}, const Limits& limits = {});

/// The worker that the formulas ask. @throws std::logic_error before use_worker
Worker& worker();

/// The worker that runs the reference; nullptr if there is none.
Worker* oracle();

/// A clean process for the next call.
void renew_worker();

/// The reference fails: never the fault of the implementation under test.
struct OracleFailure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Lets the formulas ask the oracle as long as it lives.
class AskOracle {
public:
    AskOracle();
    ~AskOracle();
    AskOracle(const AskOracle&) = delete;
    AskOracle& operator=(const AskOracle&) = delete;
};

/// `by_reference([&] { return combine(a, b); })`: what the reference answers. @throws OracleFailure
template <class Call> auto by_reference(const Call& call)
{
    const AskOracle ask;
    try {
        return call();
    } catch (const WorkerFailure& failure) {
        throw OracleFailure(std::string("the reference: ") + failure.what());
    } catch (const NotFinite& failure) {
        throw OracleFailure(std::string("the reference: ") + failure.what());
    } catch (const NotImplemented& failure) {
        throw OracleFailure(std::string("the reference: not implemented: ") + failure.what());
    }
}

} // namespace rigor
