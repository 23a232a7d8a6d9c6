// SPDX-License-Identifier: MIT
// A Slurm cluster on this machine alone: munged with its own key and socket, one controller and
// three nodes, which talk over the loopback interface. Everything that it starts ends with it.
#pragma once

#include "support/temporary_folder.hpp"

#include <string>
#include <sys/types.h>
#include <vector>

namespace rigor::testing {

class SlurmCluster {
public:
    /// Whether Slurm and munge are installed: the packages slurm-wlm and munge.
    static bool is_possible();

    /// Starts the daemons and waits until all nodes are idle. From here on this process and those
    /// that it starts use this cluster. @throws std::runtime_error with the last words of a daemon
    SlurmCluster();
    ~SlurmCluster();
    SlurmCluster(const SlurmCluster&) = delete;
    SlurmCluster& operator=(const SlurmCluster&) = delete;

    static constexpr int nodes = 3;
    /// Whether a task runs on a node, from 1 on.
    bool is_busy(int node) const;
    /// Ends a node as if its power was cut: its daemon, and all that runs there.
    void lose(int node);
    void stop_controller();

    /// Processes that belong to the cluster: its daemons, and what runs on its nodes.
    std::vector<pid_t> processes() const;

private:
    pid_t start(const std::vector<std::string>& arguments, const std::string& log);
    void write_configuration() const;
    bool all_are_idle() const;
    std::string last_words() const;
    void end_all();
    std::vector<pid_t> tasks_on(int node) const;

    TemporaryFolder folder_;
    std::string configuration_; // "SLURM_CONF=…": marks all processes of the cluster
    std::vector<pid_t> daemons_;
    pid_t controller_ = -1;
    pid_t node_daemons_[nodes] = {};
};

} // namespace rigor::testing
