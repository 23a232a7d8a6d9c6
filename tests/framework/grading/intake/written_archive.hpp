// SPDX-License-Identifier: MIT
// Archives for tests, good ones and bad ones, written by libarchive.
#pragma once

#include <archive.h>
#include <archive_entry.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigor::testing {

struct ArchiveEntry {
    std::string name, text;
    unsigned kind = AE_IFREG;
    std::string link = {};      // target of a symbolic link
    std::string hard_link = {}; // target of a hard link
};

enum class ArchiveFormat { zip, zip_gz, tar, tar_gz, tar_xz, tar_zst };

inline void add_entry(archive* out, const ArchiveEntry& entry)
{
    archive_entry* written = archive_entry_new();
    archive_entry_set_pathname(written, entry.name.c_str());
    archive_entry_set_filetype(written, entry.kind);
    archive_entry_set_perm(written, 0644);
    archive_entry_set_size(written, static_cast<la_int64_t>(entry.text.size()));
    if (!entry.link.empty()) archive_entry_set_symlink(written, entry.link.c_str());
    if (!entry.hard_link.empty()) archive_entry_set_hardlink(written, entry.hard_link.c_str());
    const bool ok = archive_write_header(out, written) == ARCHIVE_OK &&
                    archive_write_data(out, entry.text.data(), entry.text.size()) >= la_ssize_t{0};
    archive_entry_free(written);
    if (!ok) throw std::runtime_error(archive_error_string(out));
}

inline std::filesystem::path write_archive(const std::filesystem::path& file, ArchiveFormat format,
                                           const std::vector<ArchiveEntry>& entries)
{
    archive* out = archive_write_new();
    if (format == ArchiveFormat::zip || format == ArchiveFormat::zip_gz)
        archive_write_set_format_zip(out);
    else
        archive_write_set_format_gnutar(out);
    if (format == ArchiveFormat::tar_gz || format == ArchiveFormat::zip_gz)
        archive_write_add_filter_gzip(out);
    if (format == ArchiveFormat::tar_xz) archive_write_add_filter_xz(out);
    if (format == ArchiveFormat::tar_zst) archive_write_add_filter_zstd(out);
    if (archive_write_open_filename(out, file.c_str()) != ARCHIVE_OK)
        throw std::runtime_error(archive_error_string(out));
    for (const ArchiveEntry& entry : entries)
        add_entry(out, entry);
    archive_write_close(out);
    archive_write_free(out);
    return file;
}

} // namespace rigor::testing
