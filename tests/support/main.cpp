// SPDX-License-Identifier: MIT
// The main function of every test program, and the stream of verdicts that grading reads.
#define CATCH_CONFIG_RUNNER
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include "support/catch.hpp"

#include "seeds/drawn_seed.hpp"
#include "support/largest_error.hpp"
#include "support/run.hpp"
#include "support/seeds.hpp"
#include "support/verdict.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <malloc.h>
#include <unistd.h>
#include <utility>

namespace rigor::testing {

namespace {

RunOptions options;
std::string passed_tag; // the tag of the test case before, if it passed

// A text of the verdict, of which the reader of the line needs the beginning. Values of a
// submission may be lists of millions of numbers, and a line that is too long is no verdict.
std::string beginning(std::string text)
{
    constexpr std::size_t longest = std::size_t{1} << 14; // [bytes]
    if (text.size() <= longest) return text;
    text.resize(longest);
    return text + " ...";
}

std::string text_of(const nlohmann::ordered_json& line)
{
    return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void send(const nlohmann::ordered_json& line)
{
    if (options.verdicts < 0) return;
    const std::string text = text_of(line);
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t n = write(options.verdicts, text.data() + sent, text.size() - sent);
        if (n <= 0) std::_Exit(3); // nobody reads the verdicts any more
        sent += static_cast<std::size_t>(n);
    }
}

// The task tag in a list of tags: "A2.14" in "[A2.14][inertia]".
std::string task_tag(const std::string& tags)
{
    for (std::size_t at = tags.find("[A"); at != std::string::npos; at = tags.find("[A", at + 1))
        if (std::isdigit(static_cast<unsigned char>(tags[at + 2])))
            return tags.substr(at + 1, tags.find(']', at) - at - 1);
    return "";
}

#ifdef RIGOR_CATCH_3
using ListenerBase = Catch::EventListenerBase;
using AssertionDone = void;
#else
using ListenerBase = Catch::TestEventListenerBase;
using AssertionDone = bool;
#endif

// Sends the begin and the verdict of each test case as JSON lines, in the form that
// framework/grading reads.
class VerdictStream : public ListenerBase {
public:
    using ListenerBase::ListenerBase;

    void testCaseStarting(const Catch::TestCaseInfo& info) override
    {
        verdict() = {};
        largest_error_in_tolerances() = 0;
        message_.clear();
        start_ = std::chrono::steady_clock::now();
        name_ = info.name;
        tags_ = info.tagsAsString();
        draw_first_seed(name_);
        send({{"begin", name_}, {"tag", task_tag(tags_)}});
        const std::string tag = task_tag(tags_);
        begin_test_case(tag, !tag.empty() && tag == passed_tag, stalled());
    }

    AssertionDone assertionEnded(const Catch::AssertionStats& stats) override
    {
        const Catch::AssertionResult& result = stats.assertionResult;
        if (!result.isOk() && message_.empty()) note_failure(result, stats.infoMessages);
        return AssertionDone();
    }

    void testCaseEnded(const Catch::TestCaseStats& stats) override
    {
        Verdict& v = verdict();
        const bool failed = stats.totals.assertions.failed > 0;
        if (!failed && stats.totals.assertions.total() > 0) {
            v = Verdict();
            v.status = "passed";
        } else if (!failed) {
            // No answer was like those that the test is about. If those of the reference are not
            // either, the test is wrong, and grading finds out with the seed.
            v.status = "failed";
            message_ = "no answer could be checked: the formula gave none for which the law holds";
        }
        if (v.status.empty()) v.status = "failed";
        passed_tag = v.status == "passed" ? task_tag(tags_) : "";
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
        const CostSoFar cost = cost_so_far();
        send({{"tag", task_tag(tags_)},
              {"name", name_},
              {"status", v.status},
              {"message", beginning(message_)},
              {"expected", beginning(v.expected)},
              {"actual", beginning(v.actual)},
              {"error", v.error},
              {"tolerance", v.tolerance},
              {"largest_error", largest_error_in_tolerances()},
              {"class", v.tolerance_class},
              {"place", v.place},
              {"seed", v.seed},
              {"mistake", mistake()},
              {"spent", cost.spent},
              {"cost", cost.report},
              {"hidden", tags_.find("[hidden]") != std::string::npos},
              {"seconds", seconds.count()}});
    }

private:
    // The verdict that is sent if the test case that begins now computes without end.
    StalledLine stalled() const
    {
        const char* formula = "FORMULA";
        const CostSoFar cost = cost_so_far();
        const std::string text = text_of(
            {{"tag", task_tag(tags_)},
             {"name", name_},
             {"status", "timed_out"},
             {"message", std::string("does not come to its end: the engine computes without end "
                                     "with the answers; the formula called last was ") +
                             formula},
             {"spent", cost.spent},
             {"cost", cost.report},
             {"hidden", tags_.find("[hidden]") != std::string::npos},
             {"seconds", options.stall},
             {"stalled", true}});
        const std::size_t at = text.find(formula);
        return {text.substr(0, at), text.substr(at + std::strlen(formula))};
    }

    // Why the answers of the worker are wrong; empty if they are right or if the reason is unknown.
    std::string mistake() const
    {
        const std::string& status = verdict().status;
        const bool is_wrong = status == "failed" || status == "not_finite";
        return is_wrong && options.verdicts >= 0 ? mistake_text(task_tag(tags_)) : "";
    }

    void note_failure(const Catch::AssertionResult& result,
                      const std::vector<Catch::MessageInfo>& infos)
    {
        if (result.hasMessage())
            message_ = std::string(result.getMessage());
        else
            message_ = std::string(result.getExpression());
        if (verdict().expected.empty() && result.hasExpandedExpression())
            verdict().actual = result.getExpandedExpression();
        for (const Catch::MessageInfo& info : infos)
            if (info.message != message_) message_ += "\n" + info.message;
        const std::string call = last_call_text();
        if (!call.empty()) message_ += "\nthe last call was " + call;
    }

    std::string name_, tags_, message_;
    std::chrono::steady_clock::time_point start_;
};

// Takes the option `name` and its value out of the arguments.
// @return the value, or an empty string if the option is not there
std::string take(std::vector<char*>& arguments, const char* name)
{
    for (std::size_t i = 1; i + 1 < arguments.size(); ++i)
        if (std::strcmp(arguments[i], name) == 0) {
            const std::string value = arguments[i + 1];
            arguments.erase(arguments.begin() + static_cast<long>(i),
                            arguments.begin() + static_cast<long>(i) + 2);
            return value;
        }
    return "";
}

// What follows a specification for the parts of its test cases, in the order in which they run. A
// student is shown the first broken law, so the laws of the topic come before the universal ones.
// Without the parts, the order of the folders would be that of the linker.
constexpr const char* parts[] = {"~[universal]~[hidden]", "[universal]~[hidden]", "[hidden]"};

// Runs the test cases of each specification in turn, those of the first one first. The grader gives
// one for each task, so that the test cases of a task follow each other.
int run_in_turn(int count, char** arguments)
{
    Catch::Session session;
    if (const int error = session.applyCommandLine(count, arguments)) return error;
    Catch::ConfigData config = session.configData();
    if (options.verdicts < 0) return session.run();
    int failed = 0;
    for (const std::string& specification : std::exchange(config.testsOrTags, {}))
        for (const char* part : parts) {
            config.testsOrTags = {specification + part};
            session.useConfigData(config);
            failed += session.run();
            if (failed > 0 && config.abortAfter > 0) return failed; // option --abort
        }
    return std::min(failed, 255); // the largest exit status
}

} // namespace

} // namespace rigor::testing

#ifdef RIGOR_CATCH_3
CATCH_REGISTER_LISTENER(rigor::testing::VerdictStream)
#else
using rigor::testing::VerdictStream;
CATCH_REGISTER_LISTENER(VerdictStream)
#endif

int main(int count, char** values)
{
    using namespace rigor::testing;
    std::vector<char*> arguments(values, values + count);
    options.worker = take(arguments, "--worker");
    options.oracle = take(arguments, "--oracle");
    options.others = take(arguments, "--others");
    options.spent = take(arguments, "--spent");
    const std::string verdicts = take(arguments, "--verdicts");
    const std::string seed = take(arguments, "--seed"), stall = take(arguments, "--stall");
    if (!verdicts.empty()) options.verdicts = std::atoi(verdicts.c_str());
    if (!stall.empty()) options.stall = std::atof(stall.c_str());
    if (!seed.empty())
        set_first_seed(static_cast<unsigned>(std::strtoul(seed.c_str(), nullptr, 10)));
    // The key comes by the environment, which other users cannot read, and goes no further.
    if (const char* key = std::getenv(rigor::seed_key_variable)) {
        set_seed_key(key);
        unsetenv(rigor::seed_key_variable);
    }
    // Memory that is freed stays with this process: a list of a million entries would otherwise be
    // mapped, filled by the kernel and unmapped for each test.
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    try {
        prepare(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    const int failed = run_in_turn(static_cast<int>(arguments.size()), arguments.data());
    send({{"end", true}});
    return failed;
}
