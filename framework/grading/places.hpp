// SPDX-License-Identifier: MIT
// Where the tree and its build are.
#pragma once

#include <filesystem>

namespace rigor {

struct Places {
    std::filesystem::path source; // the tree: student/, assignments/, …
    std::filesystem::path build;  // build/<preset>

    std::filesystem::path program(const char* name) const { return build / "bin" / name; }
    std::filesystem::path assignments() const { return source / "assignments"; }
    bool has_reference() const { return std::filesystem::is_directory(source / "reference"); }
};

/// As they were when this program was built.
const Places& places();

/// One writer at a time in a build folder, the launcher included: held while this lives. Says so on
/// stderr if somebody else holds it.
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
