// SPDX-License-Identifier: MIT
// Reads tetrahedral meshes from Gmsh and Medit texts, section by section. Vertices keep the
// numbers of the text until the end; then the used vertices are numbered again, and the others are
// removed.
#include "geometry/mesh_files/tetrahedra_files.hpp"

#include "geometry/mesh_files/mesh_text.hpp"
#include "geometry/mesh_files/tokenizer.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <utility>

namespace rigor {

namespace {

// The largest number of elements in a Gmsh file, and of blocks of nodes or elements. Elements are
// not only tetrahedra, but also points, lines and triangles.
constexpr std::size_t most_entities = 10 * most_tetrahedra;
constexpr long long any = std::numeric_limits<long long>::max();

// The mesh as the text numbers it: each vertex has the number (tag) that the text gives it, and
// tetrahedra refer to these numbers.
class NumberedMesh {
public:
    void add_vertex(long long tag, Tokenizer& tokens)
    {
        Vector3d v;
        for (double& x : v)
            x = tokens.coordinate();
        tags_.push_back({tag, static_cast<int>(vertices_.size())});
        vertices_.push_back(v);
    }

    void add_tetrahedron(Tokenizer& tokens)
    {
        if (tetrahedra_.size() >= most_tetrahedra)
            throw MeshError(tokens.line(), "expected at most " + std::to_string(most_tetrahedra) +
                                               " tetrahedra, found more");
        std::array<long long, 4> t{};
        for (long long& tag : t)
            tag = tokens.integer(1, any, "the number of a vertex");
        tetrahedra_.push_back(t);
        lines_.push_back(tokens.line());
    }

    TetrahedraText finish()
    {
        std::sort(tags_.begin(), tags_.end());
        for (std::size_t i = 1; i < tags_.size(); ++i)
            if (tags_[i].first == tags_[i - 1].first)
                throw MeshError(0, "expected each vertex once, found number " +
                                       std::to_string(tags_[i].first) + " twice");
        TetrahedraText read;
        std::vector<int> number(vertices_.size(), -1); // new index of each vertex, or -1 if unused
        for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
            std::array<int, 4> corners{};
            for (int i = 0; i < 4; ++i) {
                int& n = number[index(tetrahedra_[t][i], lines_[t])];
                if (n < 0) {
                    n = static_cast<int>(read.mesh.vertices.size());
                    read.mesh.vertices.push_back(vertices_[&n - number.data()]);
                }
                corners[i] = n;
            }
            read.mesh.tetrahedra.push_back(corners);
        }
        if (read.mesh.tetrahedra.empty()) throw MeshError(0, "expected tetrahedra, found none");
        read.lines = std::move(lines_);
        return read;
    }

private:
    int index(long long tag, int line) const
    {
        const auto found = std::lower_bound(tags_.begin(), tags_.end(), std::pair(tag, 0));
        if (found == tags_.end() || found->first != tag)
            throw MeshError(line, "expected the number of a vertex of this file, found " +
                                      std::to_string(tag) + " in an element");
        return found->second;
    }

    std::vector<std::pair<long long, int>> tags_;
    std::vector<Vector3d> vertices_;
    std::vector<std::array<long long, 4>> tetrahedra_;
    std::vector<int> lines_;
};

constexpr const char* an_integer = "an integer";

class MshReader {
public:
    explicit MshReader(std::string_view text) : tokens_(text) {}

    TetrahedraText read()
    {
        tokens_.expect("$MeshFormat");
        const std::string_view version = tokens_.next();
        if (version != "2.2" && version != "4.1")
            tokens_.refuse("the format of Gmsh 2.2 or 4.1", version);
        if (const std::string_view form = tokens_.next(); form != "0")
            tokens_.refuse("a text file, \"0\"", form);
        const bool in_blocks = version == "4.1";
        section_end("$EndMeshFormat");
        for (std::string_view word = tokens_.next(); !word.empty(); word = tokens_.next()) {
            if (word == "$Nodes") {
                in_blocks ? node_blocks() : nodes();
                tokens_.expect("$EndNodes");
            } else if (word == "$Elements") {
                in_blocks ? element_blocks() : elements();
                tokens_.expect("$EndElements");
            } else if (word.size() > 1 && word.front() == '$') {
                section_end("$End" + std::string(word.substr(1)));
            } else {
                tokens_.refuse("a section, \"$Nodes\" or \"$Elements\"", word);
            }
        }
        return numbered_.finish();
    }

private:
    void section_end(const std::string& end)
    {
        for (std::string_view word = tokens_.next(); word != end; word = tokens_.next())
            if (word.empty()) tokens_.refuse("\"" + end + "\"", word);
    }

    void nodes()
    {
        const std::size_t n = tokens_.count(most_tetrahedron_vertices, "vertices");
        for (std::size_t i = 0; i < n; ++i)
            numbered_.add_vertex(tokens_.integer(1, any, "the number of a vertex"), tokens_);
    }

    void node_blocks()
    {
        const std::size_t blocks = tokens_.count(most_entities, "blocks");
        std::size_t left = tokens_.count(most_tetrahedron_vertices, "vertices");
        tokens_.integer(0, any, an_integer), tokens_.integer(0, any, an_integer);
        std::vector<long long> tags;
        for (std::size_t b = 0; b < blocks; ++b) {
            tokens_.integer(0, 3, "a dimension"), tokens_.integer(-any, any, an_integer);
            const bool has_parameters = tokens_.integer(0, 1, "0 or 1") == 1;
            tags.resize(tokens_.count(left, "vertices"));
            left -= tags.size();
            for (long long& tag : tags)
                tag = tokens_.integer(1, any, "the number of a vertex");
            for (const long long tag : tags) {
                numbered_.add_vertex(tag, tokens_);
                if (has_parameters) tokens_.skip_line();
            }
        }
    }

    // Reads the rest of an element, after its kind. Curved tetrahedra are refused, and elements
    // that are not tetrahedra are skipped.
    void element(long long kind)
    {
        constexpr long long linear = 4, curved[] = {11, 29, 30, 31};
        if (std::find(std::begin(curved), std::end(curved), kind) != std::end(curved))
            tokens_.refuse("tetrahedra of four vertices, kind 4", std::to_string(kind));
        if (kind == linear)
            numbered_.add_tetrahedron(tokens_);
        else
            tokens_.skip_line();
    }

    void elements()
    {
        const std::size_t n = tokens_.count(most_entities, "elements");
        for (std::size_t i = 0; i < n; ++i) {
            tokens_.integer(1, any, "the number of an element");
            const long long kind = tokens_.integer(1, 1000, "a kind of element");
            const std::size_t tags = tokens_.count(100, "tags");
            for (std::size_t k = 0; k < tags; ++k)
                tokens_.integer(-any, any, an_integer);
            element(kind);
        }
    }

    void element_blocks()
    {
        const std::size_t blocks = tokens_.count(most_entities, "blocks");
        std::size_t left = tokens_.count(most_entities, "elements");
        tokens_.integer(0, any, an_integer), tokens_.integer(0, any, an_integer);
        for (std::size_t b = 0; b < blocks; ++b) {
            tokens_.integer(0, 3, "a dimension"), tokens_.integer(-any, any, an_integer);
            const long long kind = tokens_.integer(1, 1000, "a kind of element");
            const std::size_t n = tokens_.count(left, "elements");
            left -= n;
            for (std::size_t i = 0; i < n; ++i) {
                tokens_.integer(1, any, "the number of an element");
                element(kind);
            }
        }
    }

    Tokenizer tokens_;
    NumberedMesh numbered_;
};

bool is_keyword(std::string_view word)
{
    return !word.empty() && std::isalpha(static_cast<unsigned char>(word.front()));
}

// Skips numbers and comments up to the next keyword.
void skip_section(Tokenizer& tokens)
{
    for (std::string_view word = tokens.peek(); !word.empty() && !is_keyword(word);
         word = tokens.peek())
        word.front() == '#' ? tokens.skip_line() : void(tokens.next());
}

} // namespace

TetrahedraText read_msh(std::string_view text)
{
    return MshReader(text).read();
}

TetrahedraText read_medit(std::string_view text)
{
    Tokenizer tokens(text);
    NumberedMesh numbered;
    skip_section(tokens);
    tokens.expect("MeshVersionFormatted");
    tokens.integer(1, 4, "a version from 1 to 4");
    for (skip_section(tokens); is_keyword(tokens.peek()); skip_section(tokens)) {
        const std::string_view keyword = tokens.next();
        if (keyword == "End") break;
        if (keyword == "Dimension") tokens.integer(3, 3, "dimension 3");
        if (keyword == "Vertices") {
            const std::size_t n = tokens.count(most_tetrahedron_vertices, "vertices");
            for (std::size_t i = 0; i < n; ++i) {
                numbered.add_vertex(static_cast<long long>(i) + 1, tokens);
                tokens.integer(-any, any, "the reference of a vertex, an integer");
            }
        }
        if (keyword == "Tetrahedra") {
            const std::size_t n = tokens.count(most_tetrahedra, "tetrahedra");
            for (std::size_t i = 0; i < n; ++i) {
                numbered.add_tetrahedron(tokens);
                tokens.integer(-any, any, "the reference of a tetrahedron, an integer");
            }
        }
    }
    return numbered.finish();
}

TetrahedraText read_tetrahedra(std::string_view text)
{
    return Tokenizer(text).peek() == "$MeshFormat" ? read_msh(text) : read_medit(text);
}

std::string medit_text(const TetrahedralMesh& mesh)
{
    std::string text = "MeshVersionFormatted 2\nDimension 3\nVertices\n" +
                       std::to_string(mesh.vertices.size()) + "\n";
    for (const Vector3d& v : mesh.vertices) {
        for (const double x : v) {
            append(text, x);
            text += ' ';
        }
        text += "0\n";
    }
    text += "Tetrahedra\n" + std::to_string(mesh.tetrahedra.size()) + "\n";
    for (const auto& t : mesh.tetrahedra) {
        for (const int v : t)
            text += std::to_string(v + 1) + ' ';
        text += "0\n";
    }
    return text + "End\n";
}

} // namespace rigor
