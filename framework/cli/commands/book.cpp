// SPDX-License-Identifier: MIT
#include "cli/commands/book.hpp"

#include "book/book.hpp"
#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "grading/places.hpp"
#include "grading/process.hpp"
#include "report/write_whole.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <stdexcept>

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

// Prints the page with a Chromium. What the browser says is shown only if it makes no PDF.
void print_pdf(const std::string& browser, const fs::path& page, const fs::path& pdf)
{
    std::string said;
    Command command;
    command.arguments = {browser,
                         "--headless",
                         "--no-sandbox",
                         "--disable-gpu",
                         "--print-to-pdf=" + pdf.string(),
                         "file://" + page.string()};
    const Ended ended = run(command, [&said](std::string_view line) {
        said += line;
        said += '\n';
    });
    if (!ended.ok()) throw std::runtime_error(browser + " made no PDF:\n" + said);
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
    const fs::path paper = page.string() + ".paper.html";
    write_whole(paper, book::unfolded(text));
    print_pdf(browser, paper, pdf);
    fs::remove(paper);
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
