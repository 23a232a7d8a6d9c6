// SPDX-License-Identifier: MIT
#include "render/gl/shaders/program.hpp"

#include "render/gl/shaders/shader_sources.hpp"

#include <array>
#include <stdexcept>

namespace rigor {
namespace {

constexpr const char* shared = R"(
layout(std140) uniform View {
    mat4 to_clip, to_light;
    vec4 eye, light, screen;
};
)";

// The names of the looks, in the order of the enum `Look`.
constexpr const char* look_names[] = {"box",        "ball",   "model", "overlay", "ground",
                                      "background", "shadow", "text",  "patch"};
static_assert(std::size(look_names) == static_cast<std::size_t>(Look::count));

void attach(GLuint program, GLenum stage, const std::string& text, Look look)
{
    const GLuint shader = glCreateShader(stage);
    const char* lines = text.c_str();
    glShaderSource(shader, 1, &lines, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::array<char, 1024> words{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), nullptr, words.data());
    glAttachShader(program, shader);
    glDeleteShader(shader); // deleted together with the program
    if (!compiled)
        throw std::runtime_error(
            std::string(stage == GL_VERTEX_SHADER ? "the vertex" : "the fragment") +
            " shader of look " + look_names[static_cast<int>(look)] +
            " does not compile: " + words.data());
}

} // namespace

Program::Program(Look look, const std::string& definitions) : program_(glCreateProgram())
{
    const std::string start = "#version 330 core\n" + definitions + shared;
    const ShaderSource text = source(look);
    attach(program_, GL_VERTEX_SHADER, start + text.vertex, look);
    attach(program_, GL_FRAGMENT_SHADER, start + text.fragment, look);
    glLinkProgram(program_);
    GLint linked = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (!linked)
        throw std::runtime_error(std::string("the shaders of look ") +
                                 look_names[static_cast<int>(look)] + " do not link");
    const GLuint block = glGetUniformBlockIndex(program_, "View");
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(program_, block, 0);
}

} // namespace rigor
