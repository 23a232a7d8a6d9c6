// SPDX-License-Identifier: MIT
// Small pictures, an independent PNG decoder and a folder for a test's files.
#pragma once

#include "render/image.hpp"
#include "render/picture.hpp"
#include "render/renderer.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// A box of 2 m in front of the camera, turned so that three faces show.
Picture box_picture(const Vector4f& color);

/// A ball of radius 0.5 m that hovers 1 m over a ground.
Picture ball_over_ground();

/// Where a point of the scene lies on a picture of this size [pixels].
Eigen::Vector2f on_screen(const Picture& picture, const Vector3f& point, int width, int height);

/// Red + green + blue, 0 … 765.
int brightness(const std::uint8_t* pixel);

/// Largest difference of a channel; sizes must agree.
int largest_difference(const Image& a, const Image& b);

/// As stb_image reads it.
Image decoded(const std::filesystem::path& file);

/// Whether a module was built.
bool has(Gl gl);

/// The program that runs now, with other surroundings: its output, and its status after "status=".
std::string run_again(const std::string& environment, const std::string& test_spec);

/// A scene of a floor, a box and a ball, with its record and a frame of it.
struct SmallRun {
    Scene scene;
    std::vector<RecordedBody> bodies;
    Frame frame;
};
SmallRun small_run();

/// Of the files in a folder, sorted.
std::vector<std::string> names_in(const std::filesystem::path& folder);

} // namespace rigor
