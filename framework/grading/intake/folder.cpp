// SPDX-License-Identifier: MIT
// Walks through a folder in the order of the names, so that the first fault that is found is the
// same on every machine. Each source is read as plain_file.hpp says. Files and folders that a
// program made, such as `.git`, are not opened; only their names are listed.
#include "grading/intake/folder.hpp"

#include "errors/quotes.hpp"
#include "grading/intake/plain_file.hpp"
#include "grading/intake/refused.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <sys/stat.h>
#include <utility>
#include <vector>

namespace rigor {

namespace fs = std::filesystem;

namespace {

constexpr int deepest = 32; // levels of folders inside each other

class FolderReader {
public:
    FolderReader(fs::path folder, const IntakeLimits& limits)
        : folder_(std::move(folder)), limits_(limits), contents_(limits)
    {
    }

    Contents read()
    {
        read_below("", 0);
        return std::move(contents_);
    }

    Contents read_one(const fs::path& name, const std::string& called)
    {
        contents_.add_source(contents_.add_name(called), text_of(name));
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
        std::error_code error;
        std::vector<fs::path> names;
        for (fs::directory_iterator entry(folder_ / below, error), end; !error && entry != end;
             entry.increment(error)) {
            names.push_back(below / entry->path().filename());
            // There are too many files, so `Contents::add_name`, called by `take`, will throw.
            if (names.size() > limits_.entries) break;
        }
        if (error) fail(below.empty() ? "." : below, error.value());
        std::sort(names.begin(), names.end());
        for (const fs::path& name : names)
            take(name, depth);
    }

    void take(const fs::path& name, int depth)
    {
        const std::string called = contents_.add_name(name.string());
        struct stat status = {};
        if (lstat((folder_ / name).c_str(), &status) != 0) fail(name, errno);
        if (const std::string_view kind = special_kind(status.st_mode); !kind.empty())
            throw Refused(fmt::format("expected files and folders, found {}, {}", kind,
                                      in_quotes(name.string())));
        const bool is_by_author = !is_by_product(name.string());
        if (is_by_author && S_ISDIR(status.st_mode))
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
            file = read_plain_file(folder_ / name, limits_.source_bytes);
        } catch (const Refused& refused) {
            throw Refused(in_quotes(name.string()) + ": " + refused.what());
        }
        if (file.size > limits_.source_bytes) refuse_too_many_sources(limits_);
        return std::move(file.text);
    }

    fs::path folder_;
    IntakeLimits limits_;
    Contents contents_;
};

} // namespace

Contents read_folder(const fs::path& folder, const IntakeLimits& limits)
{
    return FolderReader(folder, limits).read();
}

Contents read_single_file(const fs::path& file, const std::string& called,
                          const IntakeLimits& limits)
{
    return FolderReader(file.parent_path(), limits).read_one(file.filename(), called);
}

} // namespace rigor
