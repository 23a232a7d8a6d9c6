// SPDX-License-Identifier: MIT
#include "grading/intake/downloaded_name.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>

namespace rigor {

std::optional<DownloadedName> downloaded_name(const std::string& name)
{
    // The student's own name for the file comes last, and may look like anything. The name from
    // Canvas, which is over after three underscores, is tried first. In Moodle students may choose
    // their own names too. So if Moodle's words stand there twice, nobody can tell which are
    // Moodle's.
    static const std::regex canvas("^([^_]+)_(?:LATE_)?([0-9]+)_[0-9]+_(.*)$"),
        moodle("^(.+?)_([0-9]+)_assignsubmission_(file|onlinetext)(?:_(.*))?$");
    std::smatch parts;
    if (std::regex_match(name, parts, canvas))
        return DownloadedName{LearningSystem::canvas, parts[1], parts[2], parts[3], false};
    if (std::regex_match(name, parts, moodle) &&
        parts[4].str().find("_assignsubmission_") == std::string::npos)
        return DownloadedName{LearningSystem::moodle, parts[1], parts[2], parts[4],
                              parts[3] == "onlinetext"};
    return {};
}

bool is_called(const std::string& file, const std::string& wanted)
{
    const std::filesystem::path path(file), asked(wanted);
    if (path.extension() != asked.extension()) return false;
    const std::string stem = path.stem().string(), stem_asked = asked.stem().string();
    if (!stem.starts_with(stem_asked)) return false;
    const std::string rest = stem.substr(stem_asked.size());
    return rest.empty() || (rest.size() > 1 && rest[0] == '-' &&
                            std::all_of(rest.begin() + 1, rest.end(),
                                        [](unsigned char c) { return std::isdigit(c) != 0; }));
}

} // namespace rigor
