// SPDX-License-Identifier: MIT
// The meshes of a scene. Each triangle mesh is made once and is shared by all bodies that describe
// the same mesh. A tetrahedral mesh is made again for each solid.
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
    /// Reads the value of the key "meshes" of a scene, which maps the names of mesh files to their
    /// texts.
    /// @throws Mistake
    void read_texts(const Value& value);

    /// The mesh of a file, read from its OBJ text in "meshes" and multiplied by `scale` along x, y
    /// and z. If `depth` > 0, the file has an open surface, and the mesh is the solid below that
    /// surface, see geometry/meshes/terrain.hpp.
    /// @param file   the value in the scene that holds the file name
    /// @param depth  depth of the solid below an open surface [m]; 0 for a closed surface
    /// @param cells  number of cells of the level set along the longest side of the mesh's bounds;
    ///               0 for `suggested_cells` (geometry/level_sets/level_set.hpp)
    /// @throws Mistake
    SharedMesh from_file(const Value& file, const Vector3d& scale, double depth, int cells);

    /// The tetrahedral mesh of a file, read from its text in "meshes" and multiplied by `scale`
    /// along x, y and z.
    /// @throws Mistake
    std::shared_ptr<const TetrahedralMesh> tetrahedra(const Value& file, const Vector3d& scale);

    /// A generated mesh. The first call with this `key` and `cells` makes the mesh by `make`; later
    /// calls return the same mesh.
    /// @param key    the kind of mesh and the values of all its parameters
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
