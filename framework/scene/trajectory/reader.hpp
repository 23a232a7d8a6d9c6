// SPDX-License-Identifier: MIT
#pragma once

#include "scene/trajectory/solid_records.hpp"

#include <functional>
#include <span>
#include <string>

namespace rigor {

/// Reads the bytes of a trajectory as they arrive, in chunks of any size, and calls a handler for
/// the header and for each complete record. The bytes are not trusted: every count is checked
/// before it is used, and a number that is infinite or NaN is an error. After an error, the reader
/// accepts no more bytes.
class TrajectoryReader {
public:
    struct Handlers {
        std::function<void(const Scene&, const std::vector<RecordedBody>&)> on_start;
        std::function<void(Frame)> on_frame;
        std::function<void(const Counters&)> on_end;
    };
    explicit TrajectoryReader(Handlers handlers);
    /// Stores all records in `whole`.
    explicit TrajectoryReader(Trajectory& whole);

    /// @throws InputError if the bytes are not a trajectory; the message names the record and the
    ///     quantity
    void feed(std::span<const std::byte> bytes);

    bool started() const { return started_; }
    bool complete() const { return complete_; }

private:
    using Stage = void (TrajectoryReader::*)(ByteCursor&);

    void next(Stage stage, std::size_t bytes);
    void read_magic(ByteCursor& bytes);
    void read_name_size(ByteCursor& bytes);
    void read_name(ByteCursor& bytes);
    void read_text(ByteCursor& bytes);
    void read_bodies(ByteCursor& bytes);
    void read_solid_count(ByteCursor& bytes);
    void start();
    void read_tag(ByteCursor& bytes);
    void read_frame(ByteCursor& bytes);
    void read_contacts(ByteCursor& bytes);
    void next_solid();
    void read_solid(ByteCursor& bytes);
    void read_counts(ByteCursor& bytes);
    void read_mesh(ByteCursor& bytes);
    void expect_solid_state();
    void read_solid_state(ByteCursor& bytes);
    std::string solid_place() const; // names the solid being read, for error messages
    void finish_frame();
    void read_counter_count(ByteCursor& bytes);
    void read_counters(ByteCursor& bytes);

    Handlers handlers_;
    std::vector<std::byte> pending_; // received bytes, too few for the next stage
    Stage stage_;
    std::size_t needed_ = 0; // number of bytes that the stage needs
    Scene scene_;
    std::uint32_t version_ = 1;
    std::string name_;
    std::vector<RecordedBody> bodies_; // from the header
    Frame frame_;                      // the frame being read
    bool is_new_topology_ = false;     // whether the solid being read has a new mesh
    TopologyCounts counts_;            // sizes of the mesh being read
    std::vector<std::shared_ptr<const SolidTopology>> topologies_; // the last mesh of each solid
    std::int64_t last_step_ = -1;
    bool started_ = false, complete_ = false, broken_ = false;
};

} // namespace rigor
