// SPDX-License-Identifier: MIT
// Workers are processes of their own, with other addresses and other start times, but the motion is
// the same.
#include "scene/run/run_scene.hpp"
#include "scene/trajectory/motion_hash.hpp"
#include "scene/trajectory/reader.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "worker/client.hpp"

#include <algorithm>

namespace rigor {

namespace {

const char* const reference = RIGOR_BINARY_DIR "/bin/worker_reference";

std::string pile(int seed)
{
    return R"({"time_step": 0.0166, "end": 0.5, "contact": "simultaneous", "bodies": [
        {"name": "floor", "shape": {"plane": {}}, "static": true},
        {"name": "box", "shape": {"box": {"size": [1, 1, 1]}}, "position": [0, 1, 0],
         "grid": {"count": [2, 3, 2], "spacing": [1.5, 1.5, 1.5], "jitter": 0.1, "jitter_degrees": 40,
                  "seed": )" +
           std::to_string(seed) + "}}]}";
}

std::string hash_of(Worker& worker, int seed)
{
    MotionHash hash;
    TrajectoryReader reader(
        {[&](const Scene&, const std::vector<RecordedBody>& bodies) { hash.take(bodies); },
         [&](Frame frame) { hash.take(frame); }, [](const Counters&) {}});
    worker.run_scene(pile(seed), "pile", Record::every_step,
                     [&](std::span<const std::byte> bytes) { reader.feed(bytes); });
    REQUIRE(reader.complete());
    return hash.text();
}

} // namespace

TEST_CASE("determinism: a fresh worker gives the same motion as one that has worked")
{
    Worker worker(reference);
    const std::string first = hash_of(worker, 1);
    REQUIRE(hash_of(worker, 2) != first);
    REQUIRE(hash_of(worker, 1) == first);
    worker.renew();
    REQUIRE(hash_of(worker, 1) == first);
    Worker other(reference);
    REQUIRE(hash_of(other, 1) == first);
}

TEST_CASE("determinism: workers may be started and asked in any order")
{
    constexpr int count = 6;
    std::vector<std::string> expected;
    Worker alone(reference);
    for (int seed = 0; seed < count; ++seed)
        expected.push_back(hash_of(alone, seed));

    testing::Random random(1);
    std::vector<int> order = {0, 1, 2, 3, 4, 5};
    for (int round = 0; round < 3; ++round) {
        std::vector<std::unique_ptr<Worker>> workers;
        for (int i = 0; i < count; ++i)
            workers.push_back(std::make_unique<Worker>(reference));
        const auto shuffle = [&] {
            for (std::size_t i = count - 1; i > 0; --i)
                std::swap(order[i], order[random.bits() % (i + 1)]);
        };
        shuffle();
        for (const int i : order)
            workers[static_cast<std::size_t>(i)]->start();
        shuffle();
        for (const int i : order) {
            CAPTURE(round, i);
            REQUIRE(hash_of(*workers[static_cast<std::size_t>(i)], i) ==
                    expected[static_cast<std::size_t>(i)]);
        }
    }
}

} // namespace rigor
