// SPDX-License-Identifier: MIT
// Reads archives by libarchive. Every byte of every file is read and counted, so that a damaged
// file is found. An archive that passes a limit is refused at once, not read to its end. Only
// compressions that libarchive has built in are allowed, since it would start a program for any
// other; and an archive may not be compressed twice.
#include "grading/intake/archive.hpp"

#include "errors/printable.hpp"
#include "errors/quotes.hpp"
#include "grading/intake/refused.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <array>
#include <clocale>
#include <fmt/format.h>
#include <memory>
#include <sys/stat.h>

namespace rigor {

namespace {

constexpr std::array<std::string_view, 14> archive_endings = {
    ".tar.gz", ".tar.bz2", ".tar.xz", ".tar.zst", ".tar.lz", ".tgz", ".tbz2",
    ".txz",    ".tar",     ".zip",    ".rar",     ".7z",     ".gz",  ".xz"};

// libarchive converts names by the locale of the thread, which is UTF-8 while this object lives.
class Utf8Locale {
public:
    Utf8Locale()
        : utf8_(newlocale(LC_CTYPE_MASK, "C.UTF-8", static_cast<locale_t>(nullptr))),
          before_(uselocale(utf8_))
    {
    }
    ~Utf8Locale()
    {
        uselocale(before_);
        if (utf8_) freelocale(utf8_);
    }
    Utf8Locale(const Utf8Locale&) = delete;
    Utf8Locale& operator=(const Utf8Locale&) = delete;

private:
    locale_t utf8_, before_;
};

std::size_t size_of_file(int descriptor)
{
    struct stat status = {};
    if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode))
        throw Refused("expected a folder or an archive, found neither");
    return static_cast<std::size_t>(status.st_size);
}

// What an entry of an archive is if it is neither a file nor a folder; otherwise empty.
std::string_view forbidden_kind(archive_entry* entry)
{
    if (archive_entry_hardlink(entry)) return "a hard link";
    switch (archive_entry_filetype(entry)) {
    case AE_IFLNK:
        return "a link";
    case AE_IFIFO:
        return "a pipe";
    case AE_IFSOCK:
        return "a socket";
    case AE_IFCHR:
    case AE_IFBLK:
        return "a device";
    default:
        return "";
    }
}

class ArchiveReader {
public:
    ArchiveReader(int descriptor, const IntakeLimits& limits)
        : size_(size_of_file(descriptor)), limits_(limits),
          archive_(archive_read_new(), archive_read_free), contents_(limits)
    {
        if (size_ > limits_.archive_bytes)
            throw Refused(fmt::format("expected an archive of at most {} MB, found {} MB",
                                      limits_.archive_bytes >> 20, size_ >> 20));
        archive* a = archive_.get();
        archive_read_support_filter_gzip(a);
        archive_read_support_filter_bzip2(a);
        archive_read_support_filter_xz(a);
        archive_read_support_filter_zstd(a);
        archive_read_support_format_tar(a);
        archive_read_support_format_zip(a);
        if (archive_read_open_fd(a, descriptor, 65536) != ARCHIVE_OK) break_off();
        if (archive_filter_count(a) > 2) // one filter is the compression, one the plain file
            refuse_compressed_again();
    }

    Contents read()
    {
        bool any = false;
        for (archive_entry* entry = nullptr; has_next(entry); any = true)
            take(entry);
        if (!any) throw Refused("expected an archive with files, found it empty");
        return std::move(contents_);
    }

private:
    bool has_next(archive_entry*& entry)
    {
        const int state = archive_read_next_header(archive_.get(), &entry);
        if (state != ARCHIVE_OK && state != ARCHIVE_WARN && state != ARCHIVE_EOF) break_off();
        // The sizes that a .zip states can be checked only if the file itself is the .zip, not
        // compressed again.
        const bool is_zip =
            (archive_format(archive_.get()) & ARCHIVE_FORMAT_BASE_MASK) == ARCHIVE_FORMAT_ZIP;
        if (is_zip && archive_filter_count(archive_.get()) > 1) refuse_compressed_again();
        return state != ARCHIVE_EOF;
    }

    void take(archive_entry* entry)
    {
        const char* raw = archive_entry_pathname(entry);
        if (!raw) throw Refused("expected names in UTF-8, found one that is not");
        const std::string name = contents_.add_name(raw);
        if (const std::string_view kind = forbidden_kind(entry); !kind.empty())
            throw Refused(
                fmt::format("expected files and folders, found {}, {}", kind, in_quotes(raw)));
        if (archive_entry_is_encrypted(entry))
            throw Refused("expected an archive without a password, found " + in_quotes(raw) +
                          " encrypted");
        if (archive_entry_filetype(entry) == AE_IFDIR) return;
        std::string text = content_of(name, entry);
        if (std::string_view(raw).ends_with('\\')) return; // a folder, in a Windows archive
        if (is_source(name))
            contents_.add_source(name, std::move(text));
        else
            contents_.add_other(name);
    }

    // The text of the current entry if it is a source. The bytes of other files are only counted,
    // and the result is empty. A sparse file counts with its gaps, which take space where it is
    // unpacked, but have no bytes in the archive.
    std::string content_of(const std::string& name, archive_entry* entry)
    {
        std::string text;
        const bool is_kept = is_source(name);
        const la_int64_t stated = archive_entry_size_is_set(entry) ? archive_entry_size(entry) : 0;
        std::size_t end = 0; // where the counted part of the file ends [bytes]
        const auto count_up_to = [&](la_int64_t place) {
            if (place < 0) throw Refused("expected plain files, found " + in_quotes(name));
            const std::size_t next = std::max(end, static_cast<std::size_t>(place));
            count(next - end);
            end = next;
        };
        count_up_to(stated);
        for (;;) {
            const void* block = nullptr;
            std::size_t size = 0;
            la_int64_t offset = 0;
            const int state = archive_read_data_block(archive_.get(), &block, &size, &offset);
            if (state == ARCHIVE_EOF) break;
            if (state != ARCHIVE_OK) break_off();
            count_up_to(offset);
            count_up_to(offset + static_cast<la_int64_t>(size));
            if (!is_kept) continue;
            if (offset != static_cast<la_int64_t>(text.size())) refuse_gaps(name);
            text.append(static_cast<const char*>(block), size);
        }
        if (is_kept && text.size() != end) refuse_gaps(name);
        return text;
    }

    [[noreturn]] static void refuse_gaps(const std::string& name)
    {
        throw Refused("expected plain files, found " + in_quotes(name) + " with gaps");
    }

    void count(std::size_t size)
    {
        unpacked_ += size;
        if (unpacked_ > limits_.unpacked_bytes)
            throw Refused(fmt::format("expected an archive that unpacks to at most {} MB, "
                                      "found more",
                                      limits_.unpacked_bytes >> 20));
        if (unpacked_ > limits_.bytes_at_any_ratio && unpacked_ / limits_.unpacked_ratio > size_)
            throw Refused(fmt::format("expected an archive that unpacks to at most {} times its "
                                      "size, found more",
                                      limits_.unpacked_ratio));
    }

    [[noreturn]] static void refuse_compressed_again()
    {
        throw Refused("expected an archive that is compressed once, found it compressed again");
    }

    [[noreturn]] void break_off() const
    {
        const char* reason = archive_error_string(archive_.get());
        std::string words = printable(reason ? reason : "no reason given");
        std::replace(words.begin(), words.end(), '\n', ' ');
        throw Refused("expected a whole .zip or .tar archive, found one that cannot be read: " +
                      words);
    }

    Utf8Locale locale_;
    std::size_t size_; // the archive's length [bytes]
    IntakeLimits limits_;
    std::unique_ptr<archive, int (*)(archive*)> archive_;
    Contents contents_;
    std::size_t unpacked_ = 0;
};

} // namespace

bool is_archive_name(std::string_view name)
{
    return without_archive_ending(name).size() < name.size();
}

std::string without_archive_ending(std::string_view name)
{
    std::string lower(name);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const std::string_view ending : archive_endings)
        if (lower.size() > ending.size() && lower.ends_with(ending))
            return std::string(name.substr(0, name.size() - ending.size()));
    return std::string(name);
}

Contents read_archive(int descriptor, const IntakeLimits& limits)
{
    return ArchiveReader(descriptor, limits).read();
}

} // namespace rigor
