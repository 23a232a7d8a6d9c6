// SPDX-License-Identifier: MIT
// Copies the topics' files of a submission and then its other sources, and removes what an earlier
// run has left. Each file is opened without following a link and without waiting for a writer, and
// its kind and size are read from the open file, so that nobody can exchange the file between the
// check and the reading.
#include "grading/build/submission_files.hpp"

#include "errors/utf8.hpp"
#include "grading/topics.hpp"
#include "sandbox/descriptor.hpp"
#include "seeds/drawn_seed.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

namespace rigor {

namespace fs = std::filesystem;

namespace {

// No solution comes near this limit: the longest file of the reference has about 10 kB.
constexpr std::size_t longest_file = std::size_t{1} << 20; // [bytes]
constexpr std::size_t most_files = 200;
constexpr int deepest = 4; // levels of subfolders that are searched

// The content of a file, or why there is none.
struct Content {
    std::optional<std::string> text;
    std::string refusal;
};

std::string kind_of(mode_t mode)
{
    return S_ISDIR(mode)    ? "a folder"
           : S_ISFIFO(mode) ? "a pipe"
           : S_ISSOCK(mode) ? "a socket"
           : S_ISLNK(mode)  ? "a link"
                            : "a device";
}

Content read_file(const fs::path& file)
{
    struct stat status = {};
    if (lstat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
        return {{}, "expected a file, found " + kind_of(status.st_mode)};
    const int opened =
        open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (opened < 0) return {{}, std::string("cannot be read: ") + std::strerror(errno)};
    const Descriptor descriptor(opened, "open");
    if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode))
        return {{}, "expected a file, found " + kind_of(status.st_mode)};
    std::string text(longest_file + 1, '\0');
    std::size_t size = 0;
    for (ssize_t n = 1; n > 0 && size < text.size(); size += static_cast<std::size_t>(n)) {
        n = read(descriptor, text.data() + size, text.size() - size);
        if (n < 0) return {{}, std::string("cannot be read: ") + std::strerror(errno)};
    }
    if (size > longest_file)
        return {{},
                fmt::format("expected at most {} kB, found {} kB", longest_file / 1024,
                            std::max<std::size_t>(status.st_size, size) / 1024)};
    text.resize(size);
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) // byte order marks
        return {{}, "expected a text in UTF-8, found UTF-16: save it as UTF-8"};
    return {text, ""};
}

// Whether a file has the ending of a header or a source, so that the file of a topic may include
// it.
bool is_code(const fs::path& file)
{
    static const std::set<std::string> endings = {".hpp", ".h",   ".hh",  ".hxx", ".inl",
                                                  ".ipp", ".inc", ".cpp", ".cc"};
    return endings.count(file.extension().string()) > 0;
}

void write_if_changed(const fs::path& file, const std::string& text)
{
    std::ifstream old(file, std::ios::binary);
    std::stringstream content;
    content << old.rdbuf();
    if (old && content.str() == text) return;
    fs::create_directories(file.parent_path());
    std::ofstream copy(file, std::ios::binary);
    copy << text << std::flush;
    // Writing fails, for example, when the disk is full.
    if (!copy) throw std::runtime_error(file.string() + ": cannot be written");
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
    bool is_full() const { return kept_.size() >= most_files; }
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

// The names of the submission's sources that are no topic's file, sorted.
std::vector<fs::path> other_sources(const fs::path& folder)
{
    const std::vector<std::string> all = topics();
    std::vector<fs::path> found;
    std::error_code error;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator entry(folder, options, error), end;
         !error && entry != end && found.size() < most_files; entry.increment(error)) {
        if (entry.depth() >= deepest) entry.disable_recursion_pending();
        const fs::path name = entry->path().lexically_relative(folder);
        const bool is_topic = !name.has_parent_path() && name.extension() == ".cpp" &&
                              std::find(all.begin(), all.end(), name.stem()) != all.end();
        if (!is_topic && is_code(name) && is_plain_utf8(name.string())) found.push_back(name);
    }
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace

SubmissionFiles take_files(const fs::path& folder, const fs::path& into)
{
    SubmissionFiles files;
    Taken taken(into);
    for (const std::string& topic : topics()) {
        const fs::path name = topic + ".cpp";
        std::error_code error;
        if (fs::symlink_status(folder / name, error).type() == fs::file_type::not_found) continue;
        const Content content = read_file(folder / name);
        if (content.text) {
            taken.add(name, *content.text);
            files.topics.push_back(topic);
        } else {
            files.refused[topic] = name.string() + ": " + content.refusal + "\n";
        }
    }
    for (const fs::path& name : other_sources(folder)) {
        const Content content = read_file(folder / name);
        if (!content.text || taken.is_full()) continue;
        taken.add(name, *content.text);
        files.hash = hash_of(name.string() + '\0' + *content.text, files.hash);
    }
    taken.remove_others();
    files.digest = taken.digest();
    return files;
}

} // namespace rigor
