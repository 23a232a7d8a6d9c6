// SPDX-License-Identifier: MIT
// Setup of the graded tests, which call the formulas of a worker. A failure of the worker becomes
// the verdict of the test case.
#include "formulas/table.hpp"
#include "support/catch.hpp"
#include "support/run.hpp"
#include "support/verdict.hpp"
#include "worker/failure.hpp"
#include "worker/proxy/proxy.hpp"

#include <optional>
#include <stdexcept>

namespace rigor::testing {

void prepare(const RunOptions& options)
{
    if (options.worker.empty())
        throw std::runtime_error("graded_tests: expected --worker FILE, the program to be tested");
    std::optional<std::filesystem::path> oracle;
    if (!options.oracle.empty()) oracle = options.oracle;
    use_worker(options.worker, oracle);
}

/// Starts a new worker process for each test case, so that no test case can affect the next one.
void begin_test_case()
{
    renew_worker();
}

namespace {

std::string note(std::string_view status, const std::string& text)
{
    verdict().status = status; // replaces earlier notes: this ended the test case
    verdict().expected = verdict().actual = "";
    return text;
}

} // namespace

} // namespace rigor::testing

CATCH_TRANSLATE_EXCEPTION(const rigor::NotImplemented& stub)
{
    return rigor::testing::note("not_implemented", rigor::describe(stub));
}

CATCH_TRANSLATE_EXCEPTION(const rigor::WorkerFailure& failure)
{
    std::string text = failure.what();
    if (!failure.output.empty()) text += "\nIt printed: " + failure.output;
    return rigor::testing::note(failure.status(), text);
}

CATCH_TRANSLATE_EXCEPTION(const rigor::NotFinite& failure)
{
    return rigor::testing::note("not_finite", failure.what());
}

// A failure of the oracle is not the student's fault.
CATCH_TRANSLATE_EXCEPTION(const rigor::OracleFailure& failure)
{
    return rigor::testing::note("internal_error", failure.what());
}
