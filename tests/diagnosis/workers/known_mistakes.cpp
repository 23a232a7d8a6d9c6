// SPDX-License-Identifier: MIT
#include "diagnosis/workers/known_mistakes.hpp"

#include "support/judge_all.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace rigor::diagnosis {

namespace fs = std::filesystem;

MistakeFolders own_mistake_folders()
{
    return {RIGOR_MISTAKES_DIR, RIGOR_MISTAKE_WORKERS};
}

std::vector<KnownMistake> known_mistakes(const MistakeFolders& folders, FormulaIndex formula)
{
    const Formula& row = formulas[static_cast<unsigned>(formula)];
    std::vector<KnownMistake> result;
    std::error_code no_such_folder;
    const fs::path folder = folders.sources / row.topic / row.name;
    for (const auto& entry : fs::directory_iterator(folder, no_such_folder)) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string name = entry.path().stem();
        const fs::path worker =
            folders.workers / fmt::format("worker_mistake_{}.{}.{}", row.topic, row.name, name);
        if (!fs::exists(worker)) continue;
        result.push_back(
            {name, testing::second_line(entry.path(), "explains the mistake"), worker});
    }
    std::sort(result.begin(), result.end(),
              [](const KnownMistake& a, const KnownMistake& b) { return a.name < b.name; });
    return result;
}

} // namespace rigor::diagnosis
