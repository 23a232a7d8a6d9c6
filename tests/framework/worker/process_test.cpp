// SPDX-License-Identifier: MIT
// Tests of a worker's process: what it inherits, when it ends, how long it may take.
#include "attack.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "worker/protocol/wire.hpp"

#include <atomic>
#include <sched.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace rigor {

TEST_CASE("worker: it gets three descriptors and hardly an environment")
{
    const int leaked = dup(0); // a descriptor without close-on-exec
    setenv("RIGOR_SECRET", "expected values", 1);
    use_worker(attack("inspect"), {}, tight());
    attacked();
    const std::string printed = worker().take_output();
    close(leaked);
    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);) {
        CAPTURE(line);
        REQUIRE(line.find("RIGOR_SECRET") == std::string::npos);
        if (line.rfind("descriptor", 0) == 0) REQUIRE(std::stoi(line.substr(10)) <= 2);
    }
    REQUIRE(printed.find("descriptor 1\n") != std::string::npos);
}

TEST_CASE("worker: it dies with its client")
{
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    const int client = fork();
    if (client == 0) {
        Worker orphan(attack("inspect"), tight());
        wire::Bytes argument;
        wire::encode(argument, Vector3d(1, 2, 3));
        orphan.call(FormulaIndex::cross_matrix, argument, 72);
        const std::string printed = orphan.take_output();
        const int pid = std::stoi(printed.substr(printed.find(' ')));
        _exit(write(ends[1], &pid, sizeof pid) == sizeof pid ? 0 : 1);
    }
    int pid = 0;
    REQUIRE(read(ends[0], &pid, sizeof pid) == sizeof pid);
    waitpid(client, nullptr, 0);
    close(ends[0]);
    close(ends[1]);
    REQUIRE(dies_soon(pid));
}

TEST_CASE("worker: a slow call may take a multiple of what the oracle takes")
{
    use_worker(attack("slow"), {}, tight());
    REQUIRE_THROWS_AS(attacked(), WorkerFailure);
    use_worker(attack("slow"), attack("slow"), tight());
    REQUIRE(attacked() == 7 * Matrix3d::Identity());

    use_worker(attack("endless_loop"), attack("slow"), [] {
        Limits limits = tight();
        limits.multiple = 1;
        return limits;
    }());
    try {
        attacked();
        FAIL("it was answered");
    } catch (const WorkerFailure& failure) {
        const std::string text = failure.what();
        CAPTURE(text);
        REQUIRE(text.find("(the reference took ") != std::string::npos);
    }
    REQUIRE(next_call_is_answered());
}

namespace {

/// Threads that compute on one processor and leave little of its time to a process of the lowest
/// scheduling class.
class BusyProcessor {
public:
    explicit BusyProcessor(int process)
    {
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(sched_getcpu(), &one);
        const sched_param none = {};
        if (sched_setaffinity(process, sizeof one, &one) != 0 ||
            sched_setscheduler(process, SCHED_IDLE, &none) != 0)
            throw std::runtime_error("cannot leave a process without a processor");
        for (int i = 0; i < 8; ++i)
            threads_.emplace_back([this, one] {
                sched_setaffinity(0, sizeof one, &one);
                while (!done_) {
                }
            });
    }
    ~BusyProcessor()
    {
        done_ = true;
        for (std::thread& thread : threads_)
            thread.join();
    }
    BusyProcessor(const BusyProcessor&) = delete;
    BusyProcessor& operator=(const BusyProcessor&) = delete;

private:
    std::atomic<bool> done_ = false;
    std::vector<std::thread> threads_;
};

} // namespace

TEST_CASE("worker: a process that gets no processor is not late")
{
    Limits limits = tight();
    limits.call = Seconds(0.1);
    use_worker(attack("inspect"), {}, limits);
    attacked();
    const std::string printed = worker().take_output();
    const BusyProcessor busy(std::stoi(printed.substr(printed.find(' '))));
    for (int i = 0; i < 20; ++i) {
        const Clock::time_point start = Clock::now();
        try {
            attacked();
        } catch (const WorkerFailure& failure) {
            // A tenth of the time counts in which a process waits for a processor. So only a wait
            // that lasts ten times the limit is late.
            CAPTURE(failure.what());
            REQUIRE(Seconds(Clock::now() - start) > 9 * limits.call);
            return;
        }
    }
}

TEST_CASE("worker: an oracle that fails leaves the floor")
{
    for (const std::string oracle : {"segmentation_fault", "crash_in_initializer"}) {
        use_worker(attack("endless_loop"), attack(oracle), tight());
        REQUIRE_THROWS_WITH(attacked(), "A1.1 cross_matrix did not return within 0.6 s");
        REQUIRE(next_call_is_answered());
    }
}

TEST_CASE("worker: a program that is not there is our fault")
{
    use_worker("/nowhere/worker");
    REQUIRE_THROWS_AS(next_call_is_answered(), std::system_error);
}

TEST_CASE("worker: a build under a strict umask can be graded by root, too")
{
    if (is_sanitized) return; // there are no walls then
    const testing::TemporaryFolder folder;
    const auto copy = folder.path() / "worker";
    std::filesystem::copy_file(RIGOR_BINARY_DIR "/bin/worker_reference", copy);
    std::filesystem::permissions(copy, std::filesystem::perms::owner_all);
    Limits limits = tight();
    limits.trust = Trust::students;
    use_worker(copy, {}, limits);
    REQUIRE(next_call_is_answered());
}

TEST_CASE("worker: a formula that did not return twice is not asked again")
{
    use_worker(attack("endless_loop"), {}, tight());
    for (int i = 0; i < 2; ++i)
        REQUIRE_THROWS_WITH(attacked(), "A1.1 cross_matrix did not return within 0.6 s");
    REQUIRE_THROWS_WITH(attacked(),
                        "A1.1 cross_matrix did not return twice, so it is not asked again");
    REQUIRE(next_call_is_answered());
}

TEST_CASE("worker: a formula that is nowhere defined says so")
{
    use_worker(RIGOR_BINARY_DIR "/bin/worker_nothing");
    REQUIRE_THROWS_WITH(attacked(), "A1.1 cross_matrix is not defined");
}

} // namespace rigor
