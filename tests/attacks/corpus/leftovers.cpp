// SPDX-License-Identifier: MIT
#include "leftovers.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rigor::corpus {

namespace fs = std::filesystem;

namespace {

// The name and the number, in decimal, that the attacks give to what they try to leave.
constexpr const char *name = "rigor_attack", *key = "1919510383"; // 0x7269676f

std::string file_in(const fs::path& folder)
{
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->path().filename().string().find(name) != std::string::npos)
            return entry->path().string();
    return "";
}

std::string line_in(const char* list, const std::string& word)
{
    std::ifstream in(list);
    for (std::string line; std::getline(in, line);)
        if (line.find(word) != std::string::npos) return std::string(list) + ": " + line;
    return "";
}

// Whether there is a process below this one that does not end within five seconds. When a grader
// has ended, the monitor that it leaves takes a moment to end all the other processes.
bool has_process()
{
    constexpr int tries = 500;
    for (int i = 0; i < tries; ++i) {
        pid_t ended;
        while ((ended = waitpid(-1, nullptr, WNOHANG)) > 0) {
        }
        if (ended < 0 && errno == ECHILD) return false;
        usleep(10'000);
    }
    return true;
}

} // namespace

void adopt_orphans()
{
    if (prctl(PR_SET_CHILD_SUBREAPER, 1) != 0)
        throw std::runtime_error("cannot become the parent of orphans");
}

std::string leftovers()
{
    if (has_process()) return "a process";
    for (const char* folder : {"/tmp", "/var/tmp", "/dev/shm", "/", ".", RIGOR_SOURCE_DIR})
        if (const std::string found = file_in(folder); !found.empty()) return found;
    for (const char* list : {"/proc/sysvipc/shm", "/proc/sysvipc/msg", "/proc/sysvipc/sem"})
        if (const std::string found = line_in(list, key); !found.empty()) return found;
    for (const char* list : {"/proc/net/unix", "/proc/keys"})
        if (const std::string found = line_in(list, name); !found.empty()) return found;
    return "";
}

} // namespace rigor::corpus
