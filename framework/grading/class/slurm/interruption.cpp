// SPDX-License-Identifier: MIT
#include "grading/class/slurm/interruption.hpp"

namespace rigor {

namespace {

volatile std::sig_atomic_t noted_signal = 0;

void note(int signal)
{
    noted_signal = signal;
}

} // namespace

Interruption::Interruption()
{
    noted_signal = 0;
    struct sigaction action = {};
    action.sa_handler = note;
    for (std::size_t i = 0; i < signals.size(); ++i)
        sigaction(signals[i], &action, &before_[i]);
}

Interruption::~Interruption()
{
    for (std::size_t i = 0; i < signals.size(); ++i)
        sigaction(signals[i], &before_[i], nullptr);
    if (is_wanted()) std::raise(noted_signal);
}

bool Interruption::is_wanted() const
{
    return noted_signal != 0;
}

} // namespace rigor
