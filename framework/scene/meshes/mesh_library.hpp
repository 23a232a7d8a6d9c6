// SPDX-License-Identifier: MIT
// The meshes of a scene. Each mesh is made once and is shared by all bodies that name it.
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
    /// Reads the key "meshes" of a scene: the texts of meshes by file name.
    /// @throws Mistake
    void read_texts(const Value& value);

    /// The mesh of a file, read from its OBJ text in "meshes" and multiplied by `scale` along x, y
    /// and z. With a depth, the file has an open surface, and the mesh is the solid below that
    /// surface, see geometry/meshes/terrain.hpp.
    /// @param file   the value in the scene that holds the file name
    /// @param depth  [m]; 0: the surface in the file is closed
    /// @throws Mistake
    SharedMesh from_file(const Value& file, const Vector3d& scale, double depth, int cells);

    /// The tetrahedral mesh of a file, read and scaled in the same way.
    /// @throws Mistake
    std::shared_ptr<const TetrahedralMesh> tetrahedra(const Value& file, const Vector3d& scale);

    /// The mesh of this key. It is made by `make` at the first call with the key.
    /// @param key    names the kind of mesh and every parameter
    /// @param value  the value in the scene that describes the mesh
    /// @throws Mistake
    SharedMesh generated(const std::string& key, const Value& value, int cells,
                         const std::function<TriangleMesh()>& make);

private:
    const Value& text_of(const Value& file) const;

    std::map<std::string, const Value*, std::less<>> texts_;
    std::map<std::string, SharedMesh, std::less<>> known_;
};

} // namespace rigor
