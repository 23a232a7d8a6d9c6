// SPDX-License-Identifier: MIT
// The program `unpack`: reads the archive that is its stdin, and prints what is in it. It runs in a
// sandbox, since the library that reads archives processes untrusted bytes.
//
//     unpack LIMIT...    see `arguments_of` in unpacked.hpp
#include "grading/intake/archive.hpp"
#include "grading/intake/refused.hpp"
#include "grading/intake/unpacked.hpp"

#include <cstdio>
#include <exception>
#include <unistd.h>

namespace {

std::string unpack(const std::vector<std::string>& arguments)
{
    using namespace rigor;
    try {
        return printed(read_archive(STDIN_FILENO, limits_of(arguments)));
    } catch (const Refused& refused) {
        return printed_refusal(refused.what());
    }
}

} // namespace

int main(int count, char** arguments)
{
    try {
        const std::string text = unpack({arguments + 1, arguments + count});
        const bool is_written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
        return is_written && std::fflush(stdout) == 0 ? 0 : 1;
    } catch (const std::exception&) {
        return 1;
    }
}
