// SPDX-License-Identifier: MIT
// Small pictures and a small scene to draw, an independent PNG decoder, and other helpers for the
// tests of pictures.
#pragma once

#include "render/image.hpp"
#include "render/picture.hpp"
#include "render/renderer.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// A cube with an edge of 2 m at the origin, of which the camera sees three faces.
Picture box_picture(const Vector4f& color);

/// A ball of radius 0.5 m, whose center is 1 m above the ground.
Picture ball_over_ground();

/// Where a point of the scene lies on a picture of this size [pixels].
Eigen::Vector2f on_screen(const Picture& picture, const Vector3f& point, int width, int height);

/// Red + green + blue, 0 … 765.
int brightness(const std::uint8_t* pixel);

/// Largest difference of a channel between two images of the same size.
int largest_difference(const Image& a, const Image& b);

/// The image that stb_image reads from a file.
Image decoded(const std::filesystem::path& file);

/// Whether the module that draws with this library (OSMesa or EGL) was built.
bool has(Gl gl);

/// Runs the current program again with other environment variables. @return its output, and its
/// status after "status="
std::string run_again(const std::string& environment, const std::string& test_spec);

/// A scene with a floor, a box and a ball, its record and one frame.
struct SmallRun {
    Scene scene;
    std::vector<RecordedBody> bodies;
    Frame frame;
};
SmallRun small_run();

/// The names of the files in a folder, sorted.
std::vector<std::string> names_in(const std::filesystem::path& folder);

} // namespace rigor
