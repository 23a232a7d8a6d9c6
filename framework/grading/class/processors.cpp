// SPDX-License-Identifier: MIT
#include "grading/class/processors.hpp"

#include "grading/machine/allotment.hpp"

#include <sched.h>
#include <unistd.h>

namespace rigor {

Processors::Processors() : Processors(allowed_processors())
{
    // Several runs on one machine begin with different processors.
    if (!all_.empty()) next_ = static_cast<std::size_t>(getpid()) % all_.size();
}

Processors::Processors(const std::vector<int>& numbers)
{
    for (const int number : numbers)
        all_.push_back({number});
}

int Processors::take()
{
    if (all_.empty()) return -1;
    std::size_t best = next_;
    for (std::size_t i = 0; i < all_.size(); ++i) {
        const std::size_t at = (next_ + i) % all_.size();
        if (all_[at].jobs < all_[best].jobs) best = at;
    }
    ++all_[best].jobs;
    next_ = (best + 1) % all_.size();
    return all_[best].number;
}

void Processors::give_back(int number)
{
    for (Processor& one : all_)
        if (one.number == number && one.jobs > 0) --one.jobs;
}

void keep_to(int processor)
{
    if (processor < 0) return;
    cpu_set_t only[16] = {};
    CPU_SET_S(processor, sizeof only, only);
    sched_setaffinity(0, sizeof only, only); // an error is ignored: it only costs time
}

} // namespace rigor
