// SPDX-License-Identifier: MIT
// Writes a made-up class, to try the grading of one without students:
//
//     build/release/bin/make_class collision 30 submissions
#include "class/made_class.hpp"

#include <cstdio>
#include <exception>
#include <map>
#include <string>

namespace {

using namespace rigor::testing;

int written_class(const std::string& topic, int count, const std::filesystem::path& folder,
                  unsigned seed)
{
    if (count < 1 || count > 9999 || std::filesystem::exists(folder)) {
        std::fprintf(stderr, "expected 1 to 9999 submissions and a folder that is new\n");
        return 2;
    }
    const auto members = made_class(RIGOR_SOURCE_DIR, topic, count, seed);
    write_class(members, topic, folder);
    std::map<std::string, int> kinds;
    for (const ClassMember& member : members)
        ++kinds[member.kind];
    for (const auto& [kind, number] : kinds)
        std::printf("%4d %s\n", number, kind.c_str());
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 4 && argc != 5) {
        std::fprintf(stderr, "usage: make_class TOPIC COUNT FOLDER [SEED]\n");
        return 2;
    }
    try {
        const unsigned seed = argc == 5 ? static_cast<unsigned>(std::stoul(argv[4])) : 1;
        return written_class(argv[1], std::stoi(argv[2]), argv[3], seed);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_class: %s\n", error.what());
        return 2;
    }
}
