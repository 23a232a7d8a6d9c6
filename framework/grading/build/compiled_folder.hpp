// SPDX-License-Identifier: MIT
// The object files of one folder with topics' files. They are compiled behind walls, and kept for
// later runs.
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

/// A file that says from what something else was made. It has a key, which is a hash of the
/// sources, and further lines of text.
class KeyFile {
public:
    explicit KeyFile(std::filesystem::path file) : file_(std::move(file)) {}
    bool holds(std::uint64_t key) const;
    std::vector<std::string> lines() const;
    void write(std::uint64_t key, const std::vector<std::string>& lines) const;
    const std::filesystem::path& file() const { return file_; }

private:
    std::filesystem::path file_;
};

struct CompiledTopic {
    std::filesystem::path object;
    ObjectSymbols symbols;
    std::uint64_t key = 0; // a hash of all that the object was made from
    std::string errors;    // the compiler's first errors; empty if there is an object
};

/// The first errors in what a tool printed, without control characters and without the paths of
/// this machine.
std::string shown_errors(const std::string& output);

class CompiledFolder {
public:
    /// Copies the folder's files into its private folder. As long as this object lives, other
    /// builds of this folder wait.
    /// @throws InputError if it has no topic's file
    CompiledFolder(const std::filesystem::path& folder, const Toolchain& tools);

    /// The private folder for the objects of `folder`: the same in every run.
    static std::filesystem::path place_of(const std::filesystem::path& folder);

    bool has(const std::string& topic) const;

    /// Compiles the files of these topics, if the folder has them and their objects are out of
    /// date.
    /// @param steps  grows by what was compiled
    std::map<std::string, CompiledTopic> compile(const std::vector<std::string>& topics,
                                                 const OnBuildStep& on_step,
                                                 std::vector<std::string>& steps);

    /// SHA-256 of all files that were taken.
    const std::string& digest() const { return files_.digest; }

    /// The private folder, where a worker may be put too.
    const std::filesystem::path& place() const { return place_; }

private:
    CompiledTopic up_to_date(const std::string& topic) const;
    void compile_topic(const std::string& topic, CompiledTopic& compiled) const;
    std::filesystem::path object_of(const std::string& topic) const;
    KeyFile key_of(const std::string& topic) const;

    const Toolchain& tools_;
    std::filesystem::path place_;
    BuildLock lock_;
    SubmissionFiles files_;
    std::uint64_t surroundings_; // hash of the command, the contract and all other sources
};

} // namespace rigor
