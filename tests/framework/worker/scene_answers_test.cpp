// SPDX-License-Identifier: MIT
// Scenes that our engine runs with the answers of a worker, which is hostile in most of them.
#include "attack.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/trajectory/reader.hpp"
#include "support/catch.hpp"
#include "worker/protocol/wire.hpp"
#include "worker/proxy/scenes.hpp"

namespace rigor {

namespace {

const Scene& ball()
{
    static const Scene scene = parse_scene(R"({
  "gravity": [0, -10, 0], "time_step": 0.01, "end": 2, "frames_per_second": 50,
  "bodies": [{"name": "ball", "shape": {"sphere": {"radius": 0.5}}, "velocity": [1, 2, 3]}]
})",
                                           "ball");
    return scene;
}

/// The frames of a run as bytes, and how it ended.
struct Run {
    std::vector<wire::Bytes> frames;
    bool complete = false;
    std::exception_ptr failure;

    std::string what() const
    {
        try {
            if (failure) std::rethrow_exception(failure);
        } catch (const std::exception& exception) {
            return exception.what();
        }
        return "";
    }
};

template <class Simulate> Run run(const Simulate& simulate)
{
    Run result;
    TrajectoryReader reader(
        {[](const Scene&, const std::vector<RecordedBody>&) {},
         [&](const Frame& frame) { wire::encode(result.frames.emplace_back(), frame.bodies); },
         [](const Counters&) {}});
    try {
        simulate([&](std::span<const std::byte> bytes) { reader.feed(bytes); });
    } catch (...) {
        result.failure = std::current_exception();
    }
    result.complete = reader.complete();
    return result;
}

Run run_with(const std::string& worker_file)
{
    Limits limits = tight();
    limits.scene = Seconds(0.6);
    use_worker(worker_file, {}, limits);
    return run(
        [](const ByteSink& sink) { run_scene_with_worker(ball(), Record::every_step, sink); });
}

constexpr const char* solved = RIGOR_BINARY_DIR "/bin/worker_reference";

Run honest()
{
    return run_with(solved);
}

/// A run where the reference answers all formulas except those in `own`.
Run followed(const std::string& worker_file, const std::vector<FormulaIndex>& own,
             const Scene& scene = ball(), const Limits& limits = tight())
{
    use_worker(worker_file, solved, limits);
    FormulaSet others = FormulaSet().set();
    for (const FormulaIndex formula : own)
        others.reset(static_cast<unsigned>(formula));
    replace_by_reference(others);
    Run result =
        run([&](const ByteSink& sink) { run_scene_with_worker(scene, Record::every_step, sink); });
    replace_by_reference({});
    return result;
}

bool begins_as(const Run& run, const Run& other)
{
    return run.frames.size() <= other.frames.size() &&
           std::equal(run.frames.begin(), run.frames.end(), other.frames.begin());
}

} // namespace

TEST_CASE("scene answers: our engine makes the same bits as the worker's")
{
    const Run ours = honest();
    REQUIRE(ours.complete);
    REQUIRE(ours.frames.size() == 201);
    const Run theirs = run([](const ByteSink& sink) {
        worker().run_scene(ball().text, ball().name, Record::every_step, sink);
    });
    REQUIRE(ours.frames == theirs.frames);
}

TEST_CASE("scene answers: a worker advances states as in a run")
{
    const Run run = honest();
    const std::vector<Moment> start = {
        {1.0, wire::decode_all<std::vector<RigidState>>(run.frames[100])}};
    for (int repeat = 0; repeat < 3; ++repeat) {
        wire::Bytes after;
        wire::encode(after, worker().advance(ball().text, ball().name, start, 5).at(0));
        REQUIRE(after == run.frames[105]);
        REQUIRE(next_call_is_answered());
    }
}

TEST_CASE("scene answers: a failure names the formula and keeps what was before it")
{
    const Run right = honest();
    const auto expect = [&](const char* name, const std::string& text) {
        const Run run = run_with(attack(name).string());
        CAPTURE(name);
        REQUIRE(run.what() == text);
        REQUIRE_FALSE(run.complete);
        REQUIRE(run.frames.size() > 20);
        REQUIRE(begins_as(run, right));
        REQUIRE(next_call_is_answered());
    };
    expect("crash_in_scene", "A3.14 gravity_wrench in scene ball crashed: segmentation fault, such "
                             "as by an index outside of a list or endless recursion");
    expect("loop_in_scene", "A3.14 gravity_wrench in scene ball did not return within 0.6 s");
}

TEST_CASE("scene answers: a stub and a number that is lost are told as such")
{
    const Run stub = run_with(attack("stub_in_scene").string());
    REQUIRE(stub.what() == "rotation::gravity_wrench");
    const Run lost = run_with(attack("nan_in_scene").string());
    REQUIRE_THROWS_AS(std::rethrow_exception(lost.failure), NotFinite);
    REQUIRE(lost.frames.size() > 20);
    const Run nothing = run_with(RIGOR_BINARY_DIR "/bin/worker_nothing");
    REQUIRE_THROWS_AS(std::rethrow_exception(nothing.failure), FormulaMissing);
}

TEST_CASE("scene answers: a scene ends when its numbers leave their range")
{
    const Run far = run_with(attack("far_in_scene").string());
    REQUIRE(far.what() == "A3.14 gravity_wrench: force.y is -1e+199, beyond 1e+100");
    REQUIRE_THROWS_AS(std::rethrow_exception(far.failure), NotFinite);
    REQUIRE(far.frames.size() > 20);
    REQUIRE(begins_as(far, honest()));
    const Run followed_far =
        followed(attack("far_in_scene").string(), {FormulaIndex::gravity_wrench});
    REQUIRE(followed_far.what() == far.what()); // it does not reach the reference
}

TEST_CASE("scene answers: a forged stream moves nothing")
{
    const Run right = honest();
    const Run forged = run_with(attack("forge_scene").string());
    REQUIRE(forged.what().find("sent no answer: it is out of step") != std::string::npos);
    REQUIRE_FALSE(forged.complete);
    REQUIRE(begins_as(forged, right));
    REQUIRE(next_call_is_answered());
}

TEST_CASE("scene answers: an announced size fills no memory")
{
    const Scene box = parse_scene(R"({
  "gravity": [0, -10, 0], "time_step": 0.01, "end": 1, "contact": "one_at_a_time",
  "bodies": [{"name": "floor", "shape": {"plane": {}}, "static": true},
             {"name": "box", "shape": {"box": {"size": [1, 1, 1]}}, "position": [0, 0.5, 0]}]
})",
                                  "box");
    Limits limits = tight();
    use_worker(attack("announced_answer"), {}, limits);
    const Run forged =
        run([&](const ByteSink& sink) { run_scene_with_worker(box, Record::every_step, sink); });
    CAPTURE(forged.what());
    REQUIRE(forged.what().find("sent no answer: it is out of step") != std::string::npos);
    REQUIRE(next_call_is_answered());
}

TEST_CASE("scene answers: with answers that are given the bits are the same")
{
    const Run right = honest();
    using enum FormulaIndex;
    for (const std::vector<FormulaIndex>& own : std::vector<std::vector<FormulaIndex>>{
             {gravity_wrench}, {world_inverse_inertia, gravity_wrench}, {}}) {
        CAPTURE(own.size());
        const Run mixed = followed(solved, own);
        CAPTURE(mixed.what());
        REQUIRE(mixed.complete);
        REQUIRE(mixed.frames == right.frames);
        REQUIRE(next_call_is_answered());
    }
    // If the reference gives all answers, a worker without formulas does as well.
    REQUIRE(followed(RIGOR_BINARY_DIR "/bin/worker_nothing", {}).frames == right.frames);
}

TEST_CASE("scene answers: more may be given than the memory for it holds")
{
    const Scene long_flight = parse_scene(R"({
  "gravity": [0, -10, 0], "time_step": 0.0001, "end": 2, "frames_per_second": 50,
  "bodies": [{"name": "ball", "shape": {"sphere": {"radius": 0.5}}, "velocity": [1, 2, 3]}]
})",
                                          "long flight");
    Limits patient = tight(); // the scene takes far longer with sanitizers or on a busy machine
    patient.call = Seconds(60);
    use_worker(solved, {}, patient);
    const Run right = run(
        [&](const ByteSink& sink) { run_scene_with_worker(long_flight, Record::frames, sink); });
    const Run mixed = followed(solved, {FormulaIndex::gravity_wrench}, long_flight, patient);
    CAPTURE(mixed.what());
    REQUIRE(mixed.complete);
    REQUIRE(mixed.frames.back() == right.frames.back());
}

TEST_CASE("scene answers: a failure is the same with answers that are given")
{
    const Run right = honest();
    const auto expect = [&](const char* name, const std::string& text) {
        const Run run = followed(attack(name).string(), {FormulaIndex::gravity_wrench});
        CAPTURE(name, run.what());
        REQUIRE(run.what().find(text) != std::string::npos);
        REQUIRE_FALSE(run.complete);
        REQUIRE(run.frames.size() > 20);
        REQUIRE(begins_as(run, right));
        REQUIRE(next_call_is_answered());
    };
    expect("crash_in_scene", "A3.14 gravity_wrench in scene ball crashed: segmentation fault, such "
                             "as by an index outside of a list or endless recursion");
    expect("loop_in_scene", "A3.14 gravity_wrench in scene ball did not return within 0.6 s");
    expect("forge_scene", "sent no answer: it is out of step");
    expect("forge_used", "scene ball answered out of turn");
    // What is not finite does not reach the reference.
    const Run lost = followed(attack("nan_in_scene").string(), {FormulaIndex::gravity_wrench});
    REQUIRE_THROWS_AS(std::rethrow_exception(lost.failure), NotFinite);
    REQUIRE(lost.what().starts_with("A3.14 gravity_wrench: "));
}

TEST_CASE("scene answers: when all scenes together took long, each must be faster")
{
    Limits limits = tight();
    limits.scene = Seconds(5); // a tenth of it is less than 200 calls of 5 ms
    // The second one never lets the client wait for long.
    for (const char* name : {"slow_in_scene", "drop_by_drop"}) {
        const auto run_slowly = [&] {
            use_worker(attack(name), {}, limits);
            return run([](const ByteSink& sink) {
                run_scene_with_worker(ball(), Record::every_step, sink);
            });
        };
        CAPTURE(name);
        limits.all_scenes = tight().all_scenes;
        REQUIRE(run_slowly().complete);
        limits.all_scenes = Seconds(0);
        REQUIRE(run_slowly().what().find("the scene takes more than") != std::string::npos);
    }
}

TEST_CASE("scene answers: a worker with a main of its own moves nothing")
{
    const Run forged = run_with(attack("own_main").string());
    REQUIRE(forged.what().find("sent no answer") != std::string::npos);
    REQUIRE(forged.frames.size() <= 1);
}

} // namespace rigor
