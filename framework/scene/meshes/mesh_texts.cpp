// SPDX-License-Identifier: MIT
// Adds the texts of mesh files to the text of a scene: it finds the file names in the scene, reads
// and checks each file once, and inserts the texts as the key "meshes" at the start of the scene.
#include "scene/meshes/mesh_texts.hpp"

#include "errors/input_error.hpp"
#include "errors/quotes.hpp"
#include "geometry/mesh_files/obj.hpp"
#include "geometry/mesh_files/surface_files.hpp"
#include "geometry/mesh_files/tetrahedra_files.hpp"
#include "geometry/meshes/mesh_checks.hpp"
#include "geometry/tetrahedra/tetrahedra_checks.hpp"
#include "scene/language/keys.hpp"

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <vector>

namespace rigor {

namespace {

// Larger mesh files are refused, and so are scenes whose text is larger after the meshes are added:
// the limits bound the memory that a scene takes.
constexpr std::uintmax_t most_mesh_bytes = 64'000'000, most_scene_bytes = 16'000'000;

// A mesh file that the scene names.
struct NamedFile {
    const Value* name;
    bool is_solid; // whether it is a mesh of tetrahedra
    // Whether the scene gives a depth. Then the surface is open, and the mesh is checked later,
    // when `MeshLibrary::from_file` has closed it.
    bool is_open;
};

// Collects the names of mesh files, {"mesh": {"file": …}}, in a value and in all values inside it.
void find_files(const Value& value, bool in_solids, std::vector<NamedFile>& files)
{
    for (const Value& item : value.items) {
        const Value* file = item.key == "mesh" ? find(item, "file") : nullptr;
        if (file && file->kind == Value::Kind::string)
            files.push_back({file, in_solids, find(item, "depth") != nullptr});
        find_files(item, in_solids || item.key == "solids", files);
    }
}

// Checks a mesh, unless its surface is open, and writes it again as a short text, which has only
// its vertices and its triangles or tetrahedra.
std::string checked_text(std::string_view text, const NamedFile& file)
{
    if (file.is_solid) {
        const TetrahedraText read = read_tetrahedra(text);
        check_mesh(read.mesh, read.lines);
        return medit_text(read.mesh);
    }
    const SurfaceText read = read_surface(text, file.name->text);
    if (!file.is_open) check_mesh(read.mesh, read.lines);
    return obj_text(read.mesh);
}

std::string mesh_text(const NamedFile& file, const std::filesystem::path& scene_file)
{
    const Value& name = *file.name;
    const std::filesystem::path path = scene_file.parent_path() / name.text;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw Mistake{name.line, fmt::format("expected a mesh file, found {} at {}",
                                             std::filesystem::exists(path, error) ? "something else"
                                                                                  : "nothing",
                                             in_quotes(path.string()))};
    const auto refuse = [&](int line, const std::string& message) {
        const std::string place = line > 0 ? fmt::format(":{}", line) : "";
        throw InputError(fmt::format("{}{}: {}", path.string(), place, message));
    };
    if (const std::uintmax_t size = std::filesystem::file_size(path, error);
        !error && size > most_mesh_bytes)
        refuse(0,
               fmt::format("expected a mesh of at most {} bytes, found {}", most_mesh_bytes, size));
    std::ifstream stream(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) refuse(0, "expected a readable file, found it unreadable");
    try {
        return checked_text(text, file);
    } catch (const MeshError& mistake) {
        refuse(mistake.line, mistake.what());
    }
    return {};
}

// The text as the content of a JSON string, without the quotes around it.
std::string escaped(std::string_view text)
{
    std::string result;
    result.reserve(text.size() + text.size() / 16);
    for (const char c : text) {
        if (c == '\n')
            result += "\\n";
        else if (c == '"' || c == '\\')
            (result += '\\') += c;
        else if (static_cast<unsigned char>(c) < 0x20)
            result += fmt::format("\\u{:04x}", static_cast<int>(c));
        else
            result += c;
    }
    return result;
}

} // namespace

std::string with_mesh_texts(const std::string& text, const std::filesystem::path& scene_file)
{
    if (text.find("\"mesh\"") == std::string::npos) return text;
    const Value root = parse_json(text);
    std::vector<NamedFile> files;
    find_files(root, false, files);
    const std::size_t start = text.find('{');
    if (files.empty() || root.kind != Value::Kind::object || find(root, "meshes")) return text;

    std::string meshes;
    std::set<std::string_view> names;
    for (const NamedFile& file : files) {
        if (!names.insert(file.name->text).second) continue;
        meshes += fmt::format("{}\"{}\": \"{}\"", meshes.empty() ? "" : ", ",
                              escaped(file.name->text), escaped(mesh_text(file, scene_file)));
        if (text.size() + meshes.size() > most_scene_bytes)
            throw Mistake{file.name->line,
                          fmt::format("expected a scene of at most {} bytes with its "
                                      "meshes, found more",
                                      most_scene_bytes)};
    }
    std::string whole = text;
    whole.insert(start + 1, fmt::format("\"meshes\": {{{}}}, ", meshes));
    return whole;
}

} // namespace rigor
