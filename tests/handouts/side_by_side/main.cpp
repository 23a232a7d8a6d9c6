// SPDX-License-Identifier: MIT
// Joins two pictures of one size: the first on the left, the second on the right.
#include "render/png.hpp"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace {

using rigor::Image;

Image loaded(const std::string& file)
{
    Image image;
    int channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load(file.c_str(), &image.width, &image.height, &channels, 4), &stbi_image_free);
    if (!pixels) throw std::runtime_error(file + ": expected a picture");
    image.rgba.assign(pixels.get(), pixels.get() + 4UL * image.width * image.height);
    return image;
}

// White columns between the pictures [px].
constexpr int gap = 6;

Image side_by_side(const Image& left, const Image& right)
{
    if (left.height != right.height) throw std::runtime_error("expected pictures of one height");
    Image both;
    both.width = left.width + gap + right.width;
    both.height = left.height;
    for (int y = 0; y < both.height; ++y) {
        both.rgba.insert(both.rgba.end(), left.pixel(0, y), left.pixel(0, y) + 4 * left.width);
        both.rgba.insert(both.rgba.end(), 4 * gap, 255);
        both.rgba.insert(both.rgba.end(), right.pixel(0, y), right.pixel(0, y) + 4 * right.width);
    }
    return both;
}

} // namespace

int main(int count, char** values)
{
    try {
        if (count != 4) throw std::runtime_error("usage: side_by_side LEFT RIGHT OUT");
        const Image both = side_by_side(loaded(values[1]), loaded(values[2]));
        rigor::write_picture(values[3], rigor::png_bytes(both));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
