// SPDX-License-Identifier: MIT
#include "grading/intake/listing.hpp"

#include "grading/intake/archive.hpp"
#include "grading/intake/contents.hpp"
#include "grading/intake/downloaded_name.hpp"

#include <algorithm>
#include <optional>

namespace rigor {

namespace fs = std::filesystem;

namespace {

// Whether Canvas or Moodle gives this name to a file that was handed in without an archive, or to a
// folder with nothing but a text typed into a web page.
bool is_downloaded_alone(const std::string& file, bool is_folder)
{
    const std::optional<DownloadedName> name = downloaded_name(file);
    if (!name) return false;
    return is_folder ? name->is_online_text : !name->file.empty() && !is_archive_name(file);
}

} // namespace

Listing listing_of(const fs::path& folder)
{
    Listing listing;
    std::error_code& error = listing.error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        std::error_code unknown;
        const fs::file_status status = entry->symlink_status(unknown);
        if (is_by_product(name)) {
            if (fs::is_directory(status) || is_archive_name(name))
                listing.dotted.push_back(entry->path());
            continue;
        }
        if (fs::is_symlink(status))
            listing.links.push_back(entry->path());
        else if (is_downloaded_alone(name, fs::is_directory(status)))
            listing.downloaded.push_back(entry->path());
        else if (fs::is_directory(status))
            listing.folders.push_back(entry->path());
        else if (fs::is_regular_file(status) && is_archive_name(name))
            listing.archives.push_back(entry->path());
        else
            listing.others.push_back(entry->path());
    }
    std::sort(listing.downloaded.begin(), listing.downloaded.end());
    return listing;
}

bool holds(const fs::path& folder, const std::string& wanted)
{
    std::error_code error;
    const fs::file_status status = fs::symlink_status(folder / wanted, error);
    return fs::exists(status) && !fs::is_directory(status);
}

bool has_wanted_near(const fs::path& folder, const std::string& wanted)
{
    if (holds(folder, wanted)) return true;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->is_directory(error) && holds(entry->path(), wanted)) return true;
    return false;
}

} // namespace rigor
