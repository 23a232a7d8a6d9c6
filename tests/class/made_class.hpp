// SPDX-License-Identifier: MIT
// A class of submissions for one topic, drawn by a seed from what the tests have: right solutions,
// plausible mistakes, slips and attacks.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor::testing {

/// What one member of the class hands in.
struct ClassMember {
    std::string name; // "s0007"
    std::string kind; // "right", "mistake", "slip", "attack", "stub" or "nothing"
    std::string text; // the topic's file; empty for "nothing", which has another file
};

/// Draws a class. Half of it made a mistake, a quarter is right; no two texts are equal.
/// @param source  the tree with reference/, student/ and tests/
std::vector<ClassMember> made_class(const std::filesystem::path& source, const std::string& topic,
                                    int count, unsigned seed);

/// A class in which no member handed in the topic's file: what grading costs without a compiler.
std::vector<ClassMember> empty_class(int count);

/// Writes each submission to a folder of its own.
void write_class(const std::vector<ClassMember>& members, const std::string& topic,
                 const std::filesystem::path& folder);

/// The text in which `to` takes the place of the name `name`, except for members of that name.
std::string renamed(const std::string& text, const std::string& name, const std::string& to);

/// The text with other definitions of some formulas. The text's own ones get the prefix `right_`,
/// and keep calling each other.
std::string with_other_formulas(const std::string& text, const std::string& topic,
                                const std::vector<std::string>& names,
                                const std::string& definitions);

} // namespace rigor::testing
