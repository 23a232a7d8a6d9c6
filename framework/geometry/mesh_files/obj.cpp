// SPDX-License-Identifier: MIT
// Reads an OBJ file line by line. Faces refer to vertices by number, and each face is divided into
// a fan of triangles. Last, vertices that no face uses are removed.
#include "geometry/mesh_files/obj.hpp"

#include "geometry/mesh_files/mesh_text.hpp"

#include <array>
#include <cmath>

namespace rigor {

namespace {

// The tokens of a line, one after the other.
class Words {
public:
    explicit Words(std::string_view line) : rest_(line) {}

    std::string_view next() // empty at the end
    {
        const std::size_t start = rest_.find_first_not_of(" \t\r");
        if (start == std::string_view::npos) return {};
        rest_.remove_prefix(start);
        const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r"));
        rest_.remove_prefix(word.size());
        return word;
    }

private:
    std::string_view rest_;
};

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

    ObjMesh finish()
    {
        if (read_.mesh.triangles.empty())
            throw MeshError(0, "expected vertices \"v x y z\" and faces \"f 1 2 3\", found none");
        std::vector<int> number(read_.mesh.vertices.size(), -1); // new numbers of used vertices
        std::vector<Vector3d> used;
        for (std::size_t t = 0; t < read_.mesh.triangles.size(); ++t)
            for (int& vertex : read_.mesh.triangles[t]) {
                if (vertex >= static_cast<int>(number.size()))
                    throw MeshError(read_.lines[t], "expected vertices from 1 to " +
                                                        std::to_string(number.size()) + ", found " +
                                                        std::to_string(vertex + 1));
                int& n = number[vertex];
                if (n < 0) {
                    n = static_cast<int>(used.size());
                    used.push_back(read_.mesh.vertices[vertex]);
                }
                vertex = n;
            }
        read_.mesh.vertices = std::move(used);
        return std::move(read_);
    }

private:
    void read_vertex(Words& words)
    {
        if (read_.mesh.vertices.size() >= most_mesh_vertices)
            throw MeshError(line_, "expected at most " + std::to_string(most_mesh_vertices) +
                                       " vertices, found more");
        Vector3d v;
        for (double& x : v) {
            const std::string_view word = words.next();
            if (!parse(word, x) || !std::isfinite(x) || std::abs(x) > largest_coordinate)
                throw MeshError(line_, "expected a coordinate of at most 1e12 in size, found " +
                                           quoted(word, "the end of the line"));
        }
        read_.mesh.vertices.push_back(v);
    }

    // The index of a vertex, counted from 0, for "7", "7/1", "7//2" or "-1/-1/-1".
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
        std::array<int, 3> fan{}; // the first vertex, and the last two that were read
        int corners = 0;
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            const int index = vertex_index(word);
            if (corners < 3)
                fan[corners] = index;
            else
                fan = {fan[0], fan[2], index};
            if (++corners >= 3) add_triangle(fan);
        }
        if (corners < 3)
            throw MeshError(line_, "expected a face of at least three vertices, found " +
                                       std::to_string(corners));
    }

    void add_triangle(const std::array<int, 3>& triangle)
    {
        if (read_.mesh.triangles.size() >= most_mesh_triangles)
            throw MeshError(line_, "expected at most " + std::to_string(most_mesh_triangles) +
                                       " triangles, found more");
        read_.mesh.triangles.push_back(triangle);
        read_.lines.push_back(line_);
    }

    ObjMesh read_;
    int line_ = 0;
};

} // namespace

ObjMesh read_obj(std::string_view text)
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
