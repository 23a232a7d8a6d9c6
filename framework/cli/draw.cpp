// SPDX-License-Identifier: MIT
#include "cli/draw.hpp"

#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "errors/input_error.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>

namespace rigor {

namespace {

double now()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

std::pair<int, int> size_of(const std::string& text)
{
    int width = 0, height = 0, length = 0;
    if (std::sscanf(text.c_str(), "%6dx%6d%n", &width, &height, &length) != 2 ||
        static_cast<std::size_t>(length) != text.size())
        throw InputError("--size: expected WIDTHxHEIGHT such as 1280x720, found '" + text + "'");
    check_size(width, height);
    return {width, height};
}

Overlays overlays_of(const Scene& scene, const DrawOptions& options)
{
    Overlays overlays = scene.overlays;
    overlays.axes |= options.axes;
    overlays.angular_velocity |= options.omega;
    overlays.angular_momentum |= options.momentum;
    overlays.contacts |= options.contacts;
    overlays.labels |= options.labels;
    return overlays;
}

} // namespace

void declare_drawing(Options& options, DrawOptions& draw)
{
    options.option("--size", "WxH", draw.size, "Width and height of a frame in pixels (1280x720)");
    options.option("--gl", "HOW", draw.gl, "osmesa or egl; by default as it was configured");
    options.flag("--video", draw.video, "Also make DIR/out.mp4, by ffmpeg");
    options.flag("--axes", draw.axes, "Draw each body's axes");
    options.flag("--omega", draw.omega, "Draw angular velocities ω");
    options.flag("--momentum", draw.momentum, "Draw angular momenta L");
    options.flag("--contacts", draw.contacts, "Draw contacts and their impulses");
    options.flag("--labels", draw.labels, "Write the bodies' names");
}

void check_drawing(const DrawOptions& options)
{
    size_of(options.size);
    if (!options.gl.empty()) gl_from_text(options.gl);
}

Film::Film(const std::string& folder, const Scene& scene, const DrawOptions& options)
    : folder_(folder), overlays_(overlays_of(scene, options)),
      progress_(std::make_unique<Progress>(scene.name)), seconds_at_start_(now())
{
    options_.directory = folder;
    std::tie(options_.width, options_.height) = size_of(options.size);
    if (!options.gl.empty()) options_.gl = gl_from_text(options.gl);
    options_.video = options.video;
    options_.frames_per_second = scene.frames_per_second;
    options_.expected = static_cast<std::size_t>(frame_count(scene));
    options_.progress = [this](std::size_t done, std::size_t expected) {
        progress_->update(static_cast<double>(done) /
                              static_cast<double>(std::max<std::size_t>(1, expected)),
                          fmt::format("frame {} of {}", done, expected));
    };
    sequence_ = std::make_unique<FrameSequence>(options_);
}

Film::~Film()
{
    // The threads of the sequence call the progress bar, so they must end before it is destroyed.
    sequence_.reset();
}

void Film::start(const Scene& scene, const std::vector<RecordedBody>& bodies)
{
    visualizer_ = std::make_unique<Visualizer>(scene, bodies, overlays_);
}

void Film::add(const Frame& frame)
{
    sequence_->push(visualizer_->picture(frame));
}

void Film::add(const Frame& frame, const Frame& other, const std::string& name,
               const std::string& other_name)
{
    sequence_->push(visualizer_->comparison(frame, other, name, other_name));
}

std::size_t Film::finish()
{
    const FrameReport report = sequence_->finish();
    progress_->clear();
    const double seconds = now() - seconds_at_start_;
    if (!report.notice.empty()) std::fprintf(stderr, "rigor: %s\n", report.notice.c_str());
    if (report.removed > 0)
        std::fprintf(stderr, "rigor: %zu files of an earlier run were removed from %s\n",
                     report.removed, folder_.c_str());
    fmt::print("{} {} in {} ({}x{}, {:.1f} s)\n", report.frames,
               report.frames == 1 ? "frame" : "frames", folder_, options_.width, options_.height,
               seconds);
    if (report.video) fmt::print("video in {}\n", report.video->string());
    return report.frames;
}

void draw_comparison(const Trajectory& expected, const Trajectory& actual, const std::string& name,
                     const std::string& folder, const DrawOptions& options)
{
    Film film(folder, expected.scene, options);
    film.start(expected.scene, expected.bodies);
    FramePicker picker(expected.scene);
    for (std::size_t i = 0; i < expected.frames.size() && i < actual.frames.size(); ++i)
        if (picker.picks(expected.frames[i].step))
            film.add(expected.frames[i], actual.frames[i], "reference", name);
    film.finish();
}

} // namespace rigor
