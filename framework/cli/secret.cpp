// SPDX-License-Identifier: MIT
#include "cli/secret.hpp"

#include "errors/input_error.hpp"
#include "errors/quotes.hpp"

#include <fmt/format.h>
#include <fstream>

namespace rigor {

namespace {

// Sixteen random letters cannot be guessed. A secret has no use for more than 4096 bytes: a larger
// file was probably named by mistake.
constexpr std::size_t shortest = 16, longest = 4096; // [bytes]

} // namespace

std::string secret_in(const std::string& file)
{
    if (file.empty()) return "";
    std::ifstream in(file, std::ios::binary);
    std::string text(longest + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (in.bad() || (in.gcount() == 0 && !in.eof()))
        throw InputError("--secret: expected a file, found none that can be read: " +
                         in_quotes(file));
    text.resize(static_cast<std::size_t>(in.gcount()));
    if (text.size() > longest)
        throw InputError(fmt::format("--secret: expected at most {} bytes, found more", longest));
    while (text.ends_with('\n') || text.ends_with('\r'))
        text.pop_back();
    if (text.size() < shortest)
        throw InputError(fmt::format("--secret: expected at least {} bytes, found {}: a short "
                                     "secret can be guessed",
                                     shortest, text.size()));
    return text;
}

} // namespace rigor
