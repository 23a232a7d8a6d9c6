// SPDX-License-Identifier: MIT
// Writes pictures to files. While one picture is drawn, earlier ones are compressed and written.
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
    std::filesystem::path directory; // made if it does not exist
    int width = 1280, height = 720;  // [pixels]
    Gl gl = default_gl();
    bool video = false; // whether ffmpeg makes the video out.mp4 as well
    double frames_per_second = 30;
    std::size_t expected = 0; // number of frames that will come, for `progress`; 0 if unknown
    /// Called after each file, from one thread at a time. If it throws, the run ends with this
    /// error.
    std::function<void(std::size_t done, std::size_t expected)> progress;
};

struct FrameReport {
    std::size_t frames = 0;  // number of frames written
    std::size_t removed = 0; // number of files of an earlier run that were removed
    std::optional<std::filesystem::path> video;
    std::string renderer; // the name of the renderer
    std::string notice;   // one line to show to the user, or empty
};

/// The files `frame_00000.png`, `frame_00001.png`, … of one run. Each is written completely or not
/// at all, none is left from an earlier run, and no number is missing. The same pictures give the
/// same files.
class FrameSequence {
public:
    /// Makes the directory and the renderer. Frames and video of an earlier run are removed.
    /// @throws InputError for a directory, a size or a video that cannot be used
    explicit FrameSequence(const FrameOptions& options);

    /// Finishes the pictures that were pushed, so that a run that ends early leaves its frames.
    ~FrameSequence();

    /// Adds the next picture. Waits while too many pictures are in the pipeline, so that they take
    /// only a limited amount of memory.
    /// @throws the error of an earlier picture, such as InputError for a full disk
    void push(Picture picture);

    /// Waits until every file is written. @throws the first error of the pipeline
    FrameReport finish();

private:
    class Pipeline;
    std::unique_ptr<Pipeline> pipeline_;
};

} // namespace rigor
