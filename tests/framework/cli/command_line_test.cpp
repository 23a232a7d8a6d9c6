// SPDX-License-Identifier: MIT
// The command line as users see it: exit statuses, and one clear line for every error.
#include "command.hpp"
#include "grading/places.hpp"
#include "report/terminal.hpp"
#include "support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <fstream>
#include <optional>
#include <set>
#include <thread>

namespace rigor::testing {

namespace {

void require_one_line(const std::vector<std::string>& arguments, const std::string& words)
{
    const Run result = rigor(arguments);
    CAPTURE(result.output, words);
    REQUIRE(result.status == 2);
    REQUIRE(result.output.starts_with("rigor: "));
    REQUIRE(std::count(result.output.begin(), result.output.end(), '\n') == 1);
    REQUIRE(result.output.find(words) != std::string::npos);
}

// Stands for another rigor that builds: it holds the lock of the build for a second.
class Builder {
public:
    Builder()
    {
        thread_ = std::jthread([this] {
            std::this_thread::sleep_for(std::chrono::seconds(1));
            lock_.reset();
        });
    }

private:
    std::optional<BuildLock> lock_{std::in_place};
    std::jthread thread_;
};

const std::vector<std::string> names = {"demo",   "test",    "list",  "check", "hint",   "simulate",
                                        "render", "compare", "bench", "book",  "figures"};

} // namespace

TEST_CASE("command line: bad usage is one line and status 2", "[cli]")
{
    require_one_line({"chekc"}, "did you mean \"check\"?");
    require_one_line({"frobnicate"}, "unknown command \"frobnicate\"");
    require_one_line({"--frobnicate"}, "--frobnicate");
    require_one_line({"check", "--frobnicate"}, "--frobnicate");
    require_one_line({"check", "--seed", "minus"}, "--seed");
    require_one_line({"check", "iertia"}, "did you mean \"inertia\"?");
    require_one_line({"check", "--with", "/no/such/folder"}, "/no/such/folder");
    require_one_line({"simulate"}, "SCENE");
    require_one_line({"simulate", "spining_box"}, "did you mean \"spinning_box\"?");
    require_one_line({"simulate", "spinning_box"},
                     "a2-inertia/spinning_box and in a3-rotation/spinning_box");
    require_one_line({"render", "rod_tip"}, "--out");
    require_one_line(
        {"render", "rod_tip", "--with", "reference", "--out", "/tmp/x", "--size", "big"},
        "WIDTHxHEIGHT");
    require_one_line({"bench", "spim"}, "no benchmark \"spim\"; did you mean \"spin\"?");
    require_one_line({"bench", "accuracy", "--out", "/dev/null"}, "expected a folder for plots");
    require_one_line({"hint"}, "TAG");
    require_one_line({"hint", "A4.88"}, "did you mean \"A4.8\"?");
    require_one_line({"hint", "friction"}, "expected the tag of a task, found \"friction\"");
    require_one_line({"hint", "A4.8", "--step", "9"},
                     "--step: expected at most 3 for A4.8, found 9");
    require_one_line({"book"}, "expected --out DIR");
    require_one_line({"book", "--out", "/dev/null"}, "expected a folder");
    require_one_line({"figures"}, "expected --out DIR");
    require_one_line({"figures", "--out", "/dev/null"}, "expected a folder");
    require_one_line({"figures", "--out", "/dev/null/figures"}, "expected a folder");
    require_one_line({"figures", "colision", "--out", "/tmp/x"}, "did you mean \"collision\"?");
    require_one_line({"figures", "A0", "--out", "/tmp/x"}, "expected a handout with figures");
    require_one_line({"test", "fast"}, "one of release, debug, clang, found 'fast'");
    require_one_line({"test", "--quick"}, "go with --stress");
    require_one_line({"test", "--all", "--stress"}, "expected one of");
    require_one_line({"demo", "--size", "big"}, "WIDTHxHEIGHT");
}

TEST_CASE("command line: figures are written all or none", "[cli]")
{
    const TemporaryFolder folder;
    const std::filesystem::path a6 = folder.path() / "a6-plasticity";
    const auto files = [&] {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
            if (!entry.is_directory()) found.push_back(entry.path().filename());
        return found;
    };
    // There is a file where the folder of one handout would be; then the folder is one in which
    // even root cannot write.
    std::ofstream(a6) << "a file";
    require_one_line({"figures", "--out", folder.path()}, "a6-plasticity");
    REQUIRE(files() == std::vector<std::string>{"a6-plasticity"});
    REQUIRE_FALSE(std::filesystem::exists(folder.path() / "a1-kinematics"));
    require_one_line({"figures", "--out", "/proc"}, "/proc");

    std::filesystem::remove(a6);
    REQUIRE(rigor({"figures", "A6", "--out", folder.path()}).status == 0);
    REQUIRE(files().size() == 3);
    REQUIRE(std::filesystem::exists(a6 / "figures/yield_surface.svg"));

    // There is a folder in the place of a figure.
    std::filesystem::remove(a6 / "figures/stretched.svg");
    std::filesystem::create_directory(a6 / "figures/stretched.svg");
    require_one_line({"figures", "A6", "--out", folder.path()}, "stretched.svg: it is a folder");
    REQUIRE(files().size() == 2);
}

TEST_CASE("command line: every benchmark that writes plots takes a folder for them", "[cli]")
{
    std::set<std::string> drawing;
    for (const auto& entry :
         std::filesystem::directory_iterator(RIGOR_SOURCE_DIR "/tests/benchmarks")) {
        std::ifstream in(entry.path() / "main.cpp");
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        if (text.find("plot_folder(") != std::string::npos) drawing.insert(entry.path().filename());
    }
    REQUIRE_FALSE(drawing.empty());
    std::string list;
    for (const std::string& name : drawing)
        list += (list.empty() ? "" : ", ") + name;
    require_one_line({"bench", "spin", "--out", "plots"},
                     "expected a benchmark that draws (" + list + "), found spin");
}

TEST_CASE("command line: an unknown build is one line and status 2 and leaves no folder", "[cli]")
{
    Run result;
    Command launcher;
    launcher.arguments = {std::string(RIGOR_SOURCE_DIR) + "/rigor", "list"};
    launcher.environment = {"RIGOR_PRESET=relaese"};
    const Ended ended =
        run(launcher, [&](std::string_view line) { result.output += std::string(line) + "\n"; });
    REQUIRE(ended.status == 2);
    REQUIRE(result.output ==
            "rigor: RIGOR_PRESET: expected one of release, debug, clang, found 'relaese'\n");
    REQUIRE_FALSE(std::filesystem::exists(places().source / "build/relaese"));
}

TEST_CASE("command line: no command shows the help", "[cli]")
{
    const Run result = rigor({});
    REQUIRE(result.status == 2);
    for (const std::string& name : names)
        REQUIRE(result.output.find("\n  " + name) != std::string::npos);
}

TEST_CASE("command line: every command explains itself with examples", "[cli]")
{
    REQUIRE(rigor({"--help"}).status == 0);
    for (const std::string& name : names) {
        CAPTURE(name);
        const Run help = rigor({name, "--help"});
        REQUIRE(help.status == 0);
        REQUIRE(help.output.find("./rigor " + name) != std::string::npos);
        std::istringstream lines(help.output);
        for (std::string line; std::getline(lines, line);) {
            CAPTURE(line);
            REQUIRE(columns(line) <= 80);
        }
    }
}

TEST_CASE("command line: the list is readable by programs", "[cli]")
{
    const Run result = rigor({"list", "--json"});
    REQUIRE(result.status == 0);
    const nlohmann::json value = nlohmann::json::parse(result.output);
    REQUIRE(value.size() >= 5);
    REQUIRE(value[0]["assignment"] == "a0-pipeline");
    REQUIRE(value[0]["tasks"][0]["formula"] == "kinetic_energy");
}

TEST_CASE("command line: JSON is alone on stdout while another rigor builds", "[cli]")
{
    const char* who = places().has_reference() ? "reference" : "student";
    const Builder other;
    const Run result = rigor({"check", "pipeline", "--with", who, "--json"}, true);
    CAPTURE(result.output);
    REQUIRE(nlohmann::json::parse(result.output)["assignment"] == "a0-pipeline");
}

TEST_CASE("command line: an error is one line after the note that another rigor builds", "[cli]")
{
    const Builder other;
    require_one_line({"figures", "--out", "/proc"}, "/proc");
}

TEST_CASE("command line: a broken scene is named with its line", "[cli]")
{
    const TemporaryFolder folder;
    const auto scene = folder.write("broken.json", "{\n \"gravty\": [0, -9.81, 0]\n}\n");
    require_one_line({"simulate", scene.string()}, "broken.json:2: ");
}

} // namespace rigor::testing
