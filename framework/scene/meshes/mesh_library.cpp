// SPDX-License-Identifier: MIT
#include "scene/meshes/mesh_library.hpp"

#include "errors/quotes.hpp"
#include "geometry/mesh_files/obj.hpp"
#include "geometry/mesh_files/tetrahedra_files.hpp"
#include "geometry/meshes/mesh_checks.hpp"
#include "geometry/meshes/terrain.hpp"
#include "geometry/tetrahedra/tetrahedra_checks.hpp"

#include <fmt/format.h>

namespace rigor {

namespace {

// A mistake in the text of a mesh. `line` is the line of the scene that contains this text. If
// `error.line` is 0, no single line of the text is wrong.
Mistake mistake_in(const std::string& mesh, int line, const MeshError& error)
{
    const std::string place = error.line > 0 ? fmt::format(":{}", error.line) : "";
    return {line, fmt::format("{}{}: {}", in_quotes(mesh), place, error.what())};
}

} // namespace

void MeshLibrary::read_texts(const Value& value)
{
    constexpr std::string_view what = "texts of meshes by name {\"ring.obj\": \"v 0 0 0 …\"}";
    if (value.kind != Value::Kind::object) expected(what, value);
    for (const Value& item : value.items) {
        if (item.kind != Value::Kind::string) expected("the text of a mesh", item);
        texts_[item.key] = &item;
    }
}

const Value& MeshLibrary::text_of(const Value& file) const
{
    const auto text = texts_.find(file.text);
    if (text == texts_.end())
        throw Mistake{file.line,
                      fmt::format("expected the text of the mesh {} in \"meshes\", found none: "
                                  "load the scene from its file, which reads the mesh files",
                                  in_quotes(file.text))};
    return *text->second;
}

SharedMesh MeshLibrary::from_file(const Value& file, const Vector3d& scale, double depth, int cells)
{
    const std::string& name = file.text;
    const Value& text = text_of(file);
    SharedMesh& mesh = known_[fmt::format("{} {} {} {} {} {}", name, scale.x(), scale.y(),
                                          scale.z(), depth, cells)];
    if (mesh) return mesh;
    try {
        SurfaceText read = read_obj(text.text);
        for (Vector3d& v : read.mesh.vertices)
            v = v.cwiseProduct(scale);
        if (depth > 0) {
            read.mesh = solid_below(read.mesh, depth, read.lines);
            read.lines.resize(read.mesh.triangles.size(), 0); // 0 for triangles not in the file
        }
        check_mesh(read.mesh, read.lines);
        mesh = std::make_shared<SolidMesh>(std::move(read.mesh), name, cells);
    } catch (const MeshError& error) {
        throw mistake_in(name, text.line, error);
    }
    return mesh;
}

std::shared_ptr<const TetrahedralMesh> MeshLibrary::tetrahedra(const Value& file,
                                                               const Vector3d& scale)
{
    const Value& text = text_of(file);
    try {
        TetrahedraText read = read_tetrahedra(text.text);
        for (Vector3d& v : read.mesh.vertices)
            v = v.cwiseProduct(scale);
        check_mesh(read.mesh, read.lines);
        return std::make_shared<TetrahedralMesh>(std::move(read.mesh));
    } catch (const MeshError& error) {
        throw mistake_in(file.text, text.line, error);
    }
}

SharedMesh MeshLibrary::generated(const std::string& key, const Value& value, int cells,
                                  const std::function<TriangleMesh()>& make)
{
    SharedMesh& mesh = known_[fmt::format("{} {}", key, cells)];
    if (mesh) return mesh;
    try {
        TriangleMesh made = make();
        check_mesh(made);
        mesh = std::make_shared<SolidMesh>(std::move(made), value.key, cells);
    } catch (const MeshError& error) {
        throw Mistake{value.line, fmt::format("the mesh of the {}: {}", value.key, error.what())};
    }
    return mesh;
}

} // namespace rigor
