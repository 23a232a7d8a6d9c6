// SPDX-License-Identifier: MIT
// The recorded motion of a scene: written by a worker, streamed, stored, read while it is being
// written.
//
// Little-endian binary:
//     "RIGORTRJ"  u32 version = 1
//     u32 bytes, name of the scene       u32 bytes, scene file as text
//     u32 bodies, each: u8 is_static, f64 mass, 3 f64 center of mass, 9 f64 inertia (I_body by
//         columns)
// then records until the end:
//     'F'  i64 step, f64 time, bodies × 13 f64 (X, q = s x y z, V, L),
//          u32 contacts, each: i32 body1, i32 body2, f64 depth, 9 f64 (point, normal, impulse)
//     'E'  u32 counters, each u64 in the order of Counters: the run is complete
// A file that stops before 'E' holds the run up to there.
#pragma once

#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// The world at one moment.
struct Frame {
    std::int64_t step = 0;
    double time = 0; // [s]
    std::vector<RigidState> bodies;
    std::vector<ContactRecord> contacts; // of the step that led here
};

/// Mass and inertia of a body as the worker computed them.
struct RecordedBody {
    bool is_static = false;
    double mass = 0;                            // [kg]
    Vector3d center_of_mass = Vector3d::Zero(); // in the body's frame as the scene file has it [m]
    Matrix3d inertia = Matrix3d::Zero();        // I_body [kg m²]
};

struct Trajectory {
    Scene scene;
    std::vector<RecordedBody> bodies;
    std::vector<Frame> frames;
    Counters counters;
    bool complete = false; // the end record was there
};

/// The counters by name, in the order of the end record.
struct CounterField {
    std::string_view name;
    std::uint64_t Counters::*member;
};
inline constexpr CounterField counter_fields[] = {
    {"steps", &Counters::steps},
    {"substeps", &Counters::substeps},
    {"pairs possible", &Counters::pairs_possible},
    {"pairs tested", &Counters::pairs_tested},
    {"contacts", &Counters::contacts},
    {"collision impulses", &Counters::collision_impulses},
    {"contact impulses", &Counters::contact_impulses},
    {"isotropic shortcuts", &Counters::isotropic_shortcuts},
    {"free flights", &Counters::free_flights},
    {"static skipped", &Counters::static_skipped},
    {"islands", &Counters::islands},
    {"bodies asleep", &Counters::bodies_asleep},
    {"warm starts", &Counters::warm_starts},
    {"contact sweeps", &Counters::contact_sweeps},
    {"early exits", &Counters::early_exits},
    {"Newton solves", &Counters::newton_solves},
    {"healed contacts", &Counters::healed_contacts},
    {"level sets built", &Counters::level_sets_built},
    {"level set samples", &Counters::level_set_samples},
    {"deformable substeps", &Counters::deformable_substeps},
    {"system solves", &Counters::system_solves},
    {"solver iterations", &Counters::solver_iterations},
    {"node impulses", &Counters::node_impulses},
    {"elements flowed", &Counters::elements_flowed},
    {"flow skipped", &Counters::flow_skipped},
    {"eigenvalues", &Counters::eigenvalues},
    {"eigenvalues skipped", &Counters::eigenvalues_skipped},
    {"cracks", &Counters::cracks},
    {"mesh changes", &Counters::mesh_changes},
};
static_assert(sizeof(Counters) == sizeof(std::uint64_t) * std::size(counter_fields));

/// Which moments a run records.
enum class Record { frames, every_step };

using Bytes = std::vector<std::byte>;
using ByteSink = std::function<void(std::span<const std::byte>)>;

/// Runs a scene and hands the bytes of its trajectory to `write`, a record at a time. Frame k is
/// the state after the step nearest to its time; frame 0 is the initial state.
void run_scene(const Scene& scene, Record record, const ByteSink& write,
               const RunSettings& settings = {});

/// The states of all bodies at a moment.
using Moment = std::pair<double, std::vector<RigidState>>;

/// The states that each moment of a scene leads to after some steps.
/// @param starts  each time a multiple of the time step, each with a state for every body
std::vector<std::vector<RigidState>> advance(const Scene& scene, const std::vector<Moment>& starts,
                                             int steps, const RunSettings& settings = {});

/// The records of a trajectory as bytes.
Bytes encode_start(const Scene& scene, const std::vector<RecordedBody>& bodies);
Bytes encode_frame(const Frame& frame);
Bytes encode_end(const Counters& counters);

/// Takes the bytes of a trajectory as they come, in pieces of any size, and calls back for each
/// whole record. The bytes may be hostile: every count is checked before it is believed, every
/// number is finite. Once it has thrown, it takes no more.
class TrajectoryReader {
public:
    struct Handlers {
        std::function<void(const Scene&, const std::vector<RecordedBody>&)> on_start;
        std::function<void(Frame)> on_frame;
        std::function<void(const Counters&)> on_end;
    };
    explicit TrajectoryReader(Handlers handlers);

    /// @throws InputError if the bytes are not a trajectory; names the record and the quantity
    void feed(std::span<const std::byte> bytes);

    bool started() const { return started_; }
    bool complete() const { return complete_; }

private:
    class Cursor;
    using Stage = void (TrajectoryReader::*)(Cursor&);

    void next(Stage stage, std::size_t bytes);
    void read_magic(Cursor& bytes);
    void read_name_size(Cursor& bytes);
    void read_name(Cursor& bytes);
    void read_text(Cursor& bytes);
    void read_bodies(Cursor& bytes);
    void read_tag(Cursor& bytes);
    void read_frame(Cursor& bytes);
    void read_contacts(Cursor& bytes);
    void read_counter_count(Cursor& bytes);
    void read_counters(Cursor& bytes);

    Handlers handlers_;
    std::vector<std::byte> pending_; // not yet enough for the next stage
    Stage stage_;
    std::size_t needed_ = 0; // bytes that it takes
    Scene scene_;
    std::string name_;
    Frame frame_; // the one being read
    std::int64_t last_step_ = -1;
    bool started_ = false, complete_ = false, broken_ = false;
};

/// A trajectory on its way to a file: whole records only, so that it can be read while it is
/// written.
class TrajectoryFile {
public:
    /// @throws InputError if the file cannot be written; so do the others
    explicit TrajectoryFile(const std::filesystem::path& path);
    ~TrajectoryFile();
    TrajectoryFile(const TrajectoryFile&) = delete;
    TrajectoryFile& operator=(const TrajectoryFile&) = delete;

    /// One or more whole records.
    void write(std::span<const std::byte> records);

private:
    std::filesystem::path path_;
    int descriptor_;
};

/// A whole trajectory from a file, or as much of it as is there. @throws InputError
Trajectory load_trajectory(const std::filesystem::path& file);

} // namespace rigor
