// SPDX-License-Identifier: MIT
// Archives are read by a separate program, `unpack`, behind walls, that is, in a sandbox. It gets
// the archive as its stdin and prints the content. If the library that reads archives crashes, only
// this program ends.
#pragma once

#include "grading/intake/contents.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// What `unpack` prints for these contents, or for the reason why they are refused.
std::string printed(const Contents& contents);
std::string printed_refusal(std::string_view reason);

/// Reads contents from what `unpack` has printed. Every name and size is checked again.
/// @throws Refused with the printed reason, or because the text does not have the form that
///     `unpack` prints
Contents read_printed(std::string_view text, const IntakeLimits& limits);

/// Converts limits to arguments of `unpack`, and back.
std::vector<std::string> arguments_of(const IntakeLimits& limits);
IntakeLimits limits_of(const std::vector<std::string>& arguments);

/// Reads a whole archive, `name` in `folder`, by `unpack`. It is opened as `opened_beneath` says.
/// @throws Refused as `read_archive`, and also if the program crashes or takes too long;
///     std::system_error if the sandbox cannot be set up
Contents read_archive_behind_walls(const std::filesystem::path& folder,
                                   const std::filesystem::path& name,
                                   const IntakeLimits& limits = {});

} // namespace rigor
