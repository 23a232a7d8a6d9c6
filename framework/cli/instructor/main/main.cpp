// SPDX-License-Identifier: MIT
// The program `rigor_class`: the commands for a course. `rigor` starts it for them, so that nobody
// who runs scenes or checks their own files has to build it.
#include "cli/command_line.hpp"
#include "cli/instructor/grade.hpp"
#include "cli/instructor/grade_chunk.hpp"
#include "cli/instructor/release.hpp"

#include <sys/stat.h>

int main(int argc, char** argv)
{
    using namespace rigor;
    static constexpr CommandEntry commands[] = {
        {"grade", "Grade a class: folders and archives", declare_grade},
        {"grade-chunk", "Grade a part of a class (Slurm starts this)", declare_grade_chunk},
        {"release", "Make what students, Gradescope or GitHub get", declare_release},
    };
    // Whatever the umask is, nothing is made that every user may change.
    umask(umask(0) | S_IWOTH);
    return run_command_line(argc, argv, commands);
}
