// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rigor {

/// The name of a submission or student, as lists for the instructor show it. It is in quotes if it
/// could be taken for several names, or for a name with a remark, because it has a comma, a colon,
/// a bracket or a quote in it, or blanks other than single spaces between words.
std::string listed_name(const std::string& name);

} // namespace rigor
