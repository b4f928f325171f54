#include "cli/system/child_process.h"

#include "base/error.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

extern char** environ; // NOLINT(readability-*): POSIX calls it so, and some systems declare it

namespace qm {
namespace {

constexpr int heldSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU};

/// Starts a program in a process group of its own.
/// \return 0 if there is no such program
/// \throw Error  if it cannot be started for another reason
pid_t start(std::vector<std::string>& words, const sigset_t& signals, const std::string& output) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_APPEND,
                                     0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setsigmask(&attributes, &signals);
    pid_t process = 0;
    const int problem =
        posix_spawnp(&process, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (problem == 0) return process;
    if (problem == ENOENT || problem == EACCES) return 0;
    throw Error(words.front(), std::string("cannot be started: ") + std::strerror(problem));
}

sigset_t heldSet() {
    sigset_t held;
    sigemptyset(&held);
    for (const int signal : heldSignals)
        sigaddset(&held, signal);
    return held;
}

} // namespace

HeldSignals::HeldSignals() : BlockedSignals(heldSet()) {}

bool HeldSignals::oneWaits() {
    sigset_t waiting;
    sigpending(&waiting);
    bool any = false;
    for (const int signal : heldSignals)
        any = any || sigismember(&waiting, signal) == 1;
    return any;
}

TemporaryFolder::TemporaryFolder(const std::string& prefix) {
    std::error_code missing;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(missing);
    if (!missing) path_ = std::filesystem::absolute(parent / (prefix + ".XXXXXX")).string();
    if (missing || mkdtemp(path_.data()) == nullptr)
        throw Error(path_, "no temporary folder can be made", "Set TMPDIR to a folder that can be written");
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

bool runProgram(std::vector<std::string> words, const HeldSignals& signals, const std::string& output,
                std::optional<std::chrono::seconds> patience) {
    using Clock = std::chrono::steady_clock;
    const pid_t process = start(words, signals.before(), output);
    if (process == 0) return false;
    const auto begin = Clock::now();
    while (waitpid(process, nullptr, WNOHANG) == 0) {
        if (HeldSignals::oneWaits() || (patience && Clock::now() - begin > *patience)) {
            kill(-process, SIGKILL);
            waitpid(process, nullptr, 0);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return true;
}

} // namespace qm
