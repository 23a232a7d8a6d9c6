// SPDX-License-Identifier: MIT
// Pictures to files, as they come: while one is drawn, those before it are compressed and written.
#pragma once

#include "render/picture.hpp"
#include "render/renderer.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace rigor {

struct FrameOptions {
    std::filesystem::path directory; // made if it is not there
    int width = 1280, height = 720;  // [pixels]
    Gl gl = default_gl();
    bool video = false; // also out.mp4, by ffmpeg
    double frames_per_second = 30;
    std::size_t expected = 0; // frames, for the progress; 0 if unknown
    /// Called after each file, from one thread at a time; must not throw.
    std::function<void(std::size_t done, std::size_t expected)> progress;
};

struct FrameReport {
    std::size_t frames = 0;  // written
    std::size_t removed = 0; // files of an earlier run, removed before the first was written
    std::optional<std::filesystem::path> video;
    std::string renderer;                        // what drew
    std::string notice;                          // one line to show, or empty
    double draw_seconds = 0, encode_seconds = 0; // at work, summed over threads
};

/// `frame_00000.png`, `frame_00001.png`, … of one run: each written whole or not at all, none of an
/// earlier run left beside them, no number missing. The same pictures give the same files.
class FrameSequence {
public:
    /// Ready to draw. @throws InputError for a directory, a size or a video that cannot be
    explicit FrameSequence(const FrameOptions& options);

    /// Finishes what was pushed: a run that ends early leaves the frames up to there.
    ~FrameSequence();

    /// The next picture. Waits while too many are on their way, so that memory stays bounded.
    /// @throws what went wrong with an earlier one, such as InputError for a full disk
    void push(Picture picture);

    /// Waits until every file is written. @throws what went wrong
    FrameReport finish();

private:
    class Pipeline;
    std::unique_ptr<Pipeline> pipeline_;
};

} // namespace rigor
