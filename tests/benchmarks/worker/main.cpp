// SPDX-License-Identifier: MIT
// The cost of running an implementation in a separate process. One formula is called directly and
// through the proxy; for comparison the same number of bytes goes through a pair of pipes. The
// start of a new worker is timed as well, without walls and behind those of each tier that is
// possible here.
#include "sandbox/tier.hpp"
#include "support/bench/bench.hpp"
#include "worker/proxy/proxy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

// The reference's pipeline.cpp, compiled a second time in this namespace.
namespace direct {

double kinetic_energy(double mass, const Eigen::Vector3d& velocity, const Eigen::Matrix3d& inertia,
                      const Eigen::Vector3d& angular_velocity);

} // namespace direct

using namespace rigor;

namespace {

constexpr int rounds = 21, calls = 2000, starts = 51;

const Matrix3d I = Vector3d(1, 2, 3).asDiagonal();
const Vector3d w(0.1, 0.2, 0.3);

/// A different velocity for each call, so that the compiler cannot move a call out of the loop.
Vector3d velocity(int i)
{
    return {0.1 * (i % 7), -1 - 0.01 * (i % 11), 0.3};
}

/// A child process that reads 128 bytes, the size of the arguments, and replies with 8 bytes, the
/// size of the result.
class PipePair {
public:
    PipePair()
    {
        if (pipe(there_) != 0 || pipe(back_) != 0) throw std::runtime_error("no pipe");
        child_ = fork();
        if (child_ != 0) return;
        close(there_[1]); // so that the input ends when the parent closes it
        std::byte bytes[128] = {};
        while (read(there_[0], bytes, sizeof bytes) == sizeof bytes &&
               write(back_[1], bytes, 8) == 8) {
        }
        _exit(0);
    }
    ~PipePair()
    {
        for (const int fd : {there_[0], there_[1], back_[0], back_[1]})
            close(fd);
        waitpid(child_, nullptr, 0);
    }
    PipePair(const PipePair&) = delete;
    PipePair& operator=(const PipePair&) = delete;

    void round_trip()
    {
        std::byte bytes[128] = {};
        if (write(there_[1], bytes, sizeof bytes) != sizeof bytes || read(back_[0], bytes, 8) != 8)
            throw std::runtime_error("the pipe broke");
    }

private:
    int there_[2], back_[2];
    pid_t child_;
};

struct Samples {
    std::vector<double> times; // [s]

    double quantile(double q)
    {
        std::sort(times.begin(), times.end());
        const double at = q * static_cast<double>(times.size() - 1);
        return times[static_cast<std::size_t>(at)];
    }

    Bench::Row row(const std::string& what, double unit)
    {
        return {{"what", what},
                {"median", quantile(0.5) / unit},
                {"90 %", quantile(0.9) / unit},
                {"99 %", quantile(0.99) / unit},
                {"slowest", quantile(1) / unit},
                {"times", static_cast<double>(times.size())}};
    }
};

template <class Call> void sample(Samples& samples, int count, const Call& call)
{
    for (int i = 0; i < count; ++i)
        samples.times.push_back(seconds([&] { call(i); }));
}

void check_same_answers()
{
    for (int i = 0; i < 77; ++i)
        if (kinetic_energy(2, velocity(i), I, w) != direct::kinetic_energy(2, velocity(i), I, w))
            throw std::runtime_error("the worker answers otherwise than the function itself");
}

// The time from the start of a worker behind the walls of a tier to its first answer.
void measure_walls(Bench& bench, Tier tier, const char* name, double limit)
{
    if (!is_possible(tier, possible_walls())) return;
    setenv("RIGOR_TIER", name, 1);
    Limits limits;
    limits.trust = Trust::students;
    use_worker(RIGOR_BINARY_DIR "/bin/worker_reference", {}, limits);
    Samples first_answer;
    for (int i = 0; i < starts; ++i) {
        renew_worker();
        sample(first_answer, 1, [](int k) { kinetic_energy(2, velocity(k), I, w); });
    }
    Samples call; // behind the filter of system calls each wake-up takes longer
    sample(call, rounds * calls, [](int k) { kinetic_energy(2, velocity(k), I, w); });
    bench.row(first_answer.row("start to first answer, tier " + description(tier) + " [ms]", 1e-3));
    bench.row(call.row(std::string("call through the proxy, tier ") + name + " [µs]", 1e-6));
    bench.reach({std::string("start to first answer in tier ") + name + ", median [ms]",
                 first_answer.quantile(0.5) * 1e3, limit});
}

} // namespace

int main(int argc, char** argv)
{
    Bench bench("worker");
    PipePair pipes;
    use_worker(RIGOR_BINARY_DIR "/bin/worker_reference");
    check_same_answers();

    Samples direct_call, proxy_call, pipe, after_pause, start;
    const auto call = [](int i) { kinetic_energy(2, velocity(i), I, w); };
    double sum = 0;
    for (int round = 0; round < rounds; ++round) {
        // A direct call is shorter than reading the clock, so that many calls are timed together.
        direct_call.times.push_back(seconds([&] {
                                        for (int i = 0; i < calls; ++i)
                                            sum += direct::kinetic_energy(2, velocity(i), I, w);
                                    }) /
                                    calls);
        sample(proxy_call, calls, call);
        sample(pipe, calls / 10, [&](int) { pipes.round_trip(); });
    }
    for (int i = 0; i < 100; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        sample(after_pause, 1, call);
    }
    for (int i = 0; i < starts; ++i) {
        renew_worker();
        sample(start, 1, [](int) { worker().start(); });
    }
    if (!std::isfinite(sum)) return 1;

    bench.row(direct_call.row("direct call [µs]", 1e-6));
    bench.row(proxy_call.row("call through the proxy [µs]", 1e-6));
    bench.row(after_pause.row("the same after a pause of 2 ms [µs]", 1e-6));
    bench.row(pipe.row("the same bytes through pipes [µs]", 1e-6));
    bench.row(start.row("a fresh worker, start to ready [ms]", 1e-3));
    bench.reach({"formula call through the proxy, median [µs]", proxy_call.quantile(0.5) * 1e6, 1});
    measure_walls(bench, Tier::b, "B", 6);
    measure_walls(bench, Tier::a, "A", 12);
    bench.note("kinetic_energy of the reference; worker and client share the machine as it is, "
               "not pinned; the limits are for two processors with nothing else to do");
    return bench.finish(wants_json(argc, argv));
}
