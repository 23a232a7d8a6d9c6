// SPDX-License-Identifier: MIT
#pragma once

#include "scene/trajectory/trajectory.hpp"

#include <functional>
#include <span>

namespace rigor {

using Bytes = std::vector<std::byte>;
using ByteSink = std::function<void(std::span<const std::byte>)>;

/// The records of a trajectory as bytes.
Bytes encode_start(const Scene& scene, const std::vector<RecordedBody>& bodies);
Bytes encode_frame(const Frame& frame);
Bytes encode_end(const Counters& counters);

} // namespace rigor
