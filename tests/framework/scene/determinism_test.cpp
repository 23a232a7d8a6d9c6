// SPDX-License-Identifier: MIT
// The motion of a scene and its hash.
#include "scene/keys/scene_keys.hpp"
#include "scene/run/run_scene.hpp"
#include "scene/trajectory/motion_hash.hpp"
#include "scene/trajectory/reader.hpp"
#include "support/close.hpp"

#include <cmath>
#include <set>

using namespace rigor;

namespace {

std::string pile(const std::string& body_name)
{
    return R"({"time_step": 0.0166, "end": 0.7, "contact": "simultaneous", "bodies": [
        {"name": "floor", "shape": {"plane": {}}, "static": true},
        {"name": ")" +
           body_name + R"(", "shape": {"box": {"size": [1, 1, 1]}}, "position": [0, 1, 0],
         "grid": {"count": [2, 3, 2], "spacing": [1.5, 1.5, 1.5], "jitter": 0.1, "jitter_degrees": 40}}]})";
}

struct Motion {
    Bytes bytes;
    MotionHash hash;
};

Motion run(const std::string& text, Record record = Record::every_step)
{
    Motion motion;
    TrajectoryReader reader({
        [&](const Scene&, const std::vector<RecordedBody>& bodies) { motion.hash.take(bodies); },
        [&](Frame frame) { motion.hash.take(frame); },
        [](const Counters&) {},
    });
    run_scene(parse_scene(text, "pile"), record, [&](std::span<const std::byte> bytes) {
        reader.feed(bytes);
        motion.bytes.insert(motion.bytes.end(), bytes.begin(), bytes.end());
    });
    REQUIRE(reader.complete());
    return motion;
}

} // namespace

TEST_CASE("determinism: a scene gives the same bytes twice", "[scene]")
{
    const Motion first = run(pile("box")), second = run(pile("box"));
    REQUIRE(first.bytes.size() > 10000);
    REQUIRE(first.bytes == second.bytes);
    REQUIRE(first.hash.value() == second.hash.value());
}

TEST_CASE("determinism: the names of the bodies have no part in the motion", "[scene]")
{
    const Motion plain = run(pile("box")), renamed = run(pile("a much longer name"));
    REQUIRE(plain.bytes != renamed.bytes); // they contain the text of the scene
    REQUIRE(plain.hash.text() == renamed.hash.text());
}

TEST_CASE("determinism: the hash is FNV-1a of all that moves", "[scene]")
{
    REQUIRE(MotionHash().text() == "cbf29ce484222325"); // the hash of no bytes
    Frame frame;
    frame.bodies.resize(1);
    frame.contacts.resize(1);
    const auto hash_of = [](const Frame& f) {
        MotionHash hash;
        hash.take(f);
        return hash.value();
    };
    std::set<std::uint64_t> hashes = {hash_of(frame)};
    const auto changed = [&](auto&& change) {
        Frame other = frame;
        change(other);
        return hashes.insert(hash_of(other)).second;
    };
    REQUIRE(changed([](Frame& f) { f.bodies[0].position.x() = std::nextafter(0.0, 1.0); }));
    REQUIRE(changed([](Frame& f) { f.bodies[0].velocity.z() = -0.0; })); // -0 has another bit
    REQUIRE(changed([](Frame& f) { f.bodies[0].orientation.s = std::nextafter(1.0, 2.0); }));
    REQUIRE(changed([](Frame& f) { f.contacts[0].impulse.y() = 1e-300; }));
    REQUIRE(changed([](Frame& f) { f.step = 1; }));
    REQUIRE(changed([](Frame& f) { f.contacts.clear(); }));
}

TEST_CASE("determinism: what is recorded does not change the motion", "[scene]")
{
    const auto last_state = [](Record record) {
        std::vector<RigidState> bodies;
        TrajectoryReader reader({[](const Scene&, const std::vector<RecordedBody>&) {},
                                 [&](Frame frame) { bodies = std::move(frame.bodies); },
                                 [](const Counters&) {}});
        run_scene(parse_scene(pile("box"), "pile"), record,
                  [&](std::span<const std::byte> bytes) { reader.feed(bytes); });
        Frame end;
        end.bodies = bodies;
        return encode_frame(end);
    };
    REQUIRE(last_state(Record::frames) == last_state(Record::every_step));
}
