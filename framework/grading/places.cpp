// SPDX-License-Identifier: MIT
#include "grading/places.hpp"

#include "errors/input_error.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <sys/file.h>
#include <unistd.h>

namespace rigor {

const Places& places()
{
    static const Places built = {RIGOR_SOURCE_DIR, RIGOR_BINARY_DIR};
    return built;
}

void require_hidden(const Places& places)
{
    namespace fs = std::filesystem;
    for (const fs::path& place : {places.source, places.build})
        for (fs::path folder = fs::weakly_canonical(place); folder.has_relative_path();
             folder = folder.parent_path())
            for (const char* readable : {"/usr", "/bin", "/lib", "/lib64"}) // as in walls.cpp
                if (folder == readable)
                    throw InputError(fmt::format(
                        "{}: expected a folder outside of {}, which the compiler of a submission "
                        "can read",
                        place.string(), readable));
}

BuildLock::BuildLock(const std::filesystem::path& build)
{
    const std::filesystem::path file = build / "build.lock";
    descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0) throw std::runtime_error(file.string() + ": " + std::strerror(errno));
    if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    std::fputs("rigor: another rigor is building; waiting for it\n", stderr);
    while (flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
    }
}

BuildLock::~BuildLock()
{
    close(descriptor_);
}

} // namespace rigor
