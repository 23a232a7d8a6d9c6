// SPDX-License-Identifier: MIT
#include "cli/commands/book.hpp"

#include "book/book.hpp"
#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "errors/input_error.hpp"
#include "grading/places.hpp"
#include "grading/process.hpp"
#include "report/write_whole.hpp"

#include <cctype>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <string_view>
#include <system_error>
#include <utility>

namespace rigor {

namespace {

namespace fs = std::filesystem;

// The name of an installed Chromium, or an empty text.
std::string chromium()
{
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
        if (is_installed(name)) return name;
    return {};
}

// A temporary file, which the destructor removes.
class Draft {
public:
    explicit Draft(fs::path file) : file_(std::move(file)) {}
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft()
    {
        std::error_code error;
        fs::remove(file_, error);
    }
    const fs::path& file() const { return file_; }

private:
    fs::path file_;
};

// The URL of a file. Characters such as `#` and spaces are escaped, since they have a meaning in a
// URL.
std::string address(const fs::path& file)
{
    std::string text = "file://";
    for (const unsigned char c : file.string())
        if (std::isalnum(c) != 0 || std::strchr("/._-", c) != nullptr)
            text += static_cast<char>(c);
        else
            text += fmt::format("%{:02X}", c);
    return text;
}

// Prints a page to a PDF with Chromium. If no PDF is made, the error shows the last line that the
// browser has printed.
void print_pdf(const std::string& browser, const std::string& page, const fs::path& pdf)
{
    const Draft paper(pdf.string() + ".html"), printed(pdf.string() + ".new");
    write_whole(paper.file(), page);
    std::string last = "it says nothing";
    Command command;
    command.silence = 300;
    command.arguments = {browser,
                         "--headless",
                         "--no-sandbox",
                         "--disable-gpu",
                         "--no-pdf-header-footer",
                         "--print-to-pdf=" + printed.file().string(),
                         address(paper.file())};
    const Ended ended = run(command, [&last](std::string_view line) {
        if (!line.empty()) last = line;
    });
    std::error_code error;
    if (!ended.ok() || !fs::is_regular_file(printed.file(), error))
        throw InputError(
            fmt::format("{}: expected a PDF from {}, found none: {}", pdf.string(), browser, last));
    fs::rename(printed.file(), pdf, error);
    if (error) throw InputError(pdf.string() + ": cannot be written: " + error.message());
}

int make_book(const std::string& out)
{
    require_folder(out, "the book");
    const fs::path page = fs::absolute(fs::path(out) / "book.html");
    const std::string text = book::book(places().assignments());
    write_whole(page, text);
    fmt::print("{}\n", page.string());
    const std::string browser = chromium();
    if (browser.empty()) {
        fmt::print("no PDF, which needs a Chromium: apt install chromium\n");
        return exit_done;
    }
    const fs::path pdf = fs::absolute(fs::path(out) / "book.pdf");
    print_pdf(browser, book::unfolded(text), pdf);
    fmt::print("{}\n", pdf.string());
    return exit_done;
}

} // namespace

Action declare_book(Options& options)
{
    const auto out = std::make_shared<std::string>();
    options.option("--out", "DIR", *out, "Folder for book.html, and book.pdf with a Chromium");
    options.examples({"book --out book   all handouts as one page, to read or to print"});
    return [out] { return make_book(*out); };
}

} // namespace rigor
