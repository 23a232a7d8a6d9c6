// SPDX-License-Identifier: MIT
// The folders of the source tree and of its build.
#pragma once

#include <filesystem>

namespace rigor {

struct Places {
    std::filesystem::path source; // the top of the tree, with student/, assignments/, …
    std::filesystem::path build;  // the build folder, build/<preset>

    std::filesystem::path program(const char* name) const { return build / "bin" / name; }
    std::filesystem::path assignments() const { return source / "assignments"; }
    bool has_reference() const { return std::filesystem::is_directory(source / "reference"); }
};

/// The source tree and the build folder from which this program was built.
const Places& places();

/// Requires that neither folder lies where a submission's compiler may read: in a folder of the
/// system such as /usr, or below one. @throws InputError otherwise
void require_hidden(const Places& places);

/// A lock on a build folder, held while this object lives, so that one process at a time writes
/// there; the script `rigor` takes the same lock. If another process holds it, the constructor
/// prints a note on stderr and waits.
class BuildLock {
public:
    explicit BuildLock(const std::filesystem::path& build = places().build);
    ~BuildLock();
    BuildLock(const BuildLock&) = delete;
    BuildLock& operator=(const BuildLock&) = delete;

private:
    int descriptor_;
};

} // namespace rigor
