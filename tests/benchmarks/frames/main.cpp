// SPDX-License-Identifier: MIT
// The time of a frame: simulation, drawing and encoding, each by itself, and all of them at the
// same time as in `rigor render`.
#include "render/frames.hpp"
#include "render/png.hpp"
#include "render/visualizer.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/trajectory/reader.hpp"
#include "support/bench/bench.hpp"
#include "support/temporary_folder.hpp"
#include "worker/client.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace rigor;
using rigor::testing::TemporaryFolder;

namespace {

constexpr int width = 1280, height = 720, repeats = 3;

/// The pictures of a scene that the reference runs in its own worker.
class Run {
public:
    explicit Run(Scene scene) : scene_(std::move(scene)) {}

    void simulate(const std::function<void(Picture)>& take) const
    {
        std::optional<Visualizer> visualizer;
        TrajectoryReader::Handlers handlers;
        handlers.on_start = [&](const Scene& scene, const std::vector<RecordedBody>& bodies) {
            visualizer.emplace(scene, bodies, scene.overlays);
        };
        handlers.on_frame = [&](const Frame& frame) { take(visualizer->picture(frame)); };
        handlers.on_end = [](const Counters&) {};
        TrajectoryReader reader(handlers);
        Limits limits;
        limits.scene = std::chrono::duration<double>(600);
        Worker worker(RIGOR_BINARY_DIR "/bin/worker_reference", limits);
        worker.run_scene(scene_.text, scene_.name, Record::frames,
                         [&](std::span<const std::byte> bytes) { reader.feed(bytes); });
    }

private:
    Scene scene_;
};

/// Encodes the images on two threads and writes the files.
void encode(const std::vector<Image>& images, const TemporaryFolder& folder)
{
    const auto half = [&](std::size_t first) {
        for (std::size_t i = first; i < images.size(); i += 2)
            write_picture(folder.path() / ("alone_" + std::to_string(i) + ".png"),
                          png_bytes(images[i]));
    };
    std::thread other(half, 1);
    half(0);
    other.join();
}

void measure(Bench& bench)
{
    const Run run(
        load_scene(RIGOR_SOURCE_DIR "/assignments/a4-collision/scenes/hundred_boxes.json"));
    std::vector<Picture> pictures;
    run.simulate([&](Picture picture) { pictures.push_back(std::move(picture)); });
    if (pictures.empty()) throw std::runtime_error("the scene gave no frame");
    const OpenRenderer opened = open_renderer(width, height);
    std::vector<Image> images;
    for (const Picture& picture : pictures)
        images.push_back(opened.renderer->draw(picture));
    const TemporaryFolder folder;

    // The four measurements alternate, and the ratio is taken within a round, so that a slow
    // phase of the machine affects all of them.
    std::vector<double> simulating, drawing, encoding, whole, ratio;
    for (int i = 0; i < repeats; ++i) {
        simulating.push_back(seconds([&] { run.simulate([](const Picture&) {}); }));
        drawing.push_back(seconds([&] {
            for (const Picture& picture : pictures)
                opened.renderer->draw(picture);
        }));
        encoding.push_back(seconds([&] { encode(images, folder); }));
        FrameOptions options;
        options.directory = folder.path() / "whole";
        options.width = width;
        options.height = height;
        FrameSequence sequence(options);
        whole.push_back(seconds([&] {
            run.simulate([&](Picture picture) { sequence.push(std::move(picture)); });
            sequence.finish();
        }));
        ratio.push_back(whole.back() / std::max(drawing.back(), encoding.back()));
    }
    const auto frames = static_cast<double>(pictures.size());
    const auto row = [&](const char* what, const std::vector<double>& times) {
        bench.row({{"hundred boxes", what}, {"ms a frame", median(times) / frames * 1e3}});
    };
    row("simulate", simulating);
    row("draw", drawing);
    row("encode on two threads", encoding);
    row("the whole", whole);
    bench.reach({"whole / slower of drawing and encoding alone", median(ratio), 1.25, "lower"});
    bench.note(opened.renderer->name() + ", " + std::to_string(width) + "x" +
               std::to_string(height) + ", " + std::to_string(pictures.size()) +
               " frames, median of " + std::to_string(repeats) + " turns");
}

} // namespace

int main(int argc, char** argv)
try {
    Bench bench("frames");
    measure(bench);
    return bench.finish(wants_json(argc, argv));
} catch (const std::exception& error) {
    std::fprintf(stderr, "bench_frames: %s\n", error.what());
    return 3;
}
