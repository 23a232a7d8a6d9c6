// SPDX-License-Identifier: MIT
// The names that the objects of a submission define for each other and for the worker.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace rigor {

/// The names of one object, as the linker sees them.
struct ObjectSymbols {
    std::set<std::string> defined;   // defined here, and visible to other objects
    std::set<std::string> undefined; // used but not defined
    /// Weak names that any object may define, and which a linker takes from one of them: those of
    /// inline functions and templates. In two topics they may differ.
    std::vector<std::string> shared;
};

/// Parses what `nm -P` prints about one object.
ObjectSymbols parse_symbols(const std::string& listing);

/// The first line of a listing of `nm -P` whose name has a space or a control character, which a
/// compiler may take from an `asm` label; empty if there is none. No compiler makes such a name by
/// itself.
std::string line_with_unreadable_name(const std::string& listing);

/// For each topic's object, the names that are made local to it. These are all names that it
/// defines, except for formulas and for names that another object uses. So two files may have
/// helpers of the same name, and a `main` that a student wrote to try something out does no harm.
/// If two objects define the same formula, the definition in the file of its topic counts.
/// @param reserved  names of the worker and of its libraries, such as `memcpy`: an object's own
///     definition of such a name is hidden from all other objects
std::map<std::string, std::vector<std::string>>
names_to_hide(const std::map<std::string, ObjectSymbols>& objects,
              const std::set<std::string>& reserved = {});

} // namespace rigor
