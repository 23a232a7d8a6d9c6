// SPDX-License-Identifier: MIT
#include "sandbox/main/options.hpp"

#include "sandbox/main/failure.hpp"

#include <cerrno>
#include <cstdlib>
#include <string_view>

namespace rigor::confine {

namespace {

struct LimitName {
    std::string_view name;
    __rlimit_resource resource;
};

constexpr LimitName limit_names[] = {
    {"address_space", RLIMIT_AS},  {"processor_time", RLIMIT_CPU}, {"file_size", RLIMIT_FSIZE},
    {"open_files", RLIMIT_NOFILE}, {"processes", RLIMIT_NPROC},    {"stack", RLIMIT_STACK},
};

[[noreturn]] void refuse(std::string_view option)
{
    errno = EINVAL;
    fail("read the option " + std::string(option));
}

// Reads a limit that is written NAME:NUMBER.
ResourceLimit limit(std::string_view text)
{
    for (const auto& [name, resource] : limit_names)
        if (text.substr(0, text.find(':')) == name && text.size() > name.size() + 1)
            return {resource, std::strtoull(text.data() + name.size() + 1, nullptr, 10)};
    refuse(text);
}

bool read_flag(Options& options, std::string_view name)
{
    if (name == "--probe") return options.probe = true;
    if (name == "--landlock") return options.landlock = true;
    if (name == "--profile=worker") return true;
    if (name == "--profile=compiler") return options.is_compiler = true;
    if (name == "--namespaces=plain") return options.namespaces = true;
    if (name == "--namespaces=user") return options.namespaces = options.user_namespace = true;
    if (name == "--seccomp=kill") return options.seccomp = true;
    if (name == "--seccomp=notify") return options.seccomp = options.notify = true;
    return false;
}

void read_value(Options& options, std::string_view name, const char* value)
{
    if (name == "--report")
        report_socket = options.report = std::atoi(value);
    else if (name == "--user")
        options.user = static_cast<unsigned>(std::strtoul(value, nullptr, 10));
    else if (name == "--read")
        options.readable.push_back(value);
    else if (name == "--write")
        options.writable.push_back(value);
    else if (name == "--folder")
        options.folder = value;
    else if (name == "--limit")
        options.limits.push_back(limit(value));
    else
        refuse(name);
}

} // namespace

Options parse(char** arguments)
{
    Options options;
    for (; *arguments && std::string_view(*arguments) != "--"; ++arguments) {
        const std::string_view text = *arguments;
        const std::size_t equals = text.find('=');
        if (read_flag(options, text)) continue;
        if (equals == std::string_view::npos) refuse(text);
        read_value(options, text.substr(0, equals), *arguments + equals + 1);
    }
    if (*arguments) options.program = arguments + 1;
    if (!options.probe && (!options.program || !*options.program)) refuse("PROGRAM");
    return options;
}

} // namespace rigor::confine
