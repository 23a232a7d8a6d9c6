// SPDX-License-Identifier: MIT
// Deformable solids in pictures.
#include "errors/input_error.hpp"
#include "pictures.hpp"
#include "render/colors.hpp"
#include "render/deformed_surfaces.hpp"
#include "render/frames.hpp"
#include "render/visualizer.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/run/record_solid.hpp"
#include "scene/run/run_scene.hpp"
#include "scene/trajectory/reader.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace solid_visualizer_test {

using namespace rigor;
using rigor::testing::TemporaryFolder;

namespace {

// A bar of 2 m along x in front of the camera.
Scene bar_scene(const std::string& draw = "")
{
    return parse_scene(R"({"time_step": 0.01, "end": 0.1, "gravity": [0, 0, 0], "solids": [
        {"name": "bar", "mesh": {"bar": {"size": [2, 1, 1], "cells": [2, 1, 1]}},
         "yield_stress": 4e6, "color": [0.1, 0.2, 0.9]}],
        "camera": {"position": [0, 0, 6]}, "draw": {"grid": false)" +
                           (draw.empty() ? "" : ", " + draw) + "}}",
                       "bar");
}

// The first frame of the scene, with a stress of 0 where x < 0, and of 4 MPa, the yield stress,
// elsewhere.
Frame first_frame(const Scene& scene)
{
    const DeformableWorld world = make_deformable_world(scene);
    Frame frame;
    frame.solids.push_back(SolidRecorder().frame(world.solids[0], 0));
    SolidFrame& bar = frame.solids[0];
    for (std::size_t e = 0; e < bar.stresses.size(); ++e) {
        double x = 0;
        for (const int node : bar.topology->elements[e])
            x += bar.positions[node].x() / 4;
        bar.stresses[e] = x < 0 ? 0 : 4e6F;
    }
    return frame;
}

Picture picture_of(const Scene& scene, const Frame& frame)
{
    return Visualizer(scene, {}, scene.overlays).picture(frame);
}

// A frame whose faces towards the camera are marked as opened by a crack.
Frame cracked(const Frame& frame)
{
    Frame result = frame;
    auto topology = std::make_shared<SolidTopology>(*frame.solids[0].topology);
    for (EmbeddedTriangle& triangle : topology->surface.triangles) {
        bool in_front = true;
        for (const int p : triangle.points) {
            const EmbeddedPoint& point = topology->surface.points[p];
            double z = 0;
            for (int i = 0; i < 4; ++i)
                z += point.weights[i] *
                     frame.solids[0].positions[topology->elements[point.element][i]].z();
            in_front = in_front && z > 0.499;
        }
        triangle.is_crack = in_front;
    }
    result.solids[0].topology = topology;
    return result;
}

Image drawn(const Picture& picture)
{
    return open_renderer(320, 240).renderer->draw(picture);
}

} // namespace

TEST_CASE("solids: the surface lies where the nodes are and looks outwards", "[render]")
{
    const Scene scene = bar_scene();
    Frame frame = first_frame(scene);
    for (Vector3d& x : frame.solids[0].positions)
        x.y() += 3;
    const Picture picture = picture_of(scene, frame);
    REQUIRE(picture.deformed.size() == 3 * frame.solids[0].topology->surface.triangles.size());
    Vector3f low = Vector3f::Constant(9), high = -low;
    double volume = 0;
    for (std::size_t i = 0; i < picture.deformed.size(); i += 3) {
        const Vector3f &a = picture.deformed[i].position, &b = picture.deformed[i + 1].position,
                       &c = picture.deformed[i + 2].position;
        volume += static_cast<double>(a.dot(b.cross(c))) / 6;
        const Vector3f across = (b - a).cross(c - a).normalized();
        for (std::size_t j = i; j < i + 3; ++j) {
            low = low.cwiseMin(picture.deformed[j].position);
            high = high.cwiseMax(picture.deformed[j].position);
            CHECK((picture.deformed[j].normal - across).norm() < 1e-5F); // flat, with sharp edges
            CHECK(picture.deformed[j].color == linear_color(0.1, 0.2, 0.9));
        }
    }
    CHECK(std::abs(volume - 2) < 1e-5);
    CHECK((low - Vector3f(-1, 2.5F, -0.5F)).norm() < 1e-6F);
    CHECK((high - Vector3f(1, 3.5F, 0.5F)).norm() < 1e-6F);
    CHECK(!picture.color_scale);
}

TEST_CASE("solids: lines run along sharp edges alone", "[render]")
{
    const Scene scene = bar_scene();
    const Picture picture = picture_of(scene, first_frame(scene));
    int lines = 0;
    for (std::size_t i = 0; i < picture.deformed.size(); i += 3)
        for (int side = 0; side < 3; ++side) {
            const DeformedVertex *a = &picture.deformed[i + side],
                                 *b = &picture.deformed[i + (side + 1) % 3];
            const bool is_line = a->edges[side] == 0 && b->edges[side] == 0;
            const bool is_diagonal =
                ((a->position - b->position).array().abs() > 1e-6F).count() > 1;
            if (is_diagonal) CHECK(!is_line);
            if (is_line) ++lines;
        }
    // 8 edges of 1 m across and 4 edges of two cells along, each seen from two sides.
    CHECK(lines == 2 * (8 + 2 * 4));
}

TEST_CASE("solids: what a crack opened has another color", "[render]")
{
    const Scene scene = bar_scene();
    const Frame frame = first_frame(scene), opened = cracked(frame);
    const Picture picture = picture_of(scene, opened);
    const auto in_color = [&](const Vector4f& color) {
        return std::count_if(picture.deformed.begin(), picture.deformed.end(),
                             [&](const DeformedVertex& v) { return v.color == color; });
    };
    CHECK(in_color(colors::crack) == 12); // four triangles on two cells
    CHECK(in_color(linear_color(0.1, 0.2, 0.9)) ==
          static_cast<std::ptrdiff_t>(picture.deformed.size()) - 12);

    const Image whole = drawn(picture_of(scene, frame)), broken = drawn(picture);
    const std::uint8_t *blue = whole.pixel(160, 120), *dark = broken.pixel(160, 110);
    CHECK(blue[2] > blue[0] + 60);
    CHECK(dark[0] > dark[2]);
}

TEST_CASE("solids: colors by stress come with a bar that says what they mean", "[render]")
{
    const Scene scene = bar_scene(R"("solids": "stress")");
    const Frame frame = first_frame(scene);
    const Picture picture = picture_of(scene, frame);
    for (const DeformedVertex& v : picture.deformed)
        if (std::abs(v.position.x()) > 0.9F) // all elements here have the same stress
            CHECK(v.color == colors::scale(v.position.x() < 0 ? 0 : 1));
    REQUIRE(picture.color_scale);
    const ColorScale& scale = *picture.color_scale;
    CHECK(scale.title == "von Mises stress [MPa]"); // the range is from 0 to the yield stress
    REQUIRE(scale.ticks.size() >= 4);
    CHECK(scale.ticks.front().text == "0");
    CHECK(scale.ticks.front().place == 0);
    CHECK(scale.ticks.back().text == "4");
    CHECK(scale.ticks.back().place == 1);

    // On the screen there is a bar at the right border whose lower end is dark and whose upper end
    // is pale.
    const Image image = drawn(picture);
    int columns = 0;
    for (int x = 200; x < 320; ++x)
        if (brightness(image.pixel(x, 80)) > brightness(image.pixel(x, 170)) + 200) ++columns;
    CHECK(columns >= 3);
    Picture without = picture;
    without.color_scale.reset();
    CHECK(largest_difference(image, drawn(without)) > 60);
}

TEST_CASE("solids: the bar of colors covers nothing of what the camera shows", "[render]")
{
    for (const auto& [width, height] : {std::pair{640, 360}, {240, 320}}) {
        CAPTURE(width, height);
        Picture bar, solid; // `bar` has only letters and colors, `solid` only a solid
        bar.eye = solid.eye = Vector3f(0, 0, 10);
        bar.color_scale = picture_of(bar_scene(R"("solids": "stress")"),
                                     first_frame(bar_scene(R"("solids": "stress")")))
                              .color_scale;
        REQUIRE(bar.color_scale);
        solid.color_scale.emplace();
        // A rectangle that fills the picture from border to border.
        const float y = 10 * std::tan(20 * 3.14159265F / 180);
        const float x = y * static_cast<float>(width) / static_cast<float>(height);
        const std::array<Vector3f, 4> corners = {Vector3f(-x, -y, 0), Vector3f(x, -y, 0),
                                                 Vector3f(x, y, 0), Vector3f(-x, y, 0)};
        for (const int i : {0, 1, 2, 0, 2, 3})
            solid.deformed.push_back({corners[i], Vector3f::UnitZ()});
        Picture empty = solid;
        empty.deformed.clear();
        const OpenRenderer opened = open_renderer(width, height);
        Renderer& renderer = *opened.renderer;
        const Image neither = renderer.draw(empty), letters = renderer.draw(bar),
                    surface = renderer.draw(solid);
        int lettered = 0, solid_pixels = 0, both = 0;
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                const auto differs = [&](const Image& image) {
                    return !std::equal(image.pixel(i, j), image.pixel(i, j) + 3,
                                       neither.pixel(i, j));
                };
                lettered += differs(letters);
                solid_pixels += differs(surface);
                both += differs(letters) && differs(surface);
            }
        CHECK(lettered > 400);
        CHECK(solid_pixels > width * height / 3);
        CHECK(both == 0);
    }
}

TEST_CASE("solids: the range of colors is the scene's if it names one", "[render]")
{
    const Scene scene = bar_scene(R"("solids": "stress", "solids_range": [1e6, 9e6])");
    const Picture picture = picture_of(scene, first_frame(scene));
    for (const DeformedVertex& v : picture.deformed)
        if (v.position.x() > 0.9F) CHECK(v.color == colors::scale(0.375));
    REQUIRE(picture.color_scale);
    CHECK(picture.color_scale->ticks.front().text == "1");
    CHECK(picture.color_scale->ticks.back().text == "9");

    const Scene strain = bar_scene(R"("solids": "plastic_strain")");
    Frame frame = first_frame(strain);
    frame.solids[0].plastic_strains.assign(frame.solids[0].plastic_strains.size(), 0.03F);
    const Picture strained = picture_of(strain, frame);
    CHECK(strained.color_scale->title == "plastic strain");
    CHECK(strained.color_scale->ticks.back().text == "0.05"); // the largest strain, rounded up
}

TEST_CASE("solids: the scale of colors grows lighter in even steps", "[render]")
{
    double last = -1;
    for (int i = 0; i <= 64; ++i) {
        const Vector4f c = colors::scale(i / 64.0);
        // The relative luminance of linear sRGB.
        const double Y = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
        CAPTURE(i);
        CHECK(Y > last);
        last = Y;
    }
    CHECK(last > 0.7);
    CHECK(colors::scale(-3) == colors::scale(0));
    CHECK(colors::scale(7) == colors::scale(1));
}

TEST_CASE("solids: another run's solid is a ghost where it lies apart", "[render]")
{
    const Scene scene = bar_scene();
    const Frame frame = first_frame(scene);
    Frame moved = frame;
    moved.solids[0].positions[0].y() += 0.1;
    const Visualizer visualizer(scene, {}, scene.overlays);
    CHECK(visualizer.comparison(frame, frame, "a", "b").ghost_deformed.empty());
    const Picture picture = visualizer.comparison(frame, moved, "a", "b");
    CHECK(picture.ghost_deformed.size() == picture.deformed.size());
    CHECK(picture.texts.back().text == "1 of 1 bodies lie apart");
    CHECK_THROWS_AS(visualizer.picture(Frame()), InputError);
}

TEST_CASE("solids: a run becomes files", "[render]")
{
    const TemporaryFolder folder;
    FrameOptions options;
    options.directory = folder.path();
    options.width = 64;
    options.height = 48;
    FrameSequence sequence(options);
    std::optional<Visualizer> visualizer;
    TrajectoryReader reader({
        [&](const Scene& scene, const std::vector<RecordedBody>& bodies) {
            visualizer.emplace(scene, bodies, scene.overlays);
        },
        [&](const Frame& frame) { sequence.push(visualizer->picture(frame)); },
        nullptr,
    });
    run_scene(bar_scene(R"("solids": "stress")"), Record::frames,
              [&](std::span<const std::byte> bytes) { reader.feed(bytes); });
    CHECK(sequence.finish().frames == 4);
    CHECK(names_in(folder.path()).size() == 4);
    CHECK(decoded(folder.path() / "frame_00003.png").width == 64);
}

} // namespace solid_visualizer_test
