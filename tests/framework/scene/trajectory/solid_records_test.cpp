// SPDX-License-Identifier: MIT
// Deformable solids in a trajectory.
#include "scene/keys/scene_keys.hpp"
#include "scene/trajectory/motion_hash.hpp"
#include "scene/trajectory/writer.hpp"
#include "support/random.hpp"
#include "trajectory_bytes.hpp"

#include <limits>

namespace solid_records_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

Scene one_solid()
{
    return parse_scene(R"({"time_step": 0.1, "end": 1, "solids": [
        {"name": "bar", "mesh": {"bar": {"size": [1, 1, 1], "cells": [1, 1, 1]}}}]})",
                       "one solid");
}

// A mesh of `elements` tetrahedra that share no nodes.
std::shared_ptr<const SolidTopology> topology_of(int elements)
{
    const auto topology = std::make_shared<SolidTopology>();
    topology->nodes = 4 * static_cast<std::size_t>(elements);
    topology->pieces = static_cast<std::size_t>(elements);
    for (int e = 0; e < elements; ++e) {
        topology->elements.push_back({4 * e, 4 * e + 1, 4 * e + 2, 4 * e + 3});
        topology->surface.points.push_back({e, {0.25, 0.5, 0.125, 0.125}});
        topology->surface.triangles.push_back({{0, e, e}, e, e % 2 == 1});
    }
    return topology;
}

SolidFrame solid_of(std::shared_ptr<const SolidTopology> topology, bool is_new, unsigned seed)
{
    Random random(seed);
    SolidFrame solid;
    solid.is_new_topology = is_new;
    for (std::size_t i = 0; i < topology->nodes; ++i) {
        solid.positions.push_back(random.vector());
        solid.velocities.push_back(random.vector());
    }
    for (std::size_t i = 0; i < topology->elements.size(); ++i) {
        solid.stresses.push_back(static_cast<float>(i) + 0.25F);
        solid.plastic_strains.push_back(0.5F);
    }
    solid.totals = {1, 2, 3, 4, random.vector(), random.vector(), random.vector()};
    solid.topology = std::move(topology);
    return solid;
}

Frame frame_of(std::int64_t step, SolidFrame solid)
{
    Frame frame{step, static_cast<double>(step) * 0.1, {}, {}};
    frame.solids.push_back(std::move(solid));
    return frame;
}

// Four frames; the mesh changes in the third.
std::vector<Frame> frames()
{
    const auto before = topology_of(2), after = topology_of(3);
    return {frame_of(0, solid_of(before, true, 1)), frame_of(1, solid_of(before, false, 2)),
            frame_of(2, solid_of(after, true, 3)), frame_of(5, solid_of(after, false, 4))};
}

void check_indices(const SolidFrame& solid)
{
    const SolidTopology& mesh = *solid.topology;
    REQUIRE(solid.positions.size() == mesh.nodes);
    for (const EmbeddedPoint& point : mesh.surface.points)
        for (const int node : mesh.elements.at(point.element))
            REQUIRE(solid.positions.at(node).allFinite());
    for (const EmbeddedTriangle& triangle : mesh.surface.triangles)
        for (const int point : triangle.points)
            REQUIRE(static_cast<std::size_t>(point) < mesh.surface.points.size());
}

Bytes whole_trajectory()
{
    Bytes bytes = encode_start(one_solid(), {});
    for (const Frame& frame : frames())
        append(bytes, encode_frame(frame));
    append(bytes, encode_end({}));
    return bytes;
}

} // namespace

TEST_CASE("trajectory of solids: what is written is what is read in pieces of any size")
{
    const Bytes bytes = whole_trajectory();
    const std::vector<Frame> expected = frames();
    for (const std::size_t piece : {std::size_t{1}, std::size_t{13}, bytes.size()}) {
        CAPTURE(piece);
        const Trajectory trajectory = read(bytes, piece);
        CHECK(trajectory.complete);
        CHECK(trajectory.scene.solids.size() == 1);
        REQUIRE(trajectory.frames.size() == expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const SolidFrame &a = expected[i].solids[0], &b = trajectory.frames[i].solids.at(0);
            CHECK(encode_frame(trajectory.frames[i]) == encode_frame(expected[i]));
            CHECK(b.is_new_topology == a.is_new_topology);
            CHECK(b.topology->elements == a.topology->elements);
            CHECK(b.topology->pieces == a.topology->pieces);
            CHECK(b.positions == a.positions);
            CHECK(b.velocities == a.velocities);
            CHECK(b.stresses == a.stresses);
            CHECK(b.plastic_strains == a.plastic_strains);
            CHECK(b.totals.angular_momentum == a.totals.angular_momentum);
            CHECK(b.topology->surface.triangles.back().is_crack ==
                  a.topology->surface.triangles.back().is_crack);
        }
        // Frames share the mesh as long as it does not change.
        CHECK(trajectory.frames[0].solids[0].topology == trajectory.frames[1].solids[0].topology);
        CHECK(trajectory.frames[1].solids[0].topology != trajectory.frames[2].solids[0].topology);
    }
}

TEST_CASE("trajectory of solids: bytes cut off anywhere are the run up to there")
{
    check_cut_off_anywhere(whole_trajectory(), 4);
}

TEST_CASE("trajectory of solids: every single flipped byte is refused or harmless")
{
    const std::size_t start = encode_start(one_solid(), {}).size();
    const int refused =
        flipped_bytes_refused(whole_trajectory(), start, [](const Trajectory& trajectory) {
            for (const Frame& frame : trajectory.frames)
                for (const SolidFrame& solid : frame.solids)
                    check_indices(solid);
        });
    CHECK(refused > 300);
}

TEST_CASE("trajectory of solids: counts and indices are not believed")
{
    const Bytes start = encode_start(one_solid(), {});
    CHECK(refusal(with(start, 8, std::uint32_t{1})) ==
          "header: expected version 2 of a scene with solids, found version 1");
    CHECK(refusal(with(start, 8, std::uint32_t{3})) ==
          "header: expected version 1 or 2, found version 3");
    CHECK(refusal(with(start, start.size() - 4, std::uint32_t{2})) ==
          "header: expected the 1 solids of the scene, found 2");

    const std::string place = "step 0, solid \"bar\": expected ";
    Bytes first = start;
    append(first, encode_frame(frames()[0]));
    const std::size_t mark = start.size() + 1 + 8 + 8 + 4, counts = mark + 1;
    CHECK(refusal(with(first, mark, std::uint8_t{2})) ==
          place + "mark 0 or 1 of a new mesh, found mark 2");
    CHECK(refusal(with(first, mark, std::uint8_t{0})) ==
          place + "a mesh in the first frame, found none");
    const auto count = [&](std::size_t i, std::uint32_t n) {
        return refusal(with(first, counts + 4 * i, n));
    };
    CHECK(count(0, 0) == place + "some nodes, found none");
    CHECK(count(0, ~0U) == place + "at most 4000000 nodes, found 4294967295");
    CHECK(count(1, ~0U) == place + "at most 4000000 elements, found 4294967295");
    CHECK(count(2, ~0U) == place + "at most 8000000 points, found 4294967295");
    CHECK(count(3, ~0U) == place + "at most 8000000 triangles, found 4294967295");
    CHECK(count(4, 3) == place + "at most 2 pieces, found 3");
    const std::size_t elements = counts + 20, points = elements + 2 * 16,
                      triangles = points + 2 * 20, totals_at = triangles + 2 * 17,
                      nodes = totals_at + 13 * 8, measures = nodes + 8 * 48;
    REQUIRE(measures + 2 * 8 == first.size());
    CHECK(refusal(with(first, elements, std::int32_t{8})) == place + "a node from 0 to 7, found 8");
    CHECK(refusal(with(first, elements, std::int32_t{-1})) ==
          place + "a node from 0 to 7, found -1");
    CHECK(refusal(with(first, points, std::int32_t{2})) ==
          place + "an element from 0 to 1, found 2");
    CHECK(refusal(with(first, triangles, std::int32_t{2})) ==
          place + "a point from 0 to 1, found 2");
    CHECK(refusal(with(first, triangles + 12, std::int32_t{5})) ==
          place + "an element from 0 to 1, found 5");
    CHECK(refusal(with(first, triangles + 16, std::uint8_t{9})) ==
          place + "mark 0 or 1 of a crack, found mark 9");

    const double nan = std::numeric_limits<double>::quiet_NaN();
    const float no_number = std::numeric_limits<float>::infinity();
    CHECK(refusal(with(first, points + 4, no_number)) == place + "a finite weight, found inf");
    CHECK(refusal(with(first, totals_at, nan)) == place + "a finite mass, found nan");
    CHECK(refusal(with(first, totals_at + 24, nan)) ==
          place + "a finite elastic energy, found nan");
    CHECK(refusal(with(first, nodes + 8, nan)) == place + "a finite position, found nan");
    CHECK(refusal(with(first, nodes + 24, nan)) == place + "a finite velocity, found nan");
    CHECK(refusal(with(first, measures, no_number)) == place + "a finite stress, found inf");
    CHECK(refusal(with(first, measures + 4, no_number)) ==
          place + "a finite plastic strain, found inf");
}

TEST_CASE("trajectory of solids: the hash of a motion is of the solids too")
{
    const auto hash_of = [](const Frame& frame) {
        MotionHash hash;
        hash.take(frame);
        return hash.value();
    };
    const Frame frame = frames()[2];
    Frame moved = frame, strained = frame, cracked = frame;
    moved.solids[0].positions[3].z() = std::nextafter(moved.solids[0].positions[3].z(), 2.0);
    strained.solids[0].plastic_strains[1] = 0.25F;
    cracked.solids[0].topology = topology_of(3);
    CHECK(hash_of(cracked) == hash_of(frame)); // another copy of the same mesh
    auto other = std::make_shared<SolidTopology>(*frame.solids[0].topology);
    other->surface.triangles[0].is_crack = true;
    cracked.solids[0].topology = other;
    CHECK(hash_of(moved) != hash_of(frame));
    CHECK(hash_of(strained) != hash_of(frame));
    CHECK(hash_of(cracked) != hash_of(frame));
}

} // namespace solid_records_test
