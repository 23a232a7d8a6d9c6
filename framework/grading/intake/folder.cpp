// SPDX-License-Identifier: MIT
// Walks through a folder in the order of the names, so that the first fault that is found is the
// same on every machine. Each folder is opened as beneath.hpp says and each source is read as
// plain_file.hpp says. Files and folders that a program made, such as `.git`, are not opened; only
// their names are listed.
#include "grading/intake/folder.hpp"

#include "errors/quotes.hpp"
#include "grading/intake/beneath.hpp"
#include "grading/intake/plain_file.hpp"
#include "grading/intake/refused.hpp"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <sys/stat.h>
#include <system_error>
#include <utility>
#include <vector>

namespace rigor {

namespace fs = std::filesystem;

namespace {

constexpr int deepest = 32; // levels of folders inside each other

class FolderReader {
public:
    // The folder `within` lies in `around`, which students cannot change.
    FolderReader(fs::path around, fs::path within, const IntakeLimits& limits)
        : around_(std::move(around)), within_(std::move(within)), limits_(limits), contents_(limits)
    {
    }

    Contents read()
    {
        read_below("", 0);
        return std::move(contents_);
    }

    Contents read_one(const std::string& called)
    {
        contents_.add_source(contents_.add_name(called), text_of(""));
        return std::move(contents_);
    }

private:
    [[noreturn]] static void fail(const fs::path& name, int error)
    {
        throw Refused(in_quotes(name.string()) + " cannot be read: " + std::strerror(error));
    }

    void read_below(const fs::path& below, int depth)
    {
        if (depth > deepest)
            throw Refused(
                fmt::format("expected at most {} folders inside each other, found more", deepest));
        std::vector<FolderEntry> entries;
        try {
            entries = entries_beneath(around_, path_of(below), limits_.entries);
        } catch (const std::system_error& error) {
            fail(below.empty() ? "." : below, error.code().value());
        }
        // If there are too many files, `Contents::add_name`, called by `take`, throws.
        for (const FolderEntry& entry : entries)
            take(below / entry.name, entry.mode, depth);
    }

    void take(const fs::path& name, mode_t mode, int depth)
    {
        const std::string called = contents_.add_name(name.string());
        if (mode == 0) fail(name, ENOENT);
        if (const std::string_view kind = special_kind(mode); !kind.empty())
            throw Refused(fmt::format("expected files and folders, found {}, {}", kind,
                                      in_quotes(name.string())));
        const bool is_by_author = !is_by_product(name.string());
        if (is_by_author && S_ISDIR(mode))
            read_below(name, depth + 1);
        else if (is_by_author && is_source(name.string()))
            contents_.add_source(called, text_of(name));
        else
            contents_.add_other(called);
    }

    std::string text_of(const fs::path& name) const
    {
        PlainFile file;
        try {
            file = read_plain_file(around_, path_of(name), limits_.source_bytes);
        } catch (const Refused& refused) {
            throw Refused(in_quotes((name.empty() ? within_ : name).string()) + ": " +
                          refused.what());
        }
        if (file.size > limits_.source_bytes) refuse_too_many_sources(limits_);
        return std::move(file.text);
    }

    // The path of a file of the folder, relative to `around_`.
    fs::path path_of(const fs::path& name) const { return name.empty() ? within_ : within_ / name; }

    fs::path around_, within_;
    IntakeLimits limits_;
    Contents contents_;
};

} // namespace

Contents read_folder(const fs::path& folder, const IntakeLimits& limits)
{
    return FolderReader(folder.parent_path(), folder.filename(), limits).read();
}

Contents read_single_file(const fs::path& file, const std::string& called,
                          const IntakeLimits& limits)
{
    return FolderReader(file.parent_path(), file.filename(), limits).read_one(called);
}

} // namespace rigor
