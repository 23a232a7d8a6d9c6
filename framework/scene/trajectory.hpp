// SPDX-License-Identifier: MIT
// The recorded motion of a scene: written by a worker, streamed, stored, read while it is being
// written.
//
// Little-endian binary:
//     "RIGORTRJ"  u32 version = 1
//     u32 bytes, scene file as text
//     u32 bodies, each: u8 is_static, f64 mass, 3 f64 center of mass, 9 f64 inertia (I_body by
//     columns) then records until the end: 'F'  i64 step, f64 time, bodies × 13 f64 (X, q = s x y
//     z, V, L),
//          u32 contacts, each: i32 body1, i32 body2, f64 depth, 9 f64 (point, normal, impulse)
//     'E'  u32 counters, each u64 in the order of Counters: the run is complete
// A file that stops before 'E' holds the run up to there.
#pragma once

#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
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

/// Which moments a run records.
enum class Record { frames, every_step };

/// Runs a scene and hands the bytes of its trajectory to `write`, a record at a time.
void run_scene(const Scene& scene, Record record,
               const std::function<void(std::span<const std::byte>)>& write);

/// Takes the bytes of a trajectory as they come, in pieces of any size, and calls back for each
/// whole record. The bytes may be hostile: every count is checked before it is believed, every
/// number is finite.
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

    bool complete() const { return complete_; }

private:
    Handlers handlers_;
    std::vector<std::byte> pending_;
    std::size_t body_count_ = 0;
    bool started_ = false, complete_ = false;
};

/// A whole trajectory from a file. @throws InputError
Trajectory load_trajectory(const std::filesystem::path& file);

} // namespace rigor
