// SPDX-License-Identifier: MIT
// Reads a trajectory in stages. Each stage needs a known number of bytes, reads them, checks them,
// and names the next stage: first the header with scene and bodies, then a tag and its record,
// repeatedly, until the end record.
#include "scene/trajectory/reader.hpp"

#include "errors/quotes.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/trajectory/rigid_records.hpp"

#include <algorithm>

namespace rigor {

namespace {

// Larger counts are refused as damaged, before memory is reserved for them.
constexpr std::size_t most_name_bytes = 255, most_text_bytes = 16'000'000,
                      most_contacts = 1'000'000;

} // namespace

TrajectoryReader::TrajectoryReader(Handlers handlers) : handlers_(std::move(handlers))
{
    next(&TrajectoryReader::read_magic, 12);
}

TrajectoryReader::TrajectoryReader(Trajectory& whole)
    : TrajectoryReader(Handlers{
          [&whole](const Scene& scene, const std::vector<RecordedBody>& bodies) {
              whole.scene = scene;
              whole.bodies = bodies;
          },
          [&whole](Frame frame) { whole.frames.push_back(std::move(frame)); },
          [&whole](const Counters& counters) {
              whole.counters = counters;
              whole.complete = true;
          },
      })
{
}

void TrajectoryReader::next(Stage stage, std::size_t bytes)
{
    stage_ = stage;
    needed_ = bytes;
}

void TrajectoryReader::feed(std::span<const std::byte> bytes)
{
    if (broken_) fail("trajectory", "no more after its error", "more");
    pending_.insert(pending_.end(), bytes.begin(), bytes.end());
    std::size_t used = 0;
    broken_ = true; // it stays true if a stage throws
    while (!complete_ && pending_.size() - used >= needed_) {
        ByteCursor cursor{std::span<const std::byte>(pending_).subspan(used, needed_)};
        used += needed_;
        (this->*stage_)(cursor);
    }
    pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(used));
    if (complete_ && !pending_.empty())
        fail("trajectory", "nothing after its end", fmt::format("{} bytes", pending_.size()));
    broken_ = false;
}

void TrajectoryReader::read_magic(ByteCursor& bytes)
{
    char magic[8];
    bytes.raw(magic, 8);
    if (std::memcmp(magic, "RIGORTRJ", 8) != 0)
        fail("header", "a trajectory (\"RIGORTRJ\")", in_quotes(std::string_view(magic, 8)));
    version_ = bytes.take<std::uint32_t>();
    if (version_ != 1 && version_ != 2)
        fail("header", "version 1 or 2", fmt::format("version {}", version_));
    next(&TrajectoryReader::read_name_size, 4);
}

void TrajectoryReader::read_name_size(ByteCursor& bytes)
{
    const std::size_t size = count_of("header", "bytes of the scene's name",
                                      bytes.take<std::uint32_t>(), most_name_bytes);
    next(&TrajectoryReader::read_name, size + 4);
}

void TrajectoryReader::read_name(ByteCursor& bytes)
{
    name_.resize(bytes.left() - 4);
    bytes.raw(name_.data(), name_.size());
    const bool is_plain = std::all_of(name_.begin(), name_.end(), [](char c) {
        return static_cast<unsigned char>(c) >= 0x20 && c != 0x7F && c != '/';
    });
    if (!is_plain || name_.empty()) fail("header", "the name of a scene", in_quotes(name_));
    const std::size_t size = count_of("header", "bytes of the scene's text",
                                      bytes.take<std::uint32_t>(), most_text_bytes);
    next(&TrajectoryReader::read_text, size + 4);
}

void TrajectoryReader::read_text(ByteCursor& bytes)
{
    std::string text(bytes.left() - 4, ' ');
    bytes.raw(text.data(), text.size());
    scene_ = parse_scene(text, name_);
    scene_.name = name_;
    if (version_ == 1 && !scene_.solids.empty())
        fail("header", "version 2 of a scene with solids", "version 1");
    if (version_ == 2 && scene_.solids.empty())
        fail("header", "version 1 of a scene without solids", "version 2");
    const std::size_t count = bytes.take<std::uint32_t>();
    if (count != scene_.bodies.size())
        fail("header", fmt::format("the {} bodies of the scene", scene_.bodies.size()),
             fmt::format("{}", count));
    next(&TrajectoryReader::read_bodies, count * body_bytes);
}

void TrajectoryReader::read_bodies(ByteCursor& bytes)
{
    for (const BodyDescription& described : scene_.bodies)
        bodies_.push_back(read_recorded_body(bytes, described));
    if (version_ == 1)
        start();
    else
        next(&TrajectoryReader::read_solid_count, 4);
}

void TrajectoryReader::read_solid_count(ByteCursor& bytes)
{
    const std::size_t count = bytes.take<std::uint32_t>();
    if (count != scene_.solids.size())
        fail("header", fmt::format("the {} solids of the scene", scene_.solids.size()),
             fmt::format("{}", count));
    topologies_.resize(count);
    start();
}

void TrajectoryReader::start()
{
    started_ = true;
    if (handlers_.on_start) handlers_.on_start(scene_, bodies_);
    next(&TrajectoryReader::read_tag, 1);
}

void TrajectoryReader::read_tag(ByteCursor& bytes)
{
    const char tag = bytes.take<char>();
    if (tag == 'F')
        next(&TrajectoryReader::read_frame, 8 + 8 + scene_.bodies.size() * state_bytes + 4);
    else if (tag == 'E')
        next(&TrajectoryReader::read_counter_count, 4);
    else
        fail(fmt::format("after step {}", last_step_), "a frame (F) or the end (E)",
             in_quotes(std::string_view(&tag, 1)));
}

void TrajectoryReader::read_frame(ByteCursor& bytes)
{
    frame_ = {};
    frame_.step = bytes.take<std::int64_t>();
    if (frame_.step <= last_step_ || frame_.step > step_count(scene_))
        fail(fmt::format("after step {}", last_step_),
             fmt::format("a later step, up to {}", step_count(scene_)),
             fmt::format("{}", frame_.step));
    last_step_ = frame_.step;
    const std::string where = fmt::format("step {}", frame_.step);
    frame_.time = bytes.take<double>();
    const double time = static_cast<double>(frame_.step) * scene_.time_step;
    // The recorded time may differ from the product of step number and time step by rounding. The
    // allowed fractions of the time step and of the time are far above a rounding error, and far
    // below the difference to another step.
    constexpr double part_of_a_step = 1e-6, part_of_the_time = 1e-9;
    if (!(std::abs(frame_.time - time) <=
          part_of_a_step * scene_.time_step + part_of_the_time * time))
        fail(where, fmt::format("the time {}", time), fmt::format("{}", frame_.time));
    for (const BodyDescription& body : scene_.bodies)
        frame_.bodies.push_back(read_state(bytes, frame_.step, body));
    const std::size_t contacts =
        count_of(where, "contacts", bytes.take<std::uint32_t>(), most_contacts);
    next(&TrajectoryReader::read_contacts, contacts * contact_bytes);
}

void TrajectoryReader::read_contacts(ByteCursor& bytes)
{
    const std::int64_t bodies = static_cast<std::int64_t>(scene_.bodies.size());
    for (std::size_t count = bytes.left() / contact_bytes; count > 0; --count)
        frame_.contacts.push_back(read_contact(bytes, frame_.step, bodies));
    next_solid();
}

std::string TrajectoryReader::solid_place() const
{
    return fmt::format("step {}, solid {}", frame_.step,
                       in_quotes(scene_.solids[frame_.solids.size()].name));
}

void TrajectoryReader::next_solid()
{
    if (frame_.solids.size() == scene_.solids.size())
        finish_frame();
    else
        next(&TrajectoryReader::read_solid, 1);
}

void TrajectoryReader::read_solid(ByteCursor& bytes)
{
    const std::uint8_t is_new = bytes.take<std::uint8_t>();
    if (is_new > 1)
        fail(solid_place(), "mark 0 or 1 of a new mesh", fmt::format("mark {}", is_new));
    is_new_topology_ = is_new == 1;
    if (is_new_topology_) {
        next(&TrajectoryReader::read_counts, topology_counts_size);
        return;
    }
    if (!topologies_[frame_.solids.size()])
        fail(solid_place(), "a mesh in the first frame", "none");
    expect_solid_state();
}

void TrajectoryReader::read_counts(ByteCursor& bytes)
{
    counts_ = read_topology_counts(bytes, solid_place());
    next(&TrajectoryReader::read_mesh, topology_size(counts_));
}

void TrajectoryReader::read_mesh(ByteCursor& bytes)
{
    topologies_[frame_.solids.size()] = read_topology(bytes, counts_, solid_place());
    expect_solid_state();
}

void TrajectoryReader::expect_solid_state()
{
    next(&TrajectoryReader::read_solid_state, solid_frame_size(*topologies_[frame_.solids.size()]));
}

void TrajectoryReader::read_solid_state(ByteCursor& bytes)
{
    SolidFrame solid;
    solid.topology = topologies_[frame_.solids.size()];
    solid.is_new_topology = is_new_topology_;
    read_solid_frame(bytes, solid, solid_place());
    frame_.solids.push_back(std::move(solid));
    next_solid();
}

void TrajectoryReader::finish_frame()
{
    if (handlers_.on_frame) handlers_.on_frame(std::move(frame_));
    next(&TrajectoryReader::read_tag, 1);
}

void TrajectoryReader::read_counter_count(ByteCursor& bytes)
{
    const std::size_t count = bytes.take<std::uint32_t>();
    if (count != std::size(counter_fields))
        fail("end", fmt::format("{} counters", std::size(counter_fields)),
             fmt::format("{}", count));
    next(&TrajectoryReader::read_counters, count * sizeof(std::uint64_t));
}

void TrajectoryReader::read_counters(ByteCursor& bytes)
{
    Counters counters;
    for (const CounterField& field : counter_fields)
        counters.*field.member = bytes.take<std::uint64_t>();
    complete_ = true;
    if (handlers_.on_end) handlers_.on_end(counters);
}

} // namespace rigor
