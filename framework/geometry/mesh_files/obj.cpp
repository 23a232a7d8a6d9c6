// SPDX-License-Identifier: MIT
// Reads an OBJ file line by line. Faces refer to vertices by index, and each face is divided into
// a fan of triangles. Last, vertices that no face uses are removed.
#include "geometry/mesh_files/obj.hpp"

#include "geometry/mesh_files/mesh_text.hpp"

namespace rigor {

namespace {

class ObjReader {
public:
    void read_line(std::string_view line)
    {
        ++line_;
        Words words(line);
        const std::string_view kind = words.next();
        if (kind == "v") read_vertex(words);
        if (kind == "f") read_face(words);
    }

    SurfaceText finish()
    {
        if (read_.mesh.triangles.empty())
            throw MeshError(0, "expected vertices \"v x y z\" and faces \"f 1 2 3\", found none");
        const int count = static_cast<int>(read_.mesh.vertices.size());
        for (std::size_t t = 0; t < read_.mesh.triangles.size(); ++t)
            for (const int vertex : read_.mesh.triangles[t])
                if (vertex >= count)
                    throw MeshError(read_.lines[t], "expected vertices from 1 to " +
                                                        std::to_string(count) + ", found " +
                                                        std::to_string(vertex + 1));
        keep_used_vertices(read_.mesh);
        return std::move(read_);
    }

private:
    void read_vertex(Words& words)
    {
        if (read_.mesh.vertices.size() >= most_mesh_vertices)
            throw MeshError(line_, "expected at most " + std::to_string(most_mesh_vertices) +
                                       " vertices, found more");
        read_.mesh.vertices.push_back(read_coordinates(words, line_));
    }

    // The index of a vertex, counted from 0, for "7", "7/1", "7//2" or "-1/-1/-1": only the first
    // number counts, and -1 is the last vertex so far.
    int vertex_index(std::string_view word) const
    {
        const int count = static_cast<int>(read_.mesh.vertices.size());
        int index = 0;
        if (!parse(word.substr(0, word.find('/')), index) || index == 0 || index < -count)
            throw MeshError(line_, "expected a vertex from 1, or from -1 back to -" +
                                       std::to_string(count) + ", found " +
                                       quoted(word, "the end of the line"));
        return index > 0 ? index - 1 : count + index;
    }

    void read_face(Words& words)
    {
        Fan fan(read_, line_);
        for (std::string_view word = words.next(); !word.empty(); word = words.next())
            fan.add(vertex_index(word));
        fan.finish();
    }

    SurfaceText read_;
    int line_ = 0;
};

} // namespace

SurfaceText read_obj(std::string_view text)
{
    ObjReader reader;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        reader.read_line(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return reader.finish();
}

std::string obj_text(const TriangleMesh& mesh)
{
    std::string text;
    for (const Vector3d& v : mesh.vertices) {
        text += 'v';
        for (const double x : v) {
            text += ' ';
            append(text, x);
        }
        text += '\n';
    }
    for (const auto& triangle : mesh.triangles) {
        text += 'f';
        for (const int vertex : triangle)
            text += ' ' + std::to_string(vertex + 1);
        text += '\n';
    }
    return text;
}

} // namespace rigor
