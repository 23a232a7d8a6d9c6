// SPDX-License-Identifier: MIT
// Encodes a video with ffmpeg. The raw pictures are sent to its stdin, and its stderr is kept in
// memory for the message of an error. The video has a temporary name until it is complete.
#include "render/video.hpp"

#include "errors/input_error.hpp"
#include "sandbox/notice_children.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace rigor {
namespace {

/// Starts a program from PATH with these descriptors as stdin and stderr. @return 0 or an errno
int spawn(pid_t& process, std::vector<std::string> words, int input, int errors)
{
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
    const int result =
        posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return result;
}

std::string last_line(int descriptor)
{
    std::array<char, 4096> text{};
    const off_t end = lseek(descriptor, 0, SEEK_END);
    const off_t start = std::max<off_t>(0, end - static_cast<off_t>(text.size()));
    const ssize_t size = pread(descriptor, text.data(), text.size(), start);
    std::string words(text.data(), size > 0 ? size : 0);
    while (!words.empty() && words.back() == '\n')
        words.pop_back();
    return words.substr(words.rfind('\n') + 1);
}

} // namespace

Video::Video(const std::filesystem::path& file, int width, int height, double frames_per_second)
    : file_(file), partial_(file)
{
    notice_children();
    partial_ += ".part";
    // A socket is used instead of a pipe, since writing to an ffmpeg that died is then an error and
    // not a signal.
    std::array<int, 2> ends{};
    errors_ = memfd_create("ffmpeg", MFD_CLOEXEC);
    if (errors_ < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw std::runtime_error(
            fmt::format("no descriptor for a video: {}", std::strerror(errno)));
    input_ = ends[0];
    const std::string size = fmt::format("{}x{}", width, height);
    const std::string rate = fmt::format("{}", frames_per_second);
    const int result = spawn(process_,
                             {"ffmpeg",
                              "-nostdin",
                              "-loglevel",
                              "error",
                              "-y",
                              "-f",
                              "rawvideo",
                              "-pix_fmt",
                              "rgba",
                              "-s",
                              size,
                              "-r",
                              rate,
                              "-i",
                              "pipe:0",
                              "-vf",
                              "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                              "-c:v",
                              "libx264",
                              "-preset",
                              "veryfast",
                              "-crf",
                              "20",
                              "-pix_fmt",
                              "yuv420p",
                              "-movflags",
                              "+faststart",
                              "-f",
                              "mp4",
                              "file:" + partial_.string()},
                             ends[1], errors_);
    close(ends[1]);
    if (result == 0) return;
    close_input();
    close(errors_);
    if (result == ENOENT)
        throw InputError("--video: ffmpeg is not installed: install the package ffmpeg, or leave "
                         "out --video");
    throw InputError(fmt::format("--video: ffmpeg cannot be started: {}", std::strerror(result)));
}

Video::~Video()
{
    close_input();
    wait();
    close(errors_);
    unlink(partial_.c_str()); // exists only if the video was not finished
}

void Video::close_input()
{
    if (input_ >= 0) close(std::exchange(input_, -1));
}

int Video::wait()
{
    int status = 0;
    if (process_ < 0) return status;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return status;
}

void Video::fail()
{
    close_input();
    wait();
    throw InputError(fmt::format("{}: ffmpeg failed: {}", file_.string(), last_line(errors_)));
}

void Video::add(const Image& image)
{
    const std::uint8_t* bytes = image.rgba.data();
    std::size_t left = image.rgba.size();
    while (left > 0) {
        const ssize_t sent = send(input_, bytes, left, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) fail();
        bytes += sent;
        left -= sent;
    }
}

void Video::finish()
{
    close_input();
    if (wait() != 0) fail();
    std::error_code error;
    std::filesystem::rename(partial_, file_, error);
    if (error) throw InputError(fmt::format("{}: {}", file_.string(), error.message()));
}

} // namespace rigor
