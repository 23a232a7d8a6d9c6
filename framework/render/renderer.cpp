// SPDX-License-Identifier: MIT
#include "render/renderer.hpp"

#include "errors/input_error.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <vector>

namespace rigor {
namespace {

constexpr int largest_side = 8192;              // [pixels]; the limit of llvmpipe is 16384
constexpr long most_pixels = 7680L * 4320L;     // 1 GB with 4 samples of 8 bytes in each pixel
using CreateRenderer = Renderer* (*)(int, int); // the function that a module exports

const char* word(Gl gl)
{
    return gl == Gl::osmesa ? "osmesa" : "egl";
}

/// The places to look for a module: beside the program, where an installation puts it, and where it
/// was built.
std::vector<std::filesystem::path> module_paths(Gl gl)
{
    const std::string file = fmt::format("render_{}.so", word(gl));
    std::error_code none;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
    return {program / file, program / "../lib/rigor" / file,
            std::filesystem::path(RIGOR_MODULE_DIR) / file};
}

/// Loads a module permanently, since a graphics library cannot be unloaded and loaded again.
CreateRenderer load_module(Gl gl)
{
    std::string reason = "it was not built";
    for (const auto& path : module_paths(gl)) {
        if (!std::filesystem::exists(path)) continue;
        void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
        if (void* create = module ? dlsym(module, "create_renderer") : nullptr)
            return reinterpret_cast<CreateRenderer>(create);
        reason = dlerror();
    }
    throw std::runtime_error(reason);
}

std::unique_ptr<Renderer> create(Gl gl, int width, int height)
{
    return std::unique_ptr<Renderer>(load_module(gl)(width, height));
}

} // namespace

Gl default_gl()
{
    return gl_from_text(RIGOR_GL);
}

Gl gl_from_text(const std::string& text)
{
    if (text == "osmesa") return Gl::osmesa;
    if (text == "egl") return Gl::egl;
    throw InputError(fmt::format("--gl: expected osmesa or egl, found '{}'", text));
}

void check_size(int width, int height)
{
    if (width >= 1 && height >= 1 && width <= largest_side && height <= largest_side &&
        static_cast<long>(width) * height <= most_pixels)
        return;
    throw InputError(fmt::format(
        "size: expected from 1x1 to {0}x{0}, and no more pixels than 7680x4320 has, found {1}x{2}",
        largest_side, width, height));
}

OpenRenderer open_renderer(int width, int height, Gl gl)
{
    check_size(width, height);
    std::string first;
    try {
        return {create(gl, width, height), ""};
    } catch (const std::runtime_error& error) {
        first = error.what();
    }
    const Gl other = gl == Gl::osmesa ? Gl::egl : Gl::osmesa;
    try {
        auto renderer = create(other, width, height);
        return {std::move(renderer), fmt::format("cannot draw with {}: {}; drawing with {}",
                                                 word(gl), first, word(other))};
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(
            fmt::format("cannot draw: {}: {}; {}: {}", word(gl), first, word(other), error.what()));
    }
}

} // namespace rigor

#ifdef RIGOR_SANITIZED
/// Memory that Mesa keeps until the process ends is not a leak of this program. Only Mesa's own
/// libraries are named here.
extern "C" const char* __lsan_default_suppressions();
const char* __lsan_default_suppressions()
{
    return "leak:libOSMesa.so\nleak:libEGL\nleak:libgallium\nleak:swrast_dri.so\n"
           "leak:libglapi.so\nleak:libLLVM";
}
#endif
