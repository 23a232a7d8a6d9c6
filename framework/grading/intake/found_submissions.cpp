// SPDX-License-Identifier: MIT
#include "grading/intake/found_submissions.hpp"

#include "errors/input_error.hpp"
#include "errors/quotes.hpp"
#include "errors/utf8.hpp"
#include "grading/intake/archive.hpp"
#include "grading/intake/contents.hpp"
#include "grading/intake/downloaded_name.hpp"
#include "grading/intake/intake.hpp"
#include "grading/intake/listing.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <utility>

namespace rigor {

namespace fs = std::filesystem;

namespace {

// Whether a folder that is the only path of the command is a folder of submissions.
bool is_class(const fs::path& folder, const Listing& listing, const std::string& wanted)
{
    return !holds(folder, wanted) &&
           !(listing.archives.empty() && listing.downloaded.empty() && listing.folders.empty());
}

// Whether one of several paths looks like a folder of submissions. A single archive or a single
// folder with the wanted file may be all that a student has handed in.
bool looks_like_class(const fs::path& path, const Listing& listing, const std::string& wanted)
{
    if (!fs::is_directory(path) || listing.error || holds(path, wanted)) return false;
    const auto near =
        std::count_if(listing.folders.begin(), listing.folders.end(),
                      [&](const fs::path& folder) { return has_wanted_near(folder, wanted); });
    return !listing.downloaded.empty() ||
           listing.archives.size() + static_cast<std::size_t>(near) > 1;
}

bool is_link(const fs::path& path)
{
    std::error_code error;
    return fs::is_symlink(fs::symlink_status(path, error));
}

// An absolute path without links, except that the last part may be one.
// @throws InputError if there is nothing of this name
fs::path named_path(const std::string& text)
{
    std::error_code error;
    fs::path path = fs::absolute(text, error);
    if (!path.has_filename()) path = path.parent_path(); // "alice/"
    path = is_link(path) ? fs::canonical(path.parent_path(), error) / path.filename()
                         : fs::canonical(path, error);
    if (error)
        throw InputError("expected a folder or an archive, found no file " + in_quotes(text));
    return path;
}

class Search {
public:
    Search(std::string wanted, std::set<std::string> reserved)
        : wanted_(std::move(wanted)), reserved_(std::move(reserved))
    {
    }

    // The user may name a link, which is followed if it is the only path.
    void add_only_path(const fs::path& named)
    {
        std::error_code error;
        const fs::path path = fs::canonical(named, error);
        if (error)
            throw InputError("expected a folder or an archive, found a link to nothing, " +
                             in_quotes(named.filename().string()));
        if (!fs::is_directory(path)) return add(path);
        const Listing listing = listing_of(path);
        if (listing.error)
            throw InputError(path.string() + ": cannot be read: " + listing.error.message());
        if (listing.is_empty()) return; // no submission: `result` throws
        require_one_or_many(path, listing);
        if (is_class(path, listing, wanted_))
            add_class(path, listing);
        else
            add(path);
    }

    // Adds either what lies in each of several folders, or each path as one submission. The paths
    // may be the entries of a class, `class/*`. In these, a student's folder must not count as
    // several submissions, whose names could be those of others.
    void add_paths(const std::set<fs::path>& paths)
    {
        std::map<fs::path, Listing> classes;
        fs::path one; // a path that is a submission
        for (const fs::path& path : paths) {
            Listing listing = is_link(path) ? Listing() : listing_of(path);
            if (!is_link(path) && looks_like_class(path, listing, wanted_))
                classes.emplace(path, std::move(listing));
            else
                one = path;
        }
        if (one.empty()) {
            for (const auto& [path, listing] : classes)
                add_class(path, listing);
            return;
        }
        for (const fs::path& path : paths)
            add(path, is_link(path) ? "expected a folder or an archive, found a link" : "");
        for (const auto& [path, listing] : classes)
            notes_.push_back(fmt::format(
                "{} looks like a folder of submissions and counts as one, since {} beside it is "
                "one: name either submissions or folders of them",
                in_quotes(path.filename().string()), in_quotes(one.filename().string())));
    }

    FoundSubmissions result() const
    {
        FoundSubmissions found;
        found.notes = notes_;
        add_notes_about_several(found.notes);
        for (const auto& [name, same_name] : found_) {
            Submission submission = same_name.front();
            std::vector<std::string> names;
            for (const Submission& other : same_name)
                names.push_back(other.path.filename().string());
            if (same_name.size() > 1)
                submission.refusal =
                    fmt::format("expected one submission of this name, found {}: {}",
                                same_name.size(), first_names(names));
            found.submissions.push_back(submission);
        }
        if (found.submissions.empty())
            throw InputError("expected submissions, found none: each is a folder or an archive "
                             "with " +
                             wanted_);
        return found;
    }

private:
    void add_class(const fs::path& path, const Listing& listing)
    {
        for (const fs::path& folder : listing.folders)
            add(folder);
        for (const fs::path& archive : listing.archives)
            add(archive);
        for (const fs::path& link : listing.links)
            add(link, "expected a folder or an archive, found a link");
        add_downloaded(listing);
        note_passed_over(path, listing.others, "expected folders and archives");
        note_passed_over(path, listing.dotted,
                         "a name that begins with a dot is that of a program's own folder");
    }

    // A folder with the wanted file is a single submission. @throws InputError if such a folder
    // also looks like that of a whole class: if it has a submission from Canvas or Moodle, or at
    // least two other submissions. A single other submission may be a backup of the student.
    void require_one_or_many(const fs::path& path, const Listing& listing) const
    {
        if (!holds(path, wanted_)) return;
        std::vector<std::string> beside;
        bool is_download = false;
        const auto note = [&](const fs::path& other) {
            beside.push_back(other.filename().string());
            is_download = is_download || downloaded_name(beside.back());
        };
        std::for_each(listing.archives.begin(), listing.archives.end(), note);
        std::for_each(listing.downloaded.begin(), listing.downloaded.end(), note);
        for (const fs::path& folder : listing.folders)
            if (has_wanted_near(folder, wanted_) || downloaded_name(folder.filename().string()))
                note(folder);
        std::sort(beside.begin(), beside.end());
        if (beside.size() > 1 || is_download)
            throw InputError(fmt::format(
                "{}: expected one submission or a folder of many, found {} beside {}: move this "
                "file into a folder of its own",
                path.string(), wanted_, first_names(beside)));
    }

    void add(const fs::path& path, const std::string& refusal = {})
    {
        if (!paths_.insert(path).second) return; // this path was added before
        const std::string file = path.filename().string();
        std::error_code error;
        Submission submission = {fs::is_directory(fs::symlink_status(path, error)) ? file
                                 : is_source(file) ? path.stem().string()
                                                   : without_archive_ending(file),
                                 path, refusal};
        if (file.empty()) throw InputError("expected a folder with a name, found " + path.string());
        const fs::file_type type = fs::symlink_status(path, error).type();
        if (refusal.empty() && type != fs::file_type::directory && type != fs::file_type::regular)
            submission.refusal = "expected a folder or an archive, found neither";
        if (!is_plain_utf8(file)) {
            submission.refusal =
                "expected a name in UTF-8 without control characters and without invisible ones, "
                "found " +
                in_quotes(file);
            submission.name = escaped(submission.name);
        }
        if (reserved_.count(submission.name)) {
            submission.refusal = "expected another name, since the results have a file " +
                                 in_quotes(submission.name);
            submission.name += "_";
        }
        found_[submission.name].push_back(submission);
    }

    // Adds the students who handed in a file without an archive. If the file has another name than
    // the wanted one and the student has no other submission, a refused submission is added, so
    // that no student is missing in the results.
    void add_downloaded(const Listing& listing)
    {
        std::set<std::string> students;
        const auto note_student = [&](const fs::path& path) {
            if (const auto name = downloaded_name(path.filename().string()))
                students.insert(name->student());
        };
        for (const auto* paths : {&listing.folders, &listing.archives})
            std::for_each(paths->begin(), paths->end(), note_student);
        std::vector<fs::path> others;
        for (const fs::path& path : listing.downloaded) {
            if (!is_called(downloaded_name(path.filename().string())->file, wanted_)) {
                others.push_back(path);
                continue;
            }
            add(path);
            note_student(path);
        }
        for (const fs::path& path : others) {
            const DownloadedName name = *downloaded_name(path.filename().string());
            if (students.insert(name.student()).second)
                add(path, "expected " + wanted_ + " or an archive with it, found " +
                              (name.is_online_text ? "a typed text" : in_quotes(name.file)));
            else
                note_passed_over(path.parent_path(), {path}, "the student has another submission");
        }
    }

    // Adds a note for each student with several submissions, and for each submission that may be a
    // copy of another, since only the instructor knows which one counts.
    void add_notes_about_several(std::vector<std::string>& notes) const
    {
        // The files by system and number, as the platforms find a student, and by the first name
        // that was found with this number.
        std::map<std::pair<LearningSystem, std::string>, std::string> students;
        std::map<std::string, std::vector<std::string>> files;
        for (const auto& [submission, same_name] : found_)
            for (const Submission& one : same_name) {
                const std::string file = one.path.filename().string();
                if (const auto name = downloaded_name(file))
                    files[students.try_emplace({name->system, name->number}, name->student())
                              .first->second]
                        .push_back(file);
            }
        for (const auto& [submission, same_name] : found_)
            if (const std::string original = without_number(submission); found_.count(original) > 0)
                notes.push_back(fmt::format("{} may be a copy of {}: both are graded",
                                            in_quotes(submission), in_quotes(original)));
        for (const auto& [student, names] : files)
            if (names.size() > 1)
                notes.push_back(fmt::format(
                    "{} has {} submissions: {}: if several get a grade, canvas.csv and moodle.csv "
                    "have none of them",
                    in_quotes(student), names.size(), first_names(names)));
    }

    // The original name if a browser or a file manager has added a number: "kim" for "kim (1)".
    // The result is empty for any other name.
    static std::string without_number(const std::string& name)
    {
        const std::size_t open = name.rfind(" (");
        const bool has_number = open != std::string::npos && name.size() > open + 3 &&
                                name.ends_with(')') &&
                                name.find_first_not_of("0123456789", open + 2) == name.size() - 1;
        return has_number ? name.substr(0, open) : "";
    }

    // Turns a name that cannot be shown into printable ASCII, which can also name a folder.
    static std::string escaped(const std::string& name)
    {
        constexpr std::size_t longest = 200; // [bytes]; file systems allow 255
        std::string text;
        for (const unsigned char c : name.substr(0, longest / 4))
            text += c >= ' ' && c <= '~' ? std::string(1, static_cast<char>(c))
                                         : fmt::format("\\x{:02x}", c);
        return text;
    }

    void note_passed_over(const fs::path& folder, const std::vector<fs::path>& others,
                          const std::string& why)
    {
        std::vector<std::string> names;
        names.reserve(others.size());
        for (const fs::path& other : others)
            names.push_back(other.filename().string());
        std::sort(names.begin(), names.end());
        if (!names.empty())
            notes_.push_back(fmt::format("{}: passed over {}: {}",
                                         in_quotes(folder.filename().string()), first_names(names),
                                         why));
    }

    std::string wanted_;
    std::set<std::string> reserved_;
    std::set<fs::path> paths_;
    std::map<std::string, std::vector<Submission>> found_;
    std::vector<std::string> notes_;
};

} // namespace

FoundSubmissions find_submissions(const std::vector<std::string>& paths, const std::string& wanted,
                                  const std::set<std::string>& reserved)
{
    std::set<fs::path> named;
    for (const std::string& path : paths)
        named.insert(named_path(path));
    Search search(wanted, reserved);
    if (named.size() == 1)
        search.add_only_path(*named.begin());
    else
        search.add_paths(named);
    return search.result();
}

} // namespace rigor
