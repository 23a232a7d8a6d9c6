// SPDX-License-Identifier: MIT
// Files of tetrahedral meshes that a scene names.
#include "errors/input_error.hpp"
#include "scene/keys/scene_keys.hpp"
#include "support/close.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>
#include <fstream>

using namespace rigor;
using namespace rigor::testing;

namespace {

template <class Read> std::string refusal_of(const Read& read)
{
    try {
        read();
    } catch (const InputError& error) {
        const std::string message = error.what();
        CHECK(message.find('\n') == std::string::npos);
        return message;
    }
    return "accepted";
}

// Two tetrahedra that share a face, as a Medit text. `second` holds the vertices of the second one.
std::string medit(const std::string& second)
{
    return "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
           "1 1 1 0\nTetrahedra\n2\n1 2 3 4 0\n" +
           second + " 0\nEnd\n";
}

} // namespace

TEST_CASE("solids: a file of tetrahedra travels inside the scene that names it")
{
    const TemporaryFolder folder;
    folder.write("two.mesh", medit("2 3 4 5"));
    const std::string named =
        "{\"solids\": [\n{\"name\": \"a\", \"mesh\": {\"file\": \"two.mesh\"}},"
        "\n{\"name\": \"b\", \"mesh\": {\"file\": \"two.mesh\", \"scale\": 2}}]}";
    const Scene loaded = load_scene(folder.write("s.json", named));
    const Scene sent = parse_scene(loaded.text, "elsewhere");
    for (const Scene* scene : {&loaded, &sent}) {
        CHECK(scene->solids.at(0).mesh->tetrahedra.size() == 2);
        CHECK(scene->solids.at(1).mesh->vertices.at(4) == Vector3d(2, 2, 2));
    }
    CHECK(sent.text == loaded.text);
    CHECK(refusal_of([&] { parse_scene(named, "s"); }) ==
          "s:2: expected the text of the mesh \"two.mesh\" in \"meshes\", found none: load the "
          "scene from its file, which reads the mesh files");
}

TEST_CASE("solids: a file that is no solid is refused with its place")
{
    const TemporaryFolder folder;
    const std::filesystem::path scene = folder.write(
        "s.json", "{\"solids\": [{\"name\": \"a\",\n\"mesh\": {\"file\": \"m.mesh\"}}]}");
    const auto refused_file = [&](const std::string& text) {
        const std::string name = folder.write("m.mesh", text).string();
        const std::string message = refusal_of([&] { load_scene(scene); });
        return message.rfind(name, 0) == 0 ? message.substr(name.size()) : message;
    };
    CHECK(refusal_of([&] {
              load_scene(scene);
          }).find(":2: expected a mesh file, found nothing at") != std::string::npos);
    CHECK(refused_file(medit("2 3 4 5")) == "accepted");
    for (const char* bad :
         {"2 3 5 4", "2 3 4 4", "1 2 3 4", "2 3 4 9"}) // inverted, flat, repeated, missing
        CHECK(refused_file(medit(bad)).rfind(":13: expected", 0) == 0);
    CHECK(refused_file("hello").rfind(":1: expected", 0) == 0);
    CHECK(refused_file("").find("expected") != std::string::npos);
    CHECK(refusal_of([&] {
              parse_scene(
                  "{\"meshes\": {\"m\":\n\"MeshVersionFormatted 2\"}, \"solids\": [{\"name\": "
                  "\"a\", \"mesh\": {\"file\": \"m\"}}]}",
                  "s");
          }).rfind("s:2: \"m\":", 0) == 0);
}
