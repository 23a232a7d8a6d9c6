// SPDX-License-Identifier: MIT
// Copies the topics' files of a submission and then its other sources, and removes what an earlier
// run has left. Each folder is listed as beneath.hpp says. Each file is read as plain_file.hpp
// says.
#include "grading/build/submission_files.hpp"

#include "errors/utf8.hpp"
#include "grading/build/write_file.hpp"
#include "grading/intake/beneath.hpp"
#include "grading/intake/plain_file.hpp"
#include "grading/intake/refused.hpp"
#include "grading/places.hpp"
#include "grading/topics.hpp"
#include "seeds/drawn_seed.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <sys/stat.h>
#include <system_error>

namespace rigor {

namespace fs = std::filesystem;

namespace {

// No solution comes near this limit: the longest file of the reference has about 10 kB.
constexpr std::size_t longest_file = std::size_t{1} << 20; // [bytes]
constexpr std::size_t most_files = 200;                    // besides the topics' files
constexpr int deepest = 4;                      // levels of subfolders that files are taken from
constexpr int deepest_look = 8;                 // levels of subfolders that are searched
constexpr std::size_t most_entries = 1'000'000; // of a folder that is searched

// The content of a file, or why there is none.
struct Content {
    std::optional<std::string> text;
    std::string refusal;
};

Content read_file(const fs::path& folder, const fs::path& name)
{
    try {
        const PlainFile read = read_plain_file(folder, name, longest_file);
        if (read.size > longest_file)
            return {{},
                    fmt::format("expected at most {} kB, found {} kB", longest_file / 1024,
                                read.size / 1024)};
        if (read.text.starts_with("\xFF\xFE") || read.text.starts_with("\xFE\xFF"))
            return {{}, "expected a text in UTF-8, found UTF-16: save it as UTF-8"};
        return {read.text, ""};
    } catch (const Refused& refused) {
        return {{}, refused.what()};
    }
}

void write_if_changed(const fs::path& file, const std::string& text)
{
    std::ifstream old(file, std::ios::binary);
    std::stringstream content;
    content << old.rdbuf();
    if (old && content.str() == text) return;
    fs::create_directories(file.parent_path());
    write_file(file, text);
}

// Writes the files of a submission to the folder `into`. `remove_others` removes what an earlier
// run has left there.
class Taken {
public:
    explicit Taken(fs::path into) : into_(std::move(into)) { fs::create_directories(into_); }

    void add(const fs::path& name, const std::string& text)
    {
        write_if_changed(into_ / name, text);
        digests_ += sha256(name.string()) + sha256(text);
        for (fs::path part = name; !part.empty(); part = part.parent_path())
            kept_.insert(part);
    }
    std::string digest() const { return sha256(digests_); }

    void remove_others() const
    {
        std::vector<fs::path> others;
        for (const auto& entry : fs::recursive_directory_iterator(into_))
            if (kept_.count(entry.path().lexically_relative(into_)) == 0)
                others.push_back(entry.path());
        for (const fs::path& other : others)
            fs::remove_all(other);
    }

private:
    fs::path into_;
    std::set<fs::path> kept_;
    std::string digests_; // the SHA-256 of each name and text; all have the same length
};

bool is_file_of_topic(const fs::path& name)
{
    const std::vector<std::string> all = topics();
    return !name.has_parent_path() && name.extension() == ".cpp" &&
           std::find(all.begin(), all.end(), name.stem()) != all.end();
}

// Appends the names of the sources in the folder `below`, which is relative to `folder`, and in
// its subfolders. A subfolder that cannot be read has none.
void find_sources(const fs::path& folder, const fs::path& below, int depth,
                  std::vector<fs::path>& found)
{
    std::vector<FolderEntry> entries;
    try {
        entries = entries_beneath(folder, below, most_entries);
    } catch (const std::system_error&) {
        return;
    }
    for (const FolderEntry& entry : entries) {
        const fs::path name = below / entry.name;
        if (S_ISDIR(entry.mode) && depth < deepest_look)
            find_sources(folder, name, depth + 1, found);
        if (!S_ISDIR(entry.mode) && is_code(name)) found.push_back(name);
    }
}

// The names of the submission's sources that are no topic's file and no header of the framework,
// sorted. They are all of them, since a folder lists its files in any order.
std::vector<fs::path> other_sources(const fs::path& folder)
{
    std::vector<fs::path> found;
    find_sources(folder, "", 0, found);
    std::erase_if(found, [](const fs::path& name) {
        // an older or a changed header of the framework, which would be found before its own
        const bool is_framework = fs::exists(places().source / "framework" / name);
        return is_framework || is_file_of_topic(name) || !is_plain_utf8(name.string());
    });
    std::sort(found.begin(), found.end());
    return found;
}

// The content of a source that is no topic's file, or why it is not taken after `taken` others.
Content content_of_other(const fs::path& folder, const fs::path& name, std::size_t taken)
{
    if (std::distance(name.begin(), name.end()) - 1 > deepest)
        return {{}, fmt::format("expected at most {} folders around it", deepest)};
    if (taken >= most_files)
        return {{}, fmt::format("expected at most {} headers and other sources", most_files)};
    return read_file(folder, name);
}

} // namespace

bool is_code(const fs::path& file)
{
    static const std::set<std::string> endings = {".hpp", ".h",   ".hh",  ".hxx", ".inl",
                                                  ".ipp", ".inc", ".cpp", ".cc"};
    return endings.count(file.extension().string()) > 0;
}

SubmissionFiles take_files(const fs::path& folder, const fs::path& into)
{
    SubmissionFiles files;
    Taken taken(into);
    for (const std::string& topic : topics()) {
        const fs::path name = topic + ".cpp";
        std::error_code error;
        if (fs::symlink_status(folder / name, error).type() == fs::file_type::not_found) continue;
        const Content content = read_file(folder, name);
        if (content.text) {
            taken.add(name, *content.text);
            files.topics.push_back(topic);
            files.hash = hash_of(name.string() + '\0', files.hash);
        } else {
            files.refused[topic] = name.string() + ": " + content.refusal + "\n";
        }
    }
    std::size_t others = 0;
    for (const fs::path& name : other_sources(folder)) {
        const Content content = content_of_other(folder, name, others);
        if (!content.text) {
            files.left_out.push_back(name.string() + ": " + content.refusal);
            continue;
        }
        ++others;
        taken.add(name, *content.text);
        files.hash = hash_of(name.string() + '\0' + *content.text, files.hash);
    }
    taken.remove_others();
    files.digest = taken.digest();
    return files;
}

} // namespace rigor
