// SPDX-License-Identifier: MIT
// The meshes of a scene: each is made once, and shared by all bodies that name it.
#pragma once

#include "geometry/shapes/solid_mesh.hpp"
#include "scene/language/json.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace rigor {

using SharedMesh = std::shared_ptr<const SolidMesh>;

class MeshLibrary {
public:
    /// The key "meshes" of a scene: texts of meshes by file name.
    /// @throws Mistake
    void read_texts(const Value& value);

    /// The mesh of a file, from its text in "meshes", times `scale`.
    /// @param file  its name, where the scene says it
    /// @throws Mistake
    SharedMesh from_file(const Value& file, double scale, int cells);

    /// The tetrahedra of a file, likewise.
    /// @throws Mistake
    std::shared_ptr<const TetrahedralMesh> tetrahedra(const Value& file, double scale);

    /// The mesh of this key, made by `make` unless it is known already.
    /// @param key    names the kind and every parameter
    /// @param value  where the scene says it
    /// @throws Mistake
    SharedMesh generated(const std::string& key, const Value& value, int cells,
                         const std::function<TriangleMesh()>& make);

private:
    const Value& text_of(const Value& file) const;

    std::map<std::string, const Value*, std::less<>> texts_;
    std::map<std::string, SharedMesh, std::less<>> known_;
};

} // namespace rigor
