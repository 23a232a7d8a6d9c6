// SPDX-License-Identifier: MIT
// A video that the program ffmpeg encodes while the pictures are drawn.
#pragma once

#include "render/image.hpp"

#include <sys/types.h>

#include <filesystem>

namespace rigor {

/// H.264 video in an MP4 file. The file is written completely or not at all. The picture gets one
/// more column or row if its width or height is odd, since H.264 needs even sizes.
class Video {
public:
    /// @throws InputError if ffmpeg is not installed
    Video(const std::filesystem::path& file, int width, int height, double frames_per_second);
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;
    ~Video();

    /// @throws InputError with ffmpeg's last message, if ffmpeg has ended
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
