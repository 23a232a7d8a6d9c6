// SPDX-License-Identifier: MIT
// The commands that make a worker, the program that runs formulas, from the students' files. They
// are run behind walls, that is, in a sandbox.
#pragma once

#include "grading/build/ninja.hpp"
#include "sandbox/run_confined.hpp"

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace rigor {

/// How the build of student/ compiles a topic's file and links a worker: words of command lines.
struct Toolchain {
    std::vector<std::string> compile;       // the compiler's command, without input and output file
    std::vector<std::string> link;          // the linker's command, without objects of the topics
    std::vector<std::string> linked_inputs; // those in `link`, relative to the build folder
    std::filesystem::path precompiled;      // the folder of the precompiled headers
    /// Linker names that the framework's part of a worker defines, or takes from libraries.
    std::set<std::string> reserved = {};
};

/// The compiler for students' files that the environment variable RIGOR_COMPILER names by its path;
/// empty for the compiler of the main build. @throws InputError if the variable names no program
std::string chosen_compiler();

/// The header that the compiler includes before each file of a submission, after the precompiled
/// header.
std::filesystem::path no_file_queries();

/// The toolchain for student/, taken from ninja's commands, with the chosen compiler.
Toolchain student_toolchain();

/// The limit on the size of the object of one file [bytes]. The objects of the reference have less
/// than 100 kB.
inline constexpr std::uint64_t largest_output = std::uint64_t{16} << 20;

/// The limit on the processor time of a linker, which needs a hundredth of it [s].
inline constexpr double link_limit = 5;

/// A tool that is run for a submission, such as a compiler or linker. It may read `folder`,
/// `readable` and the files of the system, and write in `out` only.
struct ToolRun {
    std::vector<std::string> arguments;
    std::filesystem::path folder; // its working directory
    std::vector<std::filesystem::path> readable;
    std::filesystem::path out;
    std::uint64_t largest_file = largest_output; // the largest file that it may write [bytes]
    double time = compile_limit;                 // processor time [s]
};

/// Runs a tool. If it runs as another user, its paths become readable for everybody before,
/// whatever the umask was when they were made.
/// @throws std::system_error if it cannot be started in the sandbox, std::runtime_error if the
///     system ended it, for example because memory ran out, or if it failed where the disk is full
ConfinedRun run_tool(const ToolRun& tool);

/// Copies an object to `copy`, whose folder is the tools' own, and makes these names local in it.
ConfinedRun make_local(const std::filesystem::path& object, const std::vector<std::string>& names,
                       const std::filesystem::path& copy);

/// Why a worker does not reach its main function; empty if it does. Global objects are constructed
/// before main, and a constructor in a student's file may fail.
std::string why_it_does_not_start(const std::filesystem::path& worker);

/// Whether there is a regular file, and no link, at this path. Where a tool should have left a
/// file, a submission may have put a link to a file of the grader, or a pipe that keeps its reader
/// waiting.
bool is_plain_file(const std::filesystem::path& path);

/// Copies a file that a tool made to `place`, and removes the original. The tool may still have the
/// original open, but it cannot write to the copy. At any time there is the old file or the whole
/// new one at `place`; other names (hard links) of the old file keep the old content.
void take_over(const std::filesystem::path& made, const std::filesystem::path& place);

} // namespace rigor
