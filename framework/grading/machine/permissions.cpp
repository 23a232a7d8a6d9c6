// SPDX-License-Identifier: MIT
#include "grading/machine/permissions.hpp"

#include "grading/places.hpp"

#include <system_error>

namespace rigor {

namespace fs = std::filesystem;

namespace {

void let_others(fs::perms wanted, const fs::path& path)
{
    std::error_code error;
    if ((fs::status(path, error).permissions() & wanted) != wanted)
        fs::permissions(path, wanted, fs::perm_options::add, error);
}

bool is_ours(const fs::path& folder)
{
    const auto is_within = [&](const fs::path& top) {
        return (folder.string() + '/').starts_with(top.string() + '/');
    };
    return is_within(places().source) || is_within(places().build);
}

} // namespace

void let_others_read(const fs::path& path)
{
    std::error_code error;
    const fs::file_type type = fs::symlink_status(path, error).type();
    if (type == fs::file_type::regular) let_others(fs::perms::others_read, path);
    if (type != fs::file_type::directory) return;
    let_others(fs::perms::others_read | fs::perms::others_exec, path);
    for (fs::directory_iterator entry(path, error), end; !error && entry != end;
         entry.increment(error))
        let_others_read(entry->path());
}

void let_others_pass(const fs::path& path)
{
    for (fs::path folder = path.parent_path(); is_ours(folder); folder = folder.parent_path())
        let_others(fs::perms::others_exec, folder);
}

} // namespace rigor
