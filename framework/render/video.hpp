// SPDX-License-Identifier: MIT
// A video, encoded by the program ffmpeg while the pictures are drawn.
#pragma once

#include "render/image.hpp"

#include <sys/types.h>

#include <filesystem>

namespace rigor {

/// H.264 in an MP4 file, which appears whole or not at all. Odd sizes get one more row or column.
class Video {
public:
    /// @throws InputError if ffmpeg is not installed
    Video(const std::filesystem::path& file, int width, int height, double frames_per_second);
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;
    ~Video();

    /// @throws InputError with ffmpeg's last words if it gave up
    void add(const Image& image);
    void finish();

private:
    [[noreturn]] void fail();
    int wait();
    void close_input();

    std::filesystem::path file_, partial_;
    int input_ = -1, errors_ = -1; // descriptors
    pid_t process_ = -1;
};

} // namespace rigor
