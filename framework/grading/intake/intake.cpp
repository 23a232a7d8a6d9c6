// SPDX-License-Identifier: MIT
#include "grading/intake/intake.hpp"

#include "errors/quotes.hpp"
#include "grading/intake/archive.hpp"
#include "grading/intake/folder.hpp"
#include "grading/intake/refused.hpp"
#include "grading/intake/unpacked.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace rigor {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> files_called(const std::string& wanted, const Contents& contents)
{
    std::vector<std::string> found;
    for (const auto& [name, text] : contents.sources())
        if (fs::path(name).filename() == wanted && !is_by_product(name)) found.push_back(name);
    return found;
}

[[noreturn]] void refuse_without(const std::string& wanted, const Contents& contents)
{
    std::vector<std::string> found;
    for (const auto& [name, text] : contents.sources())
        if (!is_by_product(name)) found.push_back(name);
    for (const std::string& name : contents.others())
        if (!is_by_product(name)) found.push_back(name);
    const bool has_archive = std::any_of(found.begin(), found.end(), is_archive_name);
    throw Refused(fmt::format(
        "expected {}, found {}{}", wanted, found.empty() ? "no file" : first_names(found),
        has_archive ? ": an archive in an archive, or beside other files, is not opened" : ""));
}

} // namespace

std::string first_names(const std::vector<std::string>& names)
{
    constexpr std::size_t most = 4;
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < most; ++i)
        text += (i == 0 ? "" : ", ") + in_quotes(names[i]);
    return names.size() > most ? fmt::format("{} and {} more", text, names.size() - most) : text;
}

std::string only_archive_in(const Contents& folder)
{
    const auto is_by_student = [](const auto& file) { return !is_by_product(file); };
    std::vector<std::string> found;
    std::copy_if(folder.others().begin(), folder.others().end(), std::back_inserter(found),
                 is_by_student);
    for (const auto& [name, text] : folder.sources())
        if (is_by_student(name)) found.push_back(name);
    return found.size() == 1 && is_archive_name(found[0]) ? found[0] : "";
}

Intake take_files_for(const std::string& wanted, const Contents& contents)
{
    const std::vector<std::string> found = files_called(wanted, contents);
    if (found.empty()) refuse_without(wanted, contents);
    if (found.size() > 1)
        throw Refused(
            fmt::format("expected one {}, found {}: {}", wanted, found.size(), first_names(found)));
    const std::string folder = found[0].substr(0, found[0].size() - wanted.size());
    Intake intake;
    for (const auto& [name, text] : contents.sources()) {
        if (name.starts_with(folder) && !is_by_product(name))
            intake.files.emplace(name.substr(folder.size()), text);
        else
            intake.ignored.push_back(name);
    }
    intake.ignored.insert(intake.ignored.end(), contents.others().begin(), contents.others().end());
    return intake;
}

Intake take_submission(const fs::path& path, const std::string& wanted)
{
    const fs::path around = path.parent_path(), name = path.filename();
    if (!fs::is_directory(fs::symlink_status(path)))
        return take_files_for(wanted, is_source(name.string())
                                          ? read_single_file(path, wanted)
                                          : read_archive_behind_walls(around, name));
    const Contents contents = read_folder(path);
    const std::string archive = only_archive_in(contents);
    return take_files_for(
        wanted, archive.empty() ? contents : read_archive_behind_walls(around, name / archive));
}

} // namespace rigor
