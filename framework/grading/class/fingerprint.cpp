// SPDX-License-Identifier: MIT
#include "grading/class/fingerprint.hpp"

#include "errors/input_error.hpp"
#include "grading/build/submission_files.hpp"
#include "grading/intake/folder.hpp"
#include "grading/intake/intake.hpp"
#include "grading/intake/plain_file.hpp"
#include "grading/intake/refused.hpp"
#include "grading/places.hpp"
#include "sandbox/tier.hpp"
#include "seeds/drawn_seed.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <set>
#include <vector>

namespace rigor {

namespace fs = std::filesystem;

namespace {

// The hash of the bytes of a file of ours, continued from `hash`. A file that cannot be read counts
// as absent.
std::uint64_t hash_of_file(const fs::path& file, std::uint64_t hash)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) return hash_of("absent", hash);
    std::string block(1 << 20, '\0');
    while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0)
        hash =
            hash_of(std::string_view(block).substr(0, static_cast<std::size_t>(in.gcount())), hash);
    return hash;
}

// The hash of a file that a student handed in, `name` in `folder`: of its bytes, or of the reason
// why the intake will refuse it. An archive that is too large is not read: a file with gaps can
// have any size, and everybody would wait for it.
std::uint64_t hash_of_handed_in(const fs::path& folder, const fs::path& name, std::uint64_t hash)
{
    try {
        const std::size_t most = IntakeLimits().archive_bytes;
        const PlainFile file = read_plain_file(folder, name, most);
        if (file.size > most) return hash_of(fmt::format("too large: {}", file.size), hash);
        return hash_of(file.text, hash);
    } catch (const Refused& refused) {
        return hash_of(refused.what(), hash);
    }
}

// The hash of all files of a kind in a folder and below, in the order of the names.
std::uint64_t hash_of_folder(const fs::path& folder,
                             const std::function<bool(const fs::path&)>& is_wanted,
                             std::uint64_t hash)
{
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (is_wanted(entry->path())) files.push_back(entry->path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files)
        hash = hash_of_file(file, hash_of(file.lexically_relative(folder).string(), hash));
    return hash;
}

// Whether a file is a scene or a mesh.
bool is_of_a_scene(const fs::path& file)
{
    static const std::set<std::string> endings = {".json", ".obj", ".off", ".stl", ".msh", ".mesh"};
    return endings.count(file.extension().string()) > 0;
}

} // namespace

std::uint64_t hash_of_sources(const fs::path& folder, std::uint64_t hash)
{
    return hash_of_folder(folder, is_code, hash);
}

std::uint64_t hash_of_tools(const Toolchain& tools, std::uint64_t hash)
{
    hash = hash_of_file(tools.compile[0], hash);
    for (const std::vector<std::string>& command : {tools.compile, tools.link})
        for (const std::string& word : command)
            hash = hash_of(word + '\0', hash);
    return hash_of_file(no_file_queries(), hash);
}

SharedParts shared_parts(const Selection& selection, const GradingRun& run)
{
    static const Toolchain tools = student_toolchain();
    std::uint64_t assignment = hash_of(selection.assignment.name);
    for (const std::string& tag : selection.tags)
        assignment = hash_of(tag + ";", assignment);
    const std::uint64_t start = hash_of("");
    return {
        {"the assignment", assignment},
        {"the seed", hash_of(fmt::format("{}", run.seed))},
        {"the secret", hash_of(run.secret.empty() ? "" : hmac_sha256(run.secret, "fingerprint"))},
        {"the walls", hash_of(description(usual_tier()))},
        {"the compiler", hash_of_tools(tools, start)},
        {"the command", hash_of_file("/proc/self/exe", start)},
        {"the tests", hash_of_file(run.test_program, start)},
        {"the reference", run.oracle ? hash_of_file(*run.oracle, start) : start},
        {"the engine", hash_of_file(places().build / "framework/students_worker.o", start)},
        {"the sandbox", hash_of_file(places().program("confine"), start)},
        {"framework/formulas/", hash_of_sources(places().source / "framework/formulas", start)},
        {"student/", hash_of_sources(places().source / "student", start)},
        {"assignments/", hash_of_folder(places().assignments(), is_of_a_scene, start)}};
}

std::uint64_t fingerprint_of(const SharedParts& parts)
{
    std::uint64_t hash = hash_of("");
    for (const auto& [name, hash_of_part] : parts)
        hash = hash_of(fmt::format("{} {:x};", name, hash_of_part), hash);
    return hash;
}

void require_unchanged(const SharedParts& before, const Selection& selection, const GradingRun& run)
{
    std::string changed;
    for (const auto& [name, hash] : shared_parts(selection, run))
        if (const auto part = before.find(name); part == before.end() || part->second != hash)
            changed += (changed.empty() ? "" : ", ") + name;
    if (changed.empty()) return;
    throw InputError(
        fmt::format("expected nothing to change while a class is graded, found changes "
                    "in {}: start again, and the class is graded as it is now; what "
                    "is graded already counts only if you undo them",
                    changed));
}

bool is_of_the_same_tests(const std::string& fingerprint, std::uint64_t all_but_the_submission)
{
    return fingerprint.starts_with(fmt::format("{:016x}-", all_but_the_submission));
}

std::string fingerprint_of(const Submission& submission, std::uint64_t all_but_the_submission)
{
    const auto text = [&](std::uint64_t hash_of_both) {
        return fmt::format("{:016x}-{:016x}", all_but_the_submission, hash_of_both);
    };
    std::uint64_t hash =
        hash_of(submission.name + '\0' + submission.refusal, all_but_the_submission);
    if (!submission.refusal.empty()) return text(hash);
    const fs::path around = submission.path.parent_path(), name = submission.path.filename();
    if (!fs::is_directory(fs::symlink_status(submission.path)))
        return text(hash_of_handed_in(around, name, hash_of("archive", hash)));
    try {
        const Contents contents = read_folder(submission.path);
        for (const auto& [source, content] : contents.sources())
            hash = hash_of(source + '\0' + content + '\0', hash);
        for (const std::string& other : contents.others())
            hash = hash_of(other + '\0', hash);
        if (const std::string archive = only_archive_in(contents); !archive.empty())
            hash = hash_of_handed_in(around, name / archive, hash);
    } catch (const Refused& refused) {
        hash = hash_of(refused.what(), hash);
    }
    return text(hash);
}

} // namespace rigor
