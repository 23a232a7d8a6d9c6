// SPDX-License-Identifier: MIT
#include "errors/input_error.hpp"
#include "pictures.hpp"
#include "render/frames.hpp"
#include "render/png.hpp"
#include "render/visualizer.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

using namespace rigor;
using rigor::testing::TemporaryFolder;

namespace {

FrameOptions options_for(const TemporaryFolder& folder)
{
    FrameOptions options;
    options.directory = folder.path();
    options.width = 64;
    options.height = 48;
    return options;
}

/// A box that moves to the right.
Picture picture_of(int frame)
{
    Picture picture = box_picture(linear_color(0.8, 0.2, 0.1));
    picture.boxes[0].position.x() = 0.2F * static_cast<float>(frame);
    return picture;
}

FrameReport run(const FrameOptions& options, int frames)
{
    FrameSequence sequence(options);
    for (int i = 0; i < frames; ++i)
        sequence.push(picture_of(i));
    return sequence.finish();
}

void write(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream(file) << text;
}

/// While this object lives, no file may grow beyond a limit. This is the nearest to a full disk
/// that works without being root.
class LargestFile {
public:
    explicit LargestFile(rlim_t bytes)
    {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        std::signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    LargestFile(const LargestFile&) = delete;
    LargestFile& operator=(const LargestFile&) = delete;
    ~LargestFile() { setrlimit(RLIMIT_FSIZE, &before_); }

private:
    rlimit before_{};
};

/// Sets PATH as long as this object lives.
class Path {
public:
    explicit Path(const std::string& path) : before_(std::getenv("PATH"))
    {
        setenv("PATH", path.c_str(), 1);
    }
    Path(const Path&) = delete;
    Path& operator=(const Path&) = delete;
    ~Path() { setenv("PATH", before_.c_str(), 1); }

private:
    std::string before_;
};

bool has_ffmpeg()
{
    return std::system("ffmpeg -version > /dev/null 2>&1") == 0;
}

} // namespace

TEST_CASE("frames: a PNG holds the pixels that were drawn", "[render]")
{
    const TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair(1, 1), {7, 3}, {320, 200}}) {
        Image image{width, height, {}};
        for (int i = 0; i < 4 * width * height; ++i)
            image.rgba.push_back(static_cast<std::uint8_t>(i % 4 == 3 ? 255 : i * 7 + i / 97));
        write_picture(folder.path() / "a.png", png_bytes(image));
        CHECK(decoded(folder.path() / "a.png").rgba == image.rgba);
    }
    CHECK(names_in(folder.path()) == std::vector<std::string>{"a.png"});
}

TEST_CASE("frames: every picture becomes its file and the same files the next time", "[render]")
{
    const TemporaryFolder first, second;
    FrameOptions options = options_for(first);
    std::vector<std::size_t> done;
    options.expected = 9;
    options.progress = [&](std::size_t frames, std::size_t) { done.push_back(frames); };
    const FrameReport report = run(options, 9);
    run(options_for(second), 9);

    CHECK(report.frames == 9);
    CHECK(report.removed == 0);
    CHECK_FALSE(report.video);
    CHECK(done == std::vector<std::size_t>{1, 2, 3, 4, 5, 6, 7, 8, 9});
    REQUIRE(names_in(first.path()).size() == 9);
    CHECK(names_in(first.path()) == names_in(second.path()));
    CHECK(names_in(first.path())[8] == "frame_00008.png");
    const OpenRenderer opened = open_renderer(64, 48);
    for (int i = 0; i < 9; ++i) {
        const std::string name = names_in(first.path())[i];
        CHECK(decoded(first.path() / name).rgba == opened.renderer->draw(picture_of(i)).rgba);
        CHECK(decoded(first.path() / name).rgba == decoded(second.path() / name).rgba);
    }
}

TEST_CASE("frames: those of an earlier run are gone and other files stay", "[render]")
{
    const TemporaryFolder folder;
    run(options_for(folder), 5);
    write(folder.path() / "frame_00007.png.part", "torn");
    write(folder.path() / "frame_notes.png", "mine");
    write(folder.path() / "frame_000001.png", "mine");
    const FrameReport report = run(options_for(folder), 2);
    CHECK(report.removed == 6);
    CHECK(names_in(folder.path()) == std::vector<std::string>{"frame_00000.png", "frame_000001.png",
                                                              "frame_00001.png",
                                                              "frame_notes.png"});
}

TEST_CASE("frames: a run that ends early leaves the frames up to there", "[render]")
{
    const TemporaryFolder folder;
    const auto worker_dies = [&] {
        FrameSequence sequence(options_for(folder));
        for (int i = 0; i < 4; ++i)
            sequence.push(picture_of(i));
        throw std::logic_error("the worker died");
    };
    CHECK_THROWS_AS(worker_dies(), std::logic_error);
    CHECK(names_in(folder.path()).size() == 4);
    CHECK(names_in(folder.path()).back() == "frame_00003.png");
}

TEST_CASE("frames: a full disk is told and leaves no torn file and no gap", "[render]")
{
    const TemporaryFolder folder;
    FrameSequence sequence(options_for(folder));
    for (int i = 0; i < 2; ++i)
        sequence.push(picture_of(i));
    const auto fill = [&] {
        const LargestFile limit(100);
        for (int i = 2; i < 40; ++i)
            sequence.push(picture_of(i));
        sequence.finish();
    };
    try {
        fill();
        FAIL("written through the limit");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).find("cannot be written: File too large") !=
              std::string::npos);
        CHECK(std::string(error.what()).starts_with((folder.path() / "frame_").string()));
    }
    const auto names = names_in(folder.path());
    for (std::size_t i = 0; i < names.size(); ++i)
        CHECK(names[i] == "frame_0000" + std::to_string(i) + ".png");
    CHECK(names.size() < 3);
}

TEST_CASE("frames: a directory that cannot be is told at once", "[render]")
{
    const TemporaryFolder folder;
    write(folder.path() / "file", "not a directory");
    FrameOptions options = options_for(folder);
    options.directory = folder.path() / "file" / "frames";
    CHECK_THROWS_AS(FrameSequence(options), InputError);
    options.directory = "/proc/frames";
    CHECK_THROWS_AS(FrameSequence(options), InputError);
    options.directory = folder.path();
    options.width = 100000;
    CHECK_THROWS_AS(FrameSequence(options), InputError);
    options.width = 64;
    options.expected = 100001;
    CHECK_THROWS_AS(FrameSequence(options), InputError);
    CHECK_THROWS_AS(write_picture(folder.path() / "none" / "a.png", {}), InputError);
}

TEST_CASE("frames: a video is whole, of odd sizes too", "[render]")
{
    if (!has_ffmpeg()) {
        WARN("ffmpeg is not installed");
        SUCCEED();
        return;
    }
    const TemporaryFolder folder;
    FrameOptions options = options_for(folder);
    options.width = 65;
    options.height = 47;
    options.video = true;
    options.frames_per_second = 10;
    const FrameReport report = run(options, 12);
    REQUIRE(report.video);
    CHECK(names_in(folder.path()).size() == 13);
    // ffmpeg decodes the video: it has as many pictures, with one more row and column.
    const std::string raw = (folder.path() / "raw").string();
    const std::string command = "ffmpeg -loglevel error -i '" + report.video->string() +
                                "' -f rawvideo -pix_fmt gray '" + raw + "'";
    REQUIRE(std::system(command.c_str()) == 0);
    CHECK(std::filesystem::file_size(raw) == 12 * 66 * 48);
}

TEST_CASE("frames: without ffmpeg a video is refused with the way to get it", "[render]")
{
    const TemporaryFolder folder;
    FrameOptions options = options_for(folder);
    options.video = true;
    const Path nowhere("/nowhere");
    CHECK_THROWS_WITH(FrameSequence(options),
                      "--video: ffmpeg is not installed: install the package ffmpeg, or leave out "
                      "--video");
}

TEST_CASE("frames: what ffmpeg died of is told and no torn video stays", "[render]")
{
    const TemporaryFolder folder, tools;
    write(tools.path() / "ffmpeg", "#!/bin/sh\necho no codec today >&2\nexit 1\n");
    std::filesystem::permissions(tools.path() / "ffmpeg", std::filesystem::perms::all);
    FrameOptions options = options_for(folder);
    options.video = true;
    const Path fake(tools.path().string());
    std::signal(SIGCHLD, SIG_IGN); // as it may be for a program that a daemon starts
    CHECK_THROWS_WITH(run(options, 30),
                      (folder.path() / "out.mp4").string() + ": ffmpeg failed: no codec today");
    for (const std::string& name : names_in(folder.path()))
        CHECK(name.ends_with(".png"));
}
