// SPDX-License-Identifier: MIT
#include "attack.hpp"
#include "scene/trajectory/reader.hpp"
#include "support/catch.hpp"
#include "worker/protocol/wire.hpp"

namespace rigor::client_test {

namespace {

const std::string ball = R"({
  "gravity": [0, -10, 0], "time_step": 0.01, "end": 2, "frames_per_second": 50,
  "bodies": [{"name": "ball", "shape": {"sphere": {"radius": 0.5}}, "velocity": [1, 2, 3]}]
})";

/// The run of a scene in the current worker. If it fails, the frames before the failure are kept.
struct Run {
    std::vector<Frame> frames;
    bool complete = false;

    explicit Run(Record record = Record::every_step)
    {
        TrajectoryReader reader({[](const Scene&, const std::vector<RecordedBody>&) {},
                                 [this](Frame frame) { frames.push_back(std::move(frame)); },
                                 [](const Counters&) {}});
        try {
            worker().run_scene(ball, "ball", record,
                               [&](std::span<const std::byte> bytes) { reader.feed(bytes); });
        } catch (...) {
            failure = std::current_exception();
        }
        complete = reader.complete();
    }
    std::exception_ptr failure;
};

void use_attack(const std::string& name)
{
    Limits limits = tight();
    limits.scene = Seconds(0.6);
    use_worker(attack(name), {}, limits);
}

WorkerFailure failure_of(const Run& run)
{
    REQUIRE(run.failure);
    REQUIRE_FALSE(run.complete);
    try {
        std::rethrow_exception(run.failure);
    } catch (const WorkerFailure& failure) {
        return failure;
    }
}

} // namespace

TEST_CASE("worker: a scene arrives whole")
{
    use_worker(RIGOR_BINARY_DIR "/bin/worker_reference");
    for (int repeat = 0; repeat < 3; ++repeat) {
        const Run every_step, frames(Record::frames);
        REQUIRE(every_step.complete);
        REQUIRE(every_step.frames.size() == 201);
        REQUIRE(frames.complete);
        REQUIRE(frames.frames.size() == 101);
        for (std::size_t n = 0; n < every_step.frames.size(); ++n)
            REQUIRE(every_step.frames[n].step == static_cast<std::int64_t>(n));
    }
}

TEST_CASE("worker: advancing each state of a run leads to the next one bit by bit")
{
    use_worker(RIGOR_BINARY_DIR "/bin/worker_reference");
    const Run run;
    REQUIRE(run.complete);
    std::vector<Worker::Start> starts;
    // There are so many starts that they need several requests.
    for (int repeat = 0; repeat < 60; ++repeat)
        for (std::size_t n = 0; n + 3 < run.frames.size(); ++n)
            starts.emplace_back(run.frames[n].time, run.frames[n].bodies);
    const auto states = worker().advance(ball, "ball", starts, 3);
    REQUIRE(states.size() == starts.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
        wire::Bytes advanced, recorded;
        wire::encode(advanced, states[i]);
        wire::encode(recorded, run.frames[i % (run.frames.size() - 3) + 3].bodies);
        REQUIRE(advanced == recorded);
    }
}

TEST_CASE("worker: a crash in a scene leaves the frames up to there")
{
    use_attack("crash_in_scene");
    for (int repeat = 0; repeat < 2; ++repeat) {
        const Run run;
        REQUIRE(std::string(failure_of(run).what()) ==
                "scene ball crashed: segmentation fault, such as by an index outside of a list or "
                "endless recursion");
        REQUIRE(run.frames.size() > 20);
        REQUIRE(run.frames.size() <= 100);
    }
    REQUIRE(next_call_is_answered());
}

TEST_CASE("worker: an endless loop in a scene times out")
{
    use_attack("loop_in_scene");
    const Run run;
    REQUIRE(failure_of(run).cause == WorkerFailure::timed_out);
    REQUIRE(run.frames.size() > 20);
    REQUIRE(next_call_is_answered());
}

TEST_CASE("worker: a scene whose numbers are lost says which and leaves the frames up to there")
{
    use_attack("nan_in_scene");
    const Run run;
    REQUIRE(run.failure);
    REQUIRE_FALSE(run.complete);
    REQUIRE_THROWS_AS(std::rethrow_exception(run.failure), NotFinite);
    REQUIRE(run.frames.size() > 20);
    REQUIRE(next_call_is_answered());
}

TEST_CASE("worker: a scene that needs a stub names it")
{
    use_attack("stub_in_scene");
    const Run run;
    REQUIRE_THROWS_WITH(std::rethrow_exception(run.failure), "rotation::gravity_wrench");
    REQUIRE_FALSE(run.complete);
}

TEST_CASE("worker: whoever takes a trajectory may give up")
{
    use_worker(RIGOR_BINARY_DIR "/bin/worker_reference");
    struct Enough {};
    REQUIRE_THROWS_AS(worker().run_scene(ball, "ball", Record::every_step,
                                         [](std::span<const std::byte>) { throw Enough(); }),
                      Enough);
    REQUIRE(Run().complete);
}

} // namespace rigor::client_test
