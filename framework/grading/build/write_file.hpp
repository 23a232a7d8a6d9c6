// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace rigor {

/// Writes a text to a file. @throws std::runtime_error if not all of it could be written, for
/// example when the disk is full
inline void write_file(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close(); // some file systems tell only then that the disk is full
    if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

/// Copies a file to a place where there is none. The library itself would call a full disk an
/// input/output error. @throws std::runtime_error if not all of it could be written
inline void write_copy(const std::filesystem::path& from, const std::filesystem::path& to)
{
    std::error_code error;
    std::filesystem::copy_file(from, to, error);
    if (error) throw std::runtime_error(to.string() + ": cannot be written");
}

} // namespace rigor
