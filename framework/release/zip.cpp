// SPDX-License-Identifier: MIT
#include "release/zip.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <array>
#include <memory>
#include <stdexcept>

namespace rigor {

namespace {

using Entry = std::unique_ptr<archive_entry, decltype(&archive_entry_free)>;
using Reader = std::unique_ptr<archive, decltype(&archive_read_free)>;
using Writer = std::unique_ptr<archive, decltype(&archive_write_free)>;

// The date of every file in the archive: 2000-01-01 [s since 1970].
constexpr la_int64_t fixed_date = 946684800;

la_ssize_t append(archive*, void* text, const void* bytes, std::size_t size)
{
    static_cast<std::string*>(text)->append(static_cast<const char*>(bytes), size);
    return static_cast<la_ssize_t>(size);
}

} // namespace

std::string zip_of(const ReleasedTree& tree)
{
    std::string bytes;
    const Writer writer(archive_write_new(), archive_write_free);
    archive* out = writer.get();
    archive_write_set_format_zip(out);
    archive_write_set_bytes_in_last_block(out, 1);
    const auto check = [out](la_ssize_t status) {
        if (status < ARCHIVE_OK) throw std::runtime_error(archive_error_string(out));
    };
    check(archive_write_open(out, &bytes, nullptr, append, nullptr));
    for (const ReleasedFile& file : tree) {
        const Entry entry(archive_entry_new(), archive_entry_free);
        archive_entry_set_pathname(entry.get(), file.path.c_str());
        archive_entry_set_filetype(entry.get(), AE_IFREG);
        archive_entry_set_perm(entry.get(), file.is_executable ? 0755 : 0644);
        archive_entry_set_size(entry.get(), static_cast<la_int64_t>(file.content.size()));
        archive_entry_set_mtime(entry.get(), fixed_date, 0);
        check(archive_write_header(out, entry.get()));
        check(archive_write_data(out, file.content.data(), file.content.size()));
    }
    check(archive_write_close(out));
    return bytes;
}

ReleasedTree unzipped(const std::filesystem::path& file)
{
    const Reader reader(archive_read_new(), archive_read_free);
    archive* in = reader.get();
    archive_read_support_format_zip(in);
    if (archive_read_open_filename(in, file.c_str(), 1 << 16) != ARCHIVE_OK)
        throw std::runtime_error(file.string() + ": " + archive_error_string(in));
    ReleasedTree tree;
    archive_entry* entry = nullptr;
    int status = ARCHIVE_OK;
    while ((status = archive_read_next_header(in, &entry)) == ARCHIVE_OK) {
        ReleasedFile found{archive_entry_pathname(entry), "",
                           (archive_entry_perm(entry) & 0100) != 0};
        std::array<char, 65536> block;
        la_ssize_t n = 0;
        while ((n = archive_read_data(in, block.data(), block.size())) > 0)
            found.content.append(block.data(), static_cast<std::size_t>(n));
        if (n < 0) throw std::runtime_error(file.string() + ": " + archive_error_string(in));
        add_file(tree, std::move(found));
    }
    if (status != ARCHIVE_EOF)
        throw std::runtime_error(file.string() + ": " + archive_error_string(in));
    return tree;
}

} // namespace rigor
