// SPDX-License-Identifier: MIT
// The object files of one folder of sources, such as inertia.cpp, one for each topic. They are
// compiled behind walls, that is, in a sandbox, and kept for later runs.
#pragma once

#include "grading/build/ninja.hpp"
#include "grading/build/object_symbols.hpp"
#include "grading/build/submission_files.hpp"
#include "grading/build/toolchain.hpp"
#include "grading/places.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rigor {

/// A file beside a built file that tells whether the built file is up to date. Its first line is a
/// key: a hash of everything that the built file was made from. Further lines of text follow.
class KeyFile {
public:
    explicit KeyFile(std::filesystem::path file) : file_(std::move(file)) {}
    bool holds(std::uint64_t key) const;
    std::vector<std::string> lines() const;
    /// Replaces the file at once, so a key that holds is followed by all of its lines.
    /// @throws std::runtime_error or std::filesystem::filesystem_error if it cannot be written
    void write(std::uint64_t key, const std::vector<std::string>& lines) const;
    const std::filesystem::path& file() const { return file_; }

private:
    std::filesystem::path file_;
};

struct CompiledTopic {
    std::filesystem::path object;
    ObjectSymbols symbols;
    std::uint64_t key = 0; // a hash of everything that the object was made from
    std::string errors;    // the compiler's first errors; empty if there is an object
};

class CompiledFolder {
public:
    /// Copies the files of `folder` into a private folder. As long as this object lives, other
    /// builds of `folder` wait.
    /// @throws InputError if `folder` has no file of any topic
    CompiledFolder(const std::filesystem::path& folder, const Toolchain& tools);

    /// The private folder for the objects of `folder`: the same in every run.
    static std::filesystem::path place_of(const std::filesystem::path& folder);

    bool has(const std::string& topic) const;

    /// Compiles the files of these topics, if the folder has them and their objects are out of
    /// date.
    /// @param steps  gets a line for each file that was compiled
    /// @return for each topic that the folder has, its object or why there is none
    /// @throws std::runtime_error if a file does not compile and `require_untouched` throws
    std::map<std::string, CompiledTopic> compile(const std::vector<std::string>& topics,
                                                 const OnBuildStep& on_step,
                                                 std::vector<std::string>& steps);

    /// Errors of a compiler or linker say nothing about the submission if somebody has removed or
    /// changed the files that it read. @throws std::runtime_error in this case
    void require_untouched() const;

    /// SHA-256 of all files that were copied, with their names.
    const std::string& digest() const { return files_.digest; }

    /// The headers and other sources that were not copied, each with the reason.
    const std::vector<std::string>& left_out() const { return files_.left_out; }

    /// The private folder. The linked worker, the program that runs the formulas, is put there too.
    const std::filesystem::path& place() const { return place_; }

private:
    std::uint64_t hash_of_inputs() const;
    CompiledTopic up_to_date(const std::string& topic) const;
    void compile_topic(const std::string& topic, CompiledTopic& compiled) const;
    std::filesystem::path object_of(const std::string& topic) const;
    KeyFile key_of(const std::string& topic) const;
    std::uint64_t key_with_others(std::uint64_t key) const;
    std::vector<std::string> files_beside(const std::string& topic) const;

    const Toolchain& tools_;
    std::filesystem::path place_;
    BuildLock lock_;
    SubmissionFiles files_;
    // A hash of what every object depends on: the compiler's command, the headers of
    // framework/formulas, no_file_queries.hpp, the precompiled header, the copied files that are no
    // topic's file, and which topics' files there are.
    std::uint64_t surroundings_;
    // A hash of all files that a compiler may read here: the copied files, and those of the
    // framework.
    std::uint64_t inputs_;
};

} // namespace rigor
