// SPDX-License-Identifier: MIT
// Runs `unpack` in a sandbox and reads the list of entries that it prints. An entry is a letter for
// the kind, the lengths of the name and the text, a newline, and then name and text. An entry of
// kind `e` ends the list.
#include "grading/intake/unpacked.hpp"

#include "grading/intake/plain_file.hpp"
#include "grading/intake/refused.hpp"
#include "sandbox/run_confined.hpp"

#include <array>
#include <charconv>
#include <fmt/format.h>

namespace rigor {

namespace fs = std::filesystem;

namespace {

constexpr char source_kind = 's', other_kind = 'o', refused_kind = 'r', end_kind = 'e';

std::string entry_text(char kind, std::string_view name, std::string_view text)
{
    return fmt::format("{} {} {}\n{}{}", kind, name.size(), text.size(), name, text);
}

struct PrintedEntry {
    char kind = 0;
    std::string name, text;
};

// Reads entries from the text that `unpack` printed, and removes them from its front.
class PrintedReader {
public:
    explicit PrintedReader(std::string_view text) : rest_(text) {}

    PrintedEntry next()
    {
        PrintedEntry entry;
        entry.kind = taken(1)[0];
        taken(1);
        const std::size_t name = number(' '), text = number('\n');
        entry.name = taken(name);
        entry.text = taken(text);
        return entry;
    }
    bool is_empty() const { return rest_.empty(); }

private:
    std::string_view taken(std::size_t size)
    {
        if (size > rest_.size()) throw Refused("could not be unpacked: the list of files is cut");
        const std::string_view front = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return front;
    }

    std::size_t number(char end)
    {
        std::size_t value = 0;
        const char* last = rest_.data() + rest_.size();
        const auto [at, error] = std::from_chars(rest_.data(), last, value);
        if (error != std::errc() || at == last || *at != end)
            throw Refused("could not be unpacked: the list of files has no length");
        taken(static_cast<std::size_t>(at - rest_.data()) + 1);
        return value;
    }

    std::string_view rest_;
};

// Pointers to all limits, in the order of the command-line arguments of `unpack`.
template <class Limits> auto all_of(Limits& limits)
{
    return std::array{&limits.entries,        &limits.archive_bytes,      &limits.unpacked_bytes,
                      &limits.unpacked_ratio, &limits.bytes_at_any_ratio, &limits.source_bytes};
}

Confinement walls_of_unpack()
{
    using std::filesystem::perms;
    std::error_code error; // ignored: if `unpack` cannot be read, it does not start
    fs::permissions(RIGOR_UNPACK, perms::others_read | perms::others_exec,
                    std::filesystem::perm_options::add, error);
#ifdef RIGOR_SANITIZED // a sanitizer needs calls and memory that the sandbox forbids
    return {Profile::compiler, Tier::c};
#else
    Confinement walls{Profile::compiler, usual_tier()};
    walls.readable = {RIGOR_UNPACK};
    // [bytes]; besides the sources, the library keeps a dictionary for decompression in memory,
    // which has at most some hundred megabytes.
    walls.limits.address_space = std::uint64_t{1} << 30;
    walls.limits.processor_time = 60; // [s]; unpacking 64 MB takes less than a second
    walls.limits.file_size = 0;
    walls.limits.open_files = 32;
    walls.limits.processes = 8;
    return walls;
#endif
}

std::string what_unpack_prints(int archive, const IntakeLimits& limits)
{
    RunLimits run_limits;
    run_limits.time = std::chrono::seconds(120);
    // The output has the sources, and besides these at most 2048 bytes for each name and its
    // lengths.
    run_limits.output = run_limits.output_kept = limits.source_bytes + limits.entries * 2048;
    std::vector<std::string> command = {RIGOR_UNPACK};
    for (const std::string& argument : arguments_of(limits))
        command.push_back(argument);
    const ConfinedRun run = run_confined(walls_of_unpack(), command, run_limits, archive);
    if (run.ok()) return run.output;
    const char* why = run.timed_out      ? "it took too long"
                      : run.flooded      ? "it grew without end"
                      : run.blocked_call ? "it made a call that is not allowed"
                                         : "the program that unpacks it crashed";
    throw Refused(std::string("expected a whole .zip or .tar archive, found one that cannot be "
                              "unpacked: ") +
                  why);
}

} // namespace

std::string printed(const Contents& contents)
{
    std::string text;
    for (const auto& [name, source] : contents.sources())
        text += entry_text(source_kind, name, source);
    for (const std::string& name : contents.others())
        text += entry_text(other_kind, name, "");
    return text + entry_text(end_kind, "", "");
}

std::string printed_refusal(std::string_view reason)
{
    return entry_text(refused_kind, "", reason);
}

Contents read_printed(std::string_view text, const IntakeLimits& limits)
{
    Contents contents(limits);
    for (PrintedReader reader(text);;) {
        PrintedEntry entry = reader.next();
        if (entry.kind == end_kind && reader.is_empty()) return contents;
        if (entry.kind == refused_kind) throw Refused(entry.text);
        const std::string name = contents.add_name(entry.name);
        if (entry.kind == source_kind)
            contents.add_source(name, std::move(entry.text));
        else if (entry.kind == other_kind)
            contents.add_other(name);
        else
            throw Refused("could not be unpacked: the list of files has an unknown entry");
    }
}

std::vector<std::string> arguments_of(const IntakeLimits& limits)
{
    std::vector<std::string> arguments;
    for (const std::size_t* limit : all_of(limits))
        arguments.push_back(std::to_string(*limit));
    return arguments;
}

IntakeLimits limits_of(const std::vector<std::string>& arguments)
{
    IntakeLimits limits;
    std::size_t i = 0;
    for (std::size_t* limit : all_of(limits))
        *limit = std::stoul(arguments.at(i++));
    return limits;
}

Contents read_archive_behind_walls(const fs::path& folder, const fs::path& name,
                                   const IntakeLimits& limits)
{
    return read_printed(what_unpack_prints(opened_plain_file(folder, name), limits), limits);
}

} // namespace rigor
