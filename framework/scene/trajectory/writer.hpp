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

} // namespace rigor
