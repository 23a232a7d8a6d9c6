// SPDX-License-Identifier: MIT
#include "class/slurm_cluster.hpp"

#include "grading/process.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <netinet/in.h>
#include <pwd.h>
#include <random>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace rigor::testing {

namespace fs = std::filesystem;

namespace {

// Ports that are free now. All are open at once, so that no two are equal.
std::vector<int> free_ports(int count)
{
    std::vector<int> sockets, ports;
    for (int i = 0; i < count; ++i) {
        sockaddr_in address = {};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        sockets.push_back(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
        auto* plain = reinterpret_cast<sockaddr*>(&address);
        if (bind(sockets.back(), plain, size) != 0 ||
            getsockname(sockets.back(), plain, &size) != 0)
            throw std::runtime_error("expected a free port on the loopback interface");
        ports.push_back(ntohs(address.sin_port));
    }
    for (const int socket : sockets)
        close(socket);
    return ports;
}

std::string host_name()
{
    char name[256] = {};
    gethostname(name, sizeof name - 1);
    return std::string(name).substr(0, std::string(name).find('.'));
}

std::string user_name()
{
    const passwd* user = getpwuid(geteuid());
    return user ? user->pw_name : "root";
}

std::string text_of(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// The processes that were started with a variable in their environment, and live.
std::vector<pid_t> processes_with(const std::string& variable)
{
    std::vector<pid_t> found;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        const std::string name = entry.path().filename().string();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        const std::string environment = '\0' + text_of(entry.path() / "environ");
        if (environment.find('\0' + variable + '\0') != std::string::npos)
            found.push_back(std::stoi(name));
    }
    return found;
}

pid_t parent_of(pid_t process)
{
    const std::string text = text_of(fmt::format("/proc/{}/stat", process));
    const std::size_t name_end = text.rfind(')');
    return name_end == std::string::npos ? 0 : std::stoi(text.substr(name_end + 4));
}

bool wait_until(const std::function<bool()>& is_so, std::chrono::seconds longest)
{
    const auto start = std::chrono::steady_clock::now();
    while (!is_so()) {
        if (std::chrono::steady_clock::now() - start > longest) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return true;
}

std::string program_named(const std::string& name)
{
    for (const char* folder : {"/usr/sbin/", "/usr/bin/", "/usr/local/sbin/", "/usr/local/bin/"})
        if (access((folder + name).c_str(), X_OK) == 0) return folder + name;
    return "";
}

} // namespace

bool SlurmCluster::is_possible()
{
    for (const char* name : {"munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel"})
        if (program_named(name).empty()) return false;
    return true;
}

SlurmCluster::SlurmCluster()
    : configuration_("SLURM_CONF=" + (folder_.path() / "slurm.conf").string())
{
    prctl(PR_SET_CHILD_SUBREAPER, 1); // what a daemon leaves behind becomes a child of this process
    write_configuration();
    setenv("SLURM_CONF", (folder_.path() / "slurm.conf").c_str(), 1);
    const fs::path& place = folder_.path();
    start({program_named("munged"), "--foreground", "--force",
           "--key-file=" + (place / "key").string(), "--socket=" + (place / "socket").string(),
           "--pid-file=" + (place / "munged.pid").string(),
           "--log-file=" + (place / "munged.log").string(),
           "--seed-file=" + (place / "seed").string()},
          "munged");
    if (!wait_until([&] { return fs::exists(place / "socket"); }, std::chrono::seconds(20)))
        throw std::runtime_error("munged does not start: " + last_words());
    controller_ = start({program_named("slurmctld"), "-D", "-i"}, "slurmctld");
    for (int node = 1; node <= nodes; ++node)
        node_daemons_[node - 1] =
            start({program_named("slurmd"), "-D", "-N", fmt::format("n{}", node)},
                  fmt::format("slurmd{}", node));
    if (wait_until([&] { return all_are_idle(); }, std::chrono::seconds(60))) return;
    const std::string words = last_words();
    end_all();
    throw std::runtime_error("the nodes do not become idle: " + words);
}

SlurmCluster::~SlurmCluster()
{
    end_all();
    unsetenv("SLURM_CONF");
    prctl(PR_SET_CHILD_SUBREAPER, 0);
}

void SlurmCluster::write_configuration() const
{
    const fs::path& place = folder_.path();
    std::string key(128, '\0');
    std::random_device random;
    for (char& c : key)
        c = static_cast<char>(random());
    fs::permissions(folder_.write("key", key), fs::perms::owner_read);
    fs::permissions(place, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                               fs::perms::others_read | fs::perms::others_exec);
    fs::create_directories(place / "state");
    const std::vector<int> ports = free_ports(1 + nodes);
    std::string text = fmt::format("ClusterName=trial\n"
                                   "SlurmctldHost={0}(127.0.0.1)\n"
                                   "SlurmUser={1}\nSlurmdUser={1}\n"
                                   "AuthType=auth/munge\nCryptoType=crypto/munge\n"
                                   "AuthInfo=socket={2}/socket,cred_expire=5\n"
                                   "SlurmctldPort={3}\n"
                                   "SlurmctldPidFile={2}/slurmctld.pid\n"
                                   "SlurmdPidFile={2}/%n.pid\nSlurmdSpoolDir={2}/spool_%n\n"
                                   "StateSaveLocation={2}/state\n"
                                   "ProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\n"
                                   "SelectType=select/cons_tres\nSelectTypeParameters=CR_CPU\n"
                                   "SchedulerParameters=sched_interval=1,bf_interval=1,"
                                   "sched_min_interval=20000\n"
                                   "MpiDefault=none\nSwitchType=switch/none\n"
                                   "SlurmdTimeout=5\nReturnToService=2\nJobRequeue=1\n",
                                   host_name(), user_name(), place.string(), ports[0]);
    for (int node = 1; node <= nodes; ++node) {
        fs::create_directories(place / fmt::format("spool_n{}", node));
        text += fmt::format("NodeName=n{} NodeHostname={} NodeAddr=127.0.0.1 Port={} CPUs=1 "
                            "State=UNKNOWN\n",
                            node, host_name(), ports[node]);
    }
    text += "PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n";
    folder_.write("slurm.conf", text);
}

pid_t SlurmCluster::start(const std::vector<std::string>& arguments, const std::string& log)
{
    const std::string file = (folder_.path() / (log + ".out")).string();
    std::vector<char*> pointers;
    for (const std::string& argument : arguments)
        pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    const pid_t process = fork();
    if (process == 0) {
        setpgid(0, 0);
        const int out = open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
        dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
        dup2(out, STDOUT_FILENO);
        dup2(out, STDERR_FILENO);
        execv(pointers[0], pointers.data());
        _exit(127);
    }
    if (process < 0) throw std::runtime_error("fork");
    daemons_.push_back(process);
    return process;
}

bool SlurmCluster::all_are_idle() const
{
    int idle = 0;
    Command command;
    command.arguments = {program_named("sinfo"), "--noheader", "--Node", "--format=%T"};
    run(command, [&](std::string_view line) { idle += line == "idle"; });
    return idle == nodes;
}

std::string SlurmCluster::last_words() const
{
    std::string words;
    for (const auto& entry : fs::directory_iterator(folder_.path()))
        if (entry.path().extension() == ".out") {
            std::string text = text_of(entry.path());
            while (text.ends_with('\n'))
                text.pop_back();
            words += entry.path().stem().string() + ": " + text.substr(text.rfind('\n') + 1) + "; ";
        }
    return words;
}

std::vector<pid_t> SlurmCluster::processes() const
{
    std::vector<pid_t> all = processes_with(configuration_);
    std::erase(all, getpid());
    return all;
}

// What runs on a node knows its name; above it is the daemon that looks after the task.
std::vector<pid_t> SlurmCluster::tasks_on(int node) const
{
    const std::vector<pid_t> ours = processes();
    std::vector<pid_t> found;
    for (const pid_t process : processes_with(fmt::format("SLURMD_NODENAME=n{}", node))) {
        if (std::find(ours.begin(), ours.end(), process) == ours.end()) continue;
        found.push_back(process);
        const pid_t parent = parent_of(process);
        if (text_of(fmt::format("/proc/{}/comm", parent)) == "slurmstepd\n")
            found.push_back(parent);
    }
    return found;
}

bool SlurmCluster::is_busy(int node) const
{
    return !tasks_on(node).empty();
}

void SlurmCluster::lose(int node)
{
    // The daemon first, so that it tells nobody about the others.
    kill(node_daemons_[node - 1], SIGKILL);
    const std::vector<pid_t> tasks = tasks_on(node);
    for (const pid_t process : tasks)
        if (text_of(fmt::format("/proc/{}/comm", process)) == "slurmstepd\n")
            kill(process, SIGKILL);
    for (const pid_t process : tasks)
        kill(process, SIGKILL);
}

void SlurmCluster::stop_controller()
{
    kill(controller_, SIGKILL);
}

void SlurmCluster::end_all()
{
    for (const pid_t process : daemons_)
        kill(process, SIGKILL);
    wait_until(
        [&] {
            const std::vector<pid_t> left = processes();
            for (const pid_t process : left)
                kill(process, SIGKILL);
            for (const pid_t process : left)
                waitpid(process, nullptr, WNOHANG); // those that are no children are init's
            return left.empty();
        },
        std::chrono::seconds(10));
    for (const pid_t process : daemons_)
        waitpid(process, nullptr, 0);
    daemons_.clear();
}

} // namespace rigor::testing
