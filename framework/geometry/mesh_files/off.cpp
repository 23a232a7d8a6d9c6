// SPDX-License-Identifier: MIT
// Reads an OFF file line by line: the header, the numbers of vertices and faces, then a line for
// each vertex and a line for each face. Last, vertices that no face uses are removed.
#include "geometry/mesh_files/off.hpp"

#include "geometry/mesh_files/mesh_text.hpp"

namespace rigor {

namespace {

// The lines of a text, without the lines that are empty or only a comment.
class Lines {
public:
    explicit Lines(std::string_view text) : rest_(text) {}

    int number() const { return number_; } // number of the line that `next` returned, from 1

    /// @param what  what the line should contain, for the error if the text has no more lines
    std::string_view next(const char* what)
    {
        while (!rest_.empty()) {
            const std::size_t end = rest_.find('\n');
            std::string_view line = rest_.substr(0, end);
            rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
            ++number_;
            line = line.substr(0, line.find('#'));
            if (!Words(line).next().empty()) return line;
        }
        throw MeshError(number_, std::string("expected ") + what + ", found the end of the file");
    }

private:
    std::string_view rest_;
    int number_ = 0;
};

std::size_t read_count(Words& words, std::size_t most, const char* what, int line)
{
    const std::string_view word = words.next();
    long long count = 0;
    if (!parse(word, count) || count < 1 || count > static_cast<long long>(most))
        throw MeshError(line, std::string("expected the number of ") + what + " from 1 to " +
                                  std::to_string(most) + ", found " +
                                  quoted(word, "the end of the line"));
    return static_cast<std::size_t>(count);
}

void read_face(Words words, std::size_t vertices, SurfaceText& read, int line)
{
    const std::size_t corners = read_count(words, vertices, "the vertices of a face", line);
    Fan fan(read, line);
    for (std::size_t i = 0; i < corners; ++i) {
        const std::string_view word = words.next();
        int vertex = 0;
        if (!parse(word, vertex) || vertex < 0 || vertex >= static_cast<int>(vertices))
            throw MeshError(line, "expected a vertex from 0 to " + std::to_string(vertices - 1) +
                                      ", found " + quoted(word, "the end of the line"));
        fan.add(vertex);
    }
    fan.finish();
}

} // namespace

SurfaceText read_off(std::string_view text)
{
    SurfaceText read;
    Lines lines(text);
    std::string_view line = lines.next("\"OFF\"");
    Words header(line);
    if (const std::string_view word = header.next(); word != "OFF")
        throw MeshError(lines.number(), "expected \"OFF\" at the start, found " + quoted(word, ""));
    Words counts = header; // the counts may follow on the line of "OFF"
    if (Words(header).next().empty())
        counts = Words(lines.next("the numbers of vertices and faces"));
    const std::size_t vertices = read_count(counts, most_mesh_vertices, "vertices", lines.number());
    const std::size_t faces = read_count(counts, most_mesh_triangles, "faces", lines.number());
    for (std::size_t i = 0; i < vertices; ++i) {
        Words words(lines.next("another vertex"));
        read.mesh.vertices.push_back(read_coordinates(words, lines.number()));
    }
    for (std::size_t i = 0; i < faces; ++i) {
        const Words words(lines.next("another face"));
        read_face(words, vertices, read, lines.number());
    }
    keep_used_vertices(read.mesh);
    return read;
}

} // namespace rigor
