// SPDX-License-Identifier: MIT
#include "errors/input_error.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/trajectory/reader.hpp"
#include "scene/trajectory/trajectory_file.hpp"
#include "scene/trajectory/writer.hpp"
#include "support/random.hpp"
#include "trajectory_bytes.hpp"

#include <filesystem>
#include <fstream>
#include <limits>

using namespace rigor;
using namespace rigor::testing;

namespace {

Scene two_balls()
{
    return parse_scene(R"({"time_step": 0.1, "end": 1, "bodies": [
        {"name": "ball", "shape": {"sphere": {"radius": 1}}},
        {"name": "floor", "shape": {"plane": {}}, "static": true}]})",
                       "two balls");
}

RecordedBody moving_body()
{
    return {false, 2, Vector3d(1, 2, 3), Vector3d(4, 5, 6).asDiagonal()};
}

Frame frame_at(const Scene& scene, std::int64_t step)
{
    Random random(static_cast<unsigned>(step));
    Frame frame{step, static_cast<double>(step) * scene.time_step, {}, {}};
    for (int i = 0; i < 2; ++i)
        frame.bodies.push_back(
            {random.vector(), random.quaternion(), random.vector(), random.vector()});
    for (int i = 0; i < step % 3; ++i)
        frame.contacts.push_back(
            {0, 1, random.vector(), random.unit_vector(), 0.25, random.vector()});
    return frame;
}

Counters some_counters()
{
    Counters counters;
    std::uint64_t value = 10;
    for (const CounterField& field : counter_fields)
        counters.*field.member = value++;
    return counters;
}

Bytes start_bytes()
{
    return encode_start(two_balls(), {moving_body(), {true}});
}

Bytes whole_trajectory()
{
    const Scene scene = two_balls();
    Bytes bytes = start_bytes();
    for (const std::int64_t step : {0, 1, 2, 5})
        append(bytes, encode_frame(frame_at(scene, step)));
    append(bytes, encode_end(some_counters()));
    return bytes;
}

Bytes first_frame(const Frame& frame)
{
    Bytes bytes = start_bytes();
    append(bytes, encode_frame(frame));
    return bytes;
}

} // namespace

TEST_CASE("trajectory: what is written is what is read in pieces of any size")
{
    const Scene scene = two_balls();
    const Bytes bytes = whole_trajectory();
    for (const std::size_t piece :
         {std::size_t{1}, std::size_t{7}, std::size_t{100}, bytes.size()}) {
        CAPTURE(piece);
        const Trajectory trajectory = read(bytes, piece);
        CHECK(trajectory.complete);
        CHECK(trajectory.scene.name == "two balls");
        CHECK(trajectory.scene.text == scene.text);
        REQUIRE(trajectory.bodies.size() == 2);
        CHECK(trajectory.bodies[0].mass == 2);
        CHECK(trajectory.bodies[0].center_of_mass == Vector3d(1, 2, 3));
        CHECK(trajectory.bodies[0].inertia == moving_body().inertia);
        CHECK(trajectory.bodies[1].is_static);
        REQUIRE(trajectory.frames.size() == 4);
        for (const Frame& frame : trajectory.frames) {
            const Frame expected = frame_at(scene, frame.step);
            CHECK(encode_frame(frame) == encode_frame(expected));
            REQUIRE(frame.bodies.size() == 2);
            CHECK_THAT(frame.bodies[0], IsExactly(expected.bodies[0]));
            CHECK_THAT(frame.bodies[1], IsExactly(expected.bodies[1]));
            REQUIRE(frame.contacts.size() == expected.contacts.size());
            for (std::size_t i = 0; i < frame.contacts.size(); ++i) {
                CHECK(frame.contacts[i].normal == expected.contacts[i].normal);
                CHECK(frame.contacts[i].impulse == expected.contacts[i].impulse);
            }
        }
        CHECK(trajectory.counters.steps == 10);
        const auto last = std::rbegin(counter_fields)->member;
        CHECK(trajectory.counters.*last == 9 + std::size(counter_fields));
    }
}

TEST_CASE("trajectory: a frame arrives as soon as its last byte does")
{
    const Scene scene = two_balls();
    const Bytes frame = encode_frame(frame_at(scene, 2));
    int frames = 0;
    TrajectoryReader reader({nullptr, [&](const Frame&) { ++frames; }, nullptr});
    reader.feed(start_bytes());
    CHECK(reader.started());
    reader.feed(std::span(frame).first(frame.size() - 1));
    CHECK(frames == 0);
    reader.feed(std::span(frame).last(1));
    CHECK(frames == 1);
    CHECK(!reader.complete());
}

TEST_CASE("trajectory: bytes cut off anywhere are the run up to there")
{
    check_cut_off_anywhere(whole_trajectory(), 4);
}

TEST_CASE("trajectory: every single flipped byte is refused or harmless")
{
    const int refused =
        flipped_bytes_refused(whole_trajectory(), 0, [](const Trajectory& trajectory) {
            for (const Frame& frame : trajectory.frames)
                for (const RigidState& state : frame.bodies)
                    REQUIRE(state.position.allFinite());
        });
    CHECK(refused > 100);
}

TEST_CASE("trajectory: counts and sizes are not believed")
{
    const Bytes start = start_bytes();
    CHECK(refusal(with(start, 0, 'X')) ==
          "header: expected a trajectory (\"RIGORTRJ\"), found \"XIGORTRJ\"");
    CHECK(refusal(with(start, 8, std::uint32_t{3})) ==
          "header: expected version 1 or 2, found version 3");
    CHECK(refusal(with(start, 8, std::uint32_t{2})) ==
          "header: expected version 1 of a scene without solids, found version 2");
    CHECK(refusal(with(start, 12, ~std::uint32_t{0})) ==
          "header: expected at most 255 bytes of the scene's name, found 4294967295");
    CHECK(refusal(with(start, 16, '/')) ==
          "header: expected the name of a scene, found \"/wo balls\"");
    CHECK(refusal(with(start, 16 + 9, ~std::uint32_t{0})) ==
          "header: expected at most 16000000 bytes of the scene's text, found 4294967295");
    const std::size_t bodies = start.size() - 2 * 105 - 4;
    CHECK(refusal(with(start, bodies, ~std::uint32_t{0})) ==
          "header: expected the 2 bodies of the scene, found 4294967295");
    CHECK(refusal(with(start, bodies + 4, std::uint8_t{1})) ==
          "header, body \"ball\": expected a body that moves, found mark 1");
    CHECK(refusal(with(start, bodies + 4 + 105, std::uint8_t{7})) ==
          "header, body \"floor\": expected a static body, found mark 7");
    CHECK(refusal(with(start, bodies + 5, std::numeric_limits<double>::infinity())) ==
          "header, body \"ball\": expected a finite mass, found inf");

    const Scene scene = two_balls();
    const Bytes frame = first_frame(frame_at(scene, 1));
    const std::size_t contacts = start.size() + 17 + 2 * 104;
    CHECK(refusal(with(frame, contacts, ~std::uint32_t{0})) ==
          "step 1: expected at most 1000000 contacts, found 4294967295");
    CHECK(refusal(with(frame, contacts + 4, std::int32_t{2})) ==
          "step 1, a contact: expected a body from 0 to 1, found 2");
    CHECK(refusal(with(frame, contacts + 8, std::int32_t{-1})) ==
          "step 1, a contact: expected a body from 0 to 1, found -1");
    CHECK(refusal(with(frame, start.size(), 'G')) ==
          "after step -1: expected a frame (F) or the end (E), found \"G\"");
    Bytes more = whole_trajectory();
    more.push_back(std::byte{0});
    CHECK(refusal(more) == "trajectory: expected nothing after its end, found 1 bytes");
    Bytes end = start;
    append(end, encode_end({}));
    CHECK(refusal(with(end, start.size() + 1, std::uint32_t{9})) ==
          "end: expected " + std::to_string(std::size(counter_fields)) + " counters, found 9");
}

TEST_CASE("trajectory: a number that is none is refused by body and quantity")
{
    const Scene scene = two_balls();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Frame frame = frame_at(scene, 1);
    frame.bodies[0].position.y() = nan;
    CHECK(refusal(first_frame(frame)) ==
          "step 1, body \"ball\": expected a finite position, found nan");
    frame = frame_at(scene, 1);
    frame.bodies[0].orientation.v.x() = nan;
    CHECK(refusal(first_frame(frame)) ==
          "step 1, body \"ball\": expected a finite orientation, found nan");
    frame = frame_at(scene, 1);
    frame.bodies[1].angular_momentum.z() = -std::numeric_limits<double>::infinity();
    CHECK(refusal(first_frame(frame)) ==
          "step 1, body \"floor\": expected a finite angular momentum, found -inf");
    frame = frame_at(scene, 1);
    frame.contacts[0].depth = nan;
    CHECK(refusal(first_frame(frame)) == "step 1, a contact: expected a finite depth, found nan");
}

TEST_CASE("trajectory: steps rise and belong to their times")
{
    const Scene scene = two_balls();
    Bytes twice = first_frame(frame_at(scene, 3));
    append(twice, encode_frame(frame_at(scene, 3)));
    CHECK(refusal(twice) == "after step 3: expected a later step, up to 10, found 3");
    CHECK(refusal(first_frame(frame_at(scene, 11))) ==
          "after step -1: expected a later step, up to 10, found 11");
    Frame frame = frame_at(scene, 3);
    frame.time = 0.5;
    CHECK(refusal(first_frame(frame)).rfind("step 3: expected the time 0.3", 0) == 0);
}

TEST_CASE("trajectory: the reader takes nothing after an error")
{
    TrajectoryReader reader({});
    const Bytes garbage(12, std::byte{1});
    CHECK_THROWS_AS(reader.feed(garbage), InputError);
    CHECK_THROWS_AS(reader.feed(start_bytes()), InputError);
}

TEST_CASE("trajectory: a file can be read while it is written")
{
    const std::filesystem::path file =
        std::filesystem::path(RIGOR_BINARY_DIR) / "trajectory_test.trj";
    const Scene scene = two_balls();
    std::ofstream out(file, std::ios::binary);
    const auto write = [&](const Bytes& record) {
        out.write(reinterpret_cast<const char*>(record.data()), std::ssize(record));
        out.flush();
    };
    CHECK_THROWS_AS(load_trajectory(file), InputError);
    write(start_bytes());
    CHECK(load_trajectory(file).frames.empty());
    write(encode_frame(frame_at(scene, 0)));
    write(encode_frame(frame_at(scene, 1)));
    CHECK(load_trajectory(file).frames.size() == 2);
    CHECK(!load_trajectory(file).complete);
    write(encode_end({}));
    CHECK(load_trajectory(file).complete);
    out << "more";
    out.close();
    try {
        load_trajectory(file);
        FAIL("accepted");
    } catch (const InputError& error) {
        CHECK(error.what() ==
              file.string() + ": trajectory: expected nothing after its end, found 4 bytes");
    }
    std::filesystem::remove(file);
    CHECK_THROWS_AS(load_trajectory(file), InputError);
}
