// SPDX-License-Identifier: MIT
// Deformable solids: error against run time for both integrators; time and memory of a step by
// stage, with 50 000 tetrahedra; the time saved by skipping eigenvalues; conservation under
// fragmentation; ten minutes of violent deformation. The global operator new is replaced to count
// allocations.
#include "parts.hpp"
#include "support/bench/plot.hpp"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <new>

namespace {

std::size_t allocations = 0, bytes = 0;
constexpr std::size_t header = 16; // stores the size and keeps the alignment [bytes]

} // namespace

void* operator new(std::size_t size)
{
    void* block = std::malloc(size + header);
    if (!block) throw std::bad_alloc();
    *static_cast<std::size_t*>(block) = size;
    ++allocations;
    bytes += size;
    return static_cast<char*>(block) + header;
}

void operator delete(void* pointer) noexcept
{
    if (!pointer) return;
    void* block = static_cast<char*>(pointer) - header;
    bytes -= *static_cast<std::size_t*>(block);
    std::free(block);
}

void operator delete(void* pointer, std::size_t) noexcept
{
    operator delete(pointer);
}

namespace rigor {

Heap heap()
{
    return {allocations, bytes};
}

double thread_seconds()
{
    timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace rigor

namespace {

// Whether a part is to run. `--only PART` selects a single one.
bool wants(int argc, char** argv, const std::string& part)
{
    for (int i = 1; i + 1 < argc; ++i)
        if (std::string(argv[i]) == "--only") return argv[i + 1] == part;
    return true;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        rigor::Bench bench("deformable");
        if (wants(argc, argv, "accuracy"))
            rigor::measure_accuracy(bench, rigor::plot_folder(argc, argv));
        if (wants(argc, argv, "speed")) rigor::measure_speed(bench);
        if (wants(argc, argv, "fragments")) rigor::measure_fragments(bench);
        if (wants(argc, argv, "abuse")) rigor::measure_abuse(bench);
        return bench.finish(rigor::wants_json(argc, argv));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
