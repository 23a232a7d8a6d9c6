// SPDX-License-Identifier: MIT
#pragma once

#include "scene/trajectory/trajectory.hpp"

#include <filesystem>
#include <functional>
#include <span>

namespace rigor {

using Bytes = std::vector<std::byte>;
using ByteSink = std::function<void(std::span<const std::byte>)>;

/// The records of a trajectory as bytes.
Bytes encode_start(const Scene& scene, const std::vector<RecordedBody>& bodies);
Bytes encode_frame(const Frame& frame);
Bytes encode_end(const Counters& counters);

/// The file that a trajectory is written to. Only whole records are written, so that the file can
/// be read at the same time.
class TrajectoryFile {
public:
    /// @throws InputError if the file cannot be written; `write` throws it too
    explicit TrajectoryFile(const std::filesystem::path& path);
    ~TrajectoryFile();
    TrajectoryFile(const TrajectoryFile&) = delete;
    TrajectoryFile& operator=(const TrajectoryFile&) = delete;

    /// Writes one or more whole records.
    void write(std::span<const std::byte> records);

private:
    std::filesystem::path path_;
    int descriptor_;
};

} // namespace rigor
