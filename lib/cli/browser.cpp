#include "cli/browser.h"

#include "base/error.h"
#include "cli/output_file.h"
#include "document/files.h"

#include <array>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

extern char** environ; // NOLINT(readability-*): POSIX calls it so, and some systems declare it

namespace qm {
namespace {

constexpr std::array browsers{"chromium", "chromium-browser", "google-chrome"};
constexpr std::chrono::seconds patience{120};

/// Signals wait until nothing is left behind; the browser is ended at once when one does.
class HeldSignals {
public:
    HeldSignals() {
        sigemptyset(&held_);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
            sigaddset(&held_, signal);
        pthread_sigmask(SIG_BLOCK, &held_, &before_);
    }
    ~HeldSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

    [[nodiscard]] const sigset_t& before() const { return before_; }
    [[nodiscard]] static bool oneWaits() {
        sigset_t waiting;
        sigpending(&waiting);
        bool any = false;
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
            any = any || sigismember(&waiting, signal) == 1;
        return any;
    }

private:
    sigset_t held_;
    sigset_t before_;
};

class TemporaryFolder {
public:
    TemporaryFolder() : path_((std::filesystem::temp_directory_path() / "qm-page.XXXXXX").string()) {
        if (mkdtemp(path_.data()) == nullptr)
            throw Error(path_, "cannot be made", "Set TMPDIR to a folder that can be written");
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] std::string file(const char* name) const { return path_ + "/" + name; }

private:
    std::string path_;
};

/// Starts a program in a process group of its own, mute.
/// \return 0 if there is no such program
pid_t start(std::vector<std::string> words, const sigset_t& signals) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setsigmask(&attributes, &signals);
    pid_t process = 0;
    const int problem =
        posix_spawnp(&process, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return problem == 0 ? process : 0;
}

/// Until the program ends, a signal comes or patience does.
void await(pid_t process) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + patience;
    while (waitpid(process, nullptr, WNOHANG) == 0) {
        if (HeldSignals::oneWaits() || Clock::now() > end) {
            kill(-process, SIGKILL);
            waitpid(process, nullptr, 0);
            return;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

std::vector<std::string> commandLine(const char* browser, const TemporaryFolder& folder, int width,
                                     int height) {
    std::vector<std::string> words = {
        browser, "--headless", "--no-first-run", "--disable-background-networking", "--disable-extensions",
        "--hide-scrollbars", "--force-device-scale-factor=1",
        // Drawn by the processor, so that it looks the same everywhere.
        "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--user-data-dir=" + folder.file("profile"),
        "--window-size=" + std::to_string(width) + "," + std::to_string(height),
        "--screenshot=" + folder.file("picture.png")};
    if (geteuid() == 0) words.emplace_back("--no-sandbox"); // Chromium refuses to start otherwise
    words.push_back("file://" + folder.file("page.html"));
    return words;
}

} // namespace

std::string photographPage(std::string_view page, int width, int height) {
    const HeldSignals signals;
    const TemporaryFolder folder;
    writeFile(folder.file("page.html"), page);
    pid_t process = 0;
    for (const char* browser : browsers)
        if (process == 0) process = start(commandLine(browser, folder, width, height), signals.before());
    if (process == 0)
        throw Error("", "there is no Chromium to take a picture with", "Install Debian's package chromium");
    await(process);
    if (!std::filesystem::exists(folder.file("picture.png")))
        throw Error("", "Chromium has made no picture", "Write the page with -o and open it in a browser");
    return readFile(folder.file("picture.png"));
}

} // namespace qm
