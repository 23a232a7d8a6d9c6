// SPDX-License-Identifier: MIT
// The shared parts of the commands that draw: their options, and the writing of frames to files.
#pragma once

#include "grading/build/implementation.hpp"
#include "render/frames.hpp"
#include "render/visualizer.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <memory>
#include <string>

namespace rigor {

class Options;
class Progress;

struct DrawOptions {
    std::string size = "1280x720", gl;
    bool video = false, axes = false, omega = false, momentum = false, contacts = false,
         labels = false;
};

void declare_drawing(Options& options, DrawOptions& draw);

/// Checks the options before anything is built or run. @throws InputError if the size, or the
/// OpenGL library that --gl names, is not supported
void check_drawing(const DrawOptions& options);

/// Writes the frames of one scene to a folder and shows a progress bar.
class Film {
public:
    /// @throws InputError if the size, the folder or the OpenGL library (--gl) cannot be used
    Film(const std::string& folder, const Scene& scene, const DrawOptions& options);
    ~Film();

    /// Sets the scene and its bodies, which `add` draws. Call this function before `add`.
    void start(const Scene& scene, const std::vector<RecordedBody>& bodies);
    void add(const Frame& frame);
    /// Adds a frame, with the frame of another run drawn translucent (as a ghost) in the same
    /// picture.
    void add(const Frame& frame, const Frame& other, const std::string& name,
             const std::string& other_name);

    /// Waits until all frames are written and prints where they are. @return the number of frames
    std::size_t finish();

private:
    std::string folder_;
    Overlays overlays_;
    std::unique_ptr<Progress> progress_;
    FrameOptions options_;
    std::unique_ptr<FrameSequence> sequence_;
    std::unique_ptr<Visualizer> visualizer_;
    double seconds_at_start_ = 0;
};

/// Tells after which time steps of a scene a frame is drawn. `picks` must be called with steps in
/// increasing order: for a step below that of an earlier call it returns false.
class FramePicker {
public:
    explicit FramePicker(const Scene& scene) : scene_(scene) {}
    bool picks(std::int64_t step)
    {
        while (frame_step(scene_, next_) < step)
            ++next_;
        return frame_step(scene_, next_) == step;
    }

private:
    const Scene& scene_;
    std::int64_t next_ = 0;
};

/// Simulates a scene, draws it at the same time, and prints where the frames are. @return the exit
/// status
int render_scene(const Scene& scene, const Implementation& implementation,
                 const std::string& folder, const DrawOptions& options);

/// Draws two runs of a scene. Each picture shows both runs at one moment, up to the end of the
/// shorter run.
void draw_comparison(const Trajectory& expected, const Trajectory& actual, const std::string& name,
                     const std::string& folder, const DrawOptions& options);

} // namespace rigor
