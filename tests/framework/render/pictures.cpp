// SPDX-License-Identifier: MIT
#include "pictures.hpp"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace rigor {

Picture box_picture(const Vector4f& color)
{
    Picture picture;
    picture.boxes.push_back({Matrix3f::Identity(), Vector3f::Zero(), color});
    return picture;
}

Picture ball_over_ground()
{
    Picture picture;
    picture.eye = Vector3f(0, 3, 6);
    picture.balls.push_back(
        {0.5F * Matrix3f::Identity(), Vector3f(0, 1, 0), linear_color(0.1, 0.3, 0.8)});
    picture.grounds.push_back({Matrix3f::Identity(), Vector3f::Zero(), true, false});
    return picture;
}

Eigen::Vector2f on_screen(const Picture& picture, const Vector3f& point, int width, int height)
{
    const Vector3f forward = (picture.target - picture.eye).normalized();
    const Vector3f right = forward.cross(Vector3f::UnitY()).normalized();
    const Vector3f up = right.cross(forward), way = point - picture.eye;
    const float half_height =
        way.dot(forward) * std::tan(picture.field_of_view * std::numbers::pi_v<float> / 360);
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    return {w / 2 + way.dot(right) / half_height * h / 2,
            h / 2 - way.dot(up) / half_height * h / 2};
}

int brightness(const std::uint8_t* pixel)
{
    return pixel[0] + pixel[1] + pixel[2];
}

int largest_difference(const Image& a, const Image& b)
{
    if (a.width != b.width || a.height != b.height) throw std::runtime_error("other sizes");
    int largest = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
        if (i % 4 != 3) largest = std::max(largest, std::abs(a.rgba[i] - b.rgba[i]));
    return largest;
}

Image decoded(const std::filesystem::path& file)
{
    Image image;
    int channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load(file.c_str(), &image.width, &image.height, &channels, 4), &stbi_image_free);
    if (!pixels || channels != 3) throw std::runtime_error(file.string() + " is not a PNG of RGB");
    image.rgba.assign(pixels.get(), pixels.get() + 4UL * image.width * image.height);
    return image;
}

bool has(Gl gl)
{
    const std::string file = gl == Gl::osmesa ? "render_osmesa.so" : "render_egl.so";
    return std::filesystem::exists(std::filesystem::path(RIGOR_BINARY_DIR) / "framework/render" /
                                   file);
}

std::string run_again(const std::string& environment, const std::string& test_spec)
{
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::string command = "env " + environment + " '" + self + "' '" + test_spec + "'";
    std::FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) throw std::runtime_error("cannot run " + command);
    std::string output;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
        output += static_cast<char>(c);
    return output + "status=" + std::to_string(WEXITSTATUS(pclose(pipe)));
}

SmallRun small_run()
{
    SmallRun run;
    run.scene.name = "small";
    run.scene.camera.position = {0, 2, 8};
    BodyDescription floor, box, ball;
    floor.name = "floor";
    floor.is_static = true;
    floor.parts.emplace_back().shape = Plane{};
    box.name = "box";
    box.parts.emplace_back().shape = Box{{1, 1, 1}};
    ball.name = "ball";
    ball.parts.emplace_back().shape = Sphere{0.5};
    run.scene.bodies = {floor, box, ball};
    for (const BodyDescription& body : run.scene.bodies) {
        RecordedBody recorded;
        recorded.is_static = body.is_static;
        if (!body.is_static) recorded.mass = 1;
        if (!body.is_static) recorded.inertia = Vector3d(0.1, 0.2, 0.3).asDiagonal();
        run.bodies.push_back(recorded);
    }
    run.frame.bodies.resize(3);
    run.frame.bodies[1].position = {-1, 0.5, 0};
    run.frame.bodies[2].position = {1, 0.5, 0};
    run.frame.bodies[1].angular_momentum = {0.1, 0.4, 0};
    return run;
}

std::vector<std::string> names_in(const std::filesystem::path& folder)
{
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
}

} // namespace rigor
