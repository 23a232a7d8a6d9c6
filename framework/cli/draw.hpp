// SPDX-License-Identifier: MIT
// What the drawing commands share: their options, and the way from frames to files.
#pragma once

#include "grading/implementation.hpp"
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

/// @throws InputError for a size or a way to draw that cannot be; before anything is built or run
void check_drawing(const DrawOptions& options);

/// Frames of one scene to a folder, with a progress bar.
class Film {
public:
    /// @throws InputError for a size, a folder or a way to draw that cannot be
    Film(const std::string& folder, const Scene& scene, const DrawOptions& options);
    ~Film();

    /// Before the first frame: what plays.
    void start(const Scene& scene, const std::vector<RecordedBody>& bodies);
    void add(const Frame& frame);
    /// The frame, and that of another run as a ghost.
    void add(const Frame& frame, const Frame& other, const std::string& name,
             const std::string& other_name);

    /// Waits until all is written and says where it lies. @return frames
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

/// Whether a step of a scene is one of its frames; to be asked in the order of the steps.
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

/// A scene, simulated and drawn at the same time. Says where the frames are. @return the exit
/// status
int render_scene(const Scene& scene, const Implementation& implementation,
                 const std::string& folder, const DrawOptions& options);

/// Two runs of a scene in one picture a frame, as far as both go.
void draw_comparison(const Trajectory& expected, const Trajectory& actual, const std::string& name,
                     const std::string& folder, const DrawOptions& options);

} // namespace rigor
