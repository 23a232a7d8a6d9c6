// SPDX-License-Identifier: MIT
// The motion of a scene as a table, for plots and spreadsheets.
#pragma once

#include "scene/trajectory/statistics.hpp"

#include <string>

namespace rigor {

/// The first line of the table (CSV, RFC 4180): the names of its columns. These are the time, the
/// name of the body or solid, its center of mass X, its orientation q, and V, ω and L. All vectors
/// are in world space and in SI units; L is about the center of mass.
std::string states_header();

/// A line for each body and each deformable solid of a frame, in the order of the scene. A solid
/// has no orientation and no angular velocity. A number is the shortest text from which the same
/// double is read.
std::string states_lines(const Scene& scene, const Statistics& statistics, const Frame& frame);

} // namespace rigor
