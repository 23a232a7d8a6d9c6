// SPDX-License-Identifier: MIT
// Draws, compresses and writes pictures in a pipeline of threads. One thread draws, two compress
// and write PNG files, and one passes the pictures to the video. Bounded queues between these
// stages limit the memory; the first error of a stage ends all of them.
#include "render/frames.hpp"

#include "errors/input_error.hpp"
#include "render/png.hpp"
#include "render/queue.hpp"
#include "render/video.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <future>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace rigor {
namespace {

constexpr std::size_t most_frames = 100000; // since file names have five digits
constexpr std::size_t on_their_way = 3;     // largest number of pictures between two stages

std::filesystem::path frame_file(const std::filesystem::path& directory, std::size_t number)
{
    return directory / fmt::format("frame_{:05}.png", number);
}

/// Whether this is the name of a frame, frame_00000.png … frame_99999.png, or of a frame that was
/// being written when an earlier run was killed.
bool is_frame(const std::string& name)
{
    return (name.size() == 15 || (name.size() == 20 && name.ends_with(".part"))) &&
           name.starts_with("frame_") && name.substr(11, 4) == ".png" &&
           std::all_of(name.begin() + 6, name.begin() + 11,
                       [](char c) { return c >= '0' && c <= '9'; });
}

/// Makes the directory and removes the frames and the video of an earlier run.
/// @return the number of removed files
std::size_t clear_directory(const std::filesystem::path& directory)
{
    std::size_t removed = 0;
    try {
        std::filesystem::create_directories(directory);
        std::vector<std::filesystem::path> old;
        for (const auto& entry : std::filesystem::directory_iterator(directory)) {
            const std::string name = entry.path().filename().string();
            if (is_frame(name) || name == "out.mp4" || name == "out.mp4.part")
                old.push_back(entry.path());
        }
        for (const auto& file : old)
            removed += std::filesystem::remove(file);
    } catch (const std::filesystem::filesystem_error& error) {
        throw InputError(fmt::format("{}: expected a directory to write to: {}", directory.string(),
                                     error.code().message()));
    }
    return removed;
}

} // namespace

class FrameSequence::Pipeline {
public:
    explicit Pipeline(const FrameOptions& options);
    Pipeline(const Pipeline&) = delete;
    Pipeline& operator=(const Pipeline&) = delete;
    ~Pipeline() { join(); }

    void push(Picture picture);
    FrameReport finish();

private:
    struct Drawn {
        std::size_t number;
        std::shared_ptr<const Image> image;
    };

    void draw(std::promise<OpenRenderer> ready);
    void draw_pictures(Renderer& renderer);
    void encode();
    void film();
    void fail(); // keeps the current exception for `finish` and ends every stage
    void join();
    void rethrow();
    void note_written(std::size_t number);

    FrameOptions options_;
    FrameReport report_;
    std::unique_ptr<Video> video_;
    Queue<Picture> pictures_{on_their_way};
    Queue<Drawn> drawn_{on_their_way};
    Queue<Drawn> filmed_{on_their_way};
    std::size_t pushed_ = 0;

    std::mutex mutex_; // guards error_ and written_
    std::exception_ptr error_;
    std::set<std::size_t> written_;

    std::thread drawer_, filmer_;
    // Two threads are enough: to draw a picture takes several times as long as to encode it.
    std::array<std::thread, 2> encoders_;
};

FrameSequence::Pipeline::Pipeline(const FrameOptions& options) : options_(options)
{
    check_size(options.width, options.height);
    if (options.expected > most_frames)
        throw InputError(
            fmt::format("expected at most {} frames, found {}: their numbers have five digits",
                        most_frames, options.expected));
    report_.removed = clear_directory(options.directory);
    if (options.video) {
        report_.video = options.directory / "out.mp4";
        video_ = std::make_unique<Video>(*report_.video, options.width, options.height,
                                         options.frames_per_second);
    }
    // The context is made by the thread that draws, since an OpenGL context belongs to one thread.
    std::promise<OpenRenderer> ready;
    std::future<OpenRenderer> opened = ready.get_future();
    drawer_ =
        std::thread([this, promise = std::move(ready)]() mutable { draw(std::move(promise)); });
    try {
        report_.notice = opened.get().notice;
    } catch (...) {
        drawer_.join();
        throw;
    }
    for (std::thread& encoder : encoders_)
        encoder = std::thread([this] { encode(); });
    if (video_) filmer_ = std::thread([this] { film(); });
}

void FrameSequence::Pipeline::draw(std::promise<OpenRenderer> ready)
{
    std::unique_ptr<Renderer> renderer;
    try {
        OpenRenderer opened = open_renderer(options_.width, options_.height, options_.gl);
        renderer = std::move(opened.renderer);
        report_.renderer = renderer->name();
        ready.set_value({nullptr, opened.notice});
    } catch (...) {
        ready.set_exception(std::current_exception());
        return;
    }
    try {
        draw_pictures(*renderer);
    } catch (...) {
        fail();
    }
    drawn_.close();
    filmed_.close();
}

void FrameSequence::Pipeline::draw_pictures(Renderer& renderer)
{
    for (std::size_t number = 0; const auto picture = pictures_.pop(); ++number) {
        const auto image = std::make_shared<const Image>(renderer.draw(*picture));
        if (video_) filmed_.push({number, image});
        drawn_.push({number, image});
    }
}

void FrameSequence::Pipeline::encode()
try {
    while (const auto drawn = drawn_.pop()) {
        write_picture(frame_file(options_.directory, drawn->number), png_bytes(*drawn->image));
        note_written(drawn->number);
    }
} catch (...) {
    fail();
}

void FrameSequence::Pipeline::film()
try {
    std::size_t filmed = 0;
    for (; const auto drawn = filmed_.pop(); ++filmed)
        video_->add(*drawn->image);
    bool whole = false;
    {
        const std::scoped_lock lock(mutex_);
        whole = !error_;
    }
    if (whole && filmed > 0) video_->finish();
} catch (...) {
    fail();
}

void FrameSequence::Pipeline::note_written(std::size_t number)
{
    const std::scoped_lock lock(mutex_);
    written_.insert(number);
    if (options_.progress) options_.progress(written_.size(), options_.expected);
}

void FrameSequence::Pipeline::fail()
{
    {
        const std::scoped_lock lock(mutex_);
        if (!error_) error_ = std::current_exception();
    }
    pictures_.close(true);
    drawn_.close(true);
    filmed_.close(true);
}

void FrameSequence::Pipeline::rethrow()
{
    const std::scoped_lock lock(mutex_);
    if (error_) std::rethrow_exception(error_);
}

void FrameSequence::Pipeline::push(Picture picture)
{
    if (pushed_ == most_frames)
        throw InputError(
            fmt::format("{}: more than {} frames", options_.directory.string(), most_frames));
    // `pictures_.push` returns false after an error. No file is left half written then: `finish`
    // ends every stage before it throws the error.
    if (!pictures_.push(std::move(picture))) finish();
    ++pushed_;
}

/// Ends every stage, in order. If one encoder failed, the other one may have written a later frame.
/// So all frames after the first missing one are removed, and the numbers have no gap.
void FrameSequence::Pipeline::join()
{
    pictures_.close();
    for (std::thread* thread : {&drawer_, &encoders_[0], &encoders_[1], &filmer_})
        if (thread->joinable()) thread->join();
    std::size_t whole = 0;
    for (auto number = written_.begin(); number != written_.end() && *number == whole; ++number)
        ++whole;
    for (auto number = written_.lower_bound(whole); number != written_.end(); ++number) {
        std::error_code ignored; // ignored, since the disk may have failed already
        std::filesystem::remove(frame_file(options_.directory, *number), ignored);
    }
    written_.erase(written_.lower_bound(whole), written_.end());
    report_.frames = written_.size();
}

FrameReport FrameSequence::Pipeline::finish()
{
    join();
    rethrow();
    return report_;
}

FrameSequence::FrameSequence(const FrameOptions& options)
    : pipeline_(std::make_unique<Pipeline>(options))
{
}
FrameSequence::~FrameSequence() = default;
void FrameSequence::push(Picture picture)
{
    pipeline_->push(std::move(picture));
}
FrameReport FrameSequence::finish()
{
    return pipeline_->finish();
}

} // namespace rigor
