#include "cli/system/output_file.h"

#include "base/at.h"
#include "cli/system/signals.h"
#include "document/files/files.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace qm {

namespace {

constexpr std::size_t bufferSize = 1 << 16;

[[noreturn]] void refuse(const std::string& name) {
    throw FileError(name, std::string("cannot be written: ") + std::strerror(errno));
}

std::string folderOf(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return ".";
    return slash == 0 ? "/" : path.substr(0, slash);
}

/// The target of a link, which need not exist yet, so that the link itself is not replaced.
/// \throw FileError  if links lead in a circle
std::string followLinks(const std::string& path) {
    constexpr int maxLinks = 40; // as many as Linux follows
    std::filesystem::path target = path;
    for (int links = 0; links <= maxLinks; ++links) {
        std::error_code isNone;
        const std::filesystem::path next = std::filesystem::read_symlink(target, isNone);
        if (isNone) return target.string();
        target = target.parent_path() / next;
    }
    errno = ELOOP;
    refuse(path);
}

struct ProtectedFile {
    std::string path;
    std::string what;
};

std::vector<ProtectedFile>& protectedFiles() {
    static std::vector<ProtectedFile> files;
    return files;
}

mode_t defaultMode() {
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

sigset_t allSignals() {
    sigset_t all;
    sigfillset(&all);
    return all;
}

} // namespace

OutputFile::OutputFile(const std::string& path) : name_(path == "-" ? "standard output" : path) {
    if (path == "-") {
        descriptor_ = STDOUT_FILENO;
        return;
    }
    verifyWritable(path);
    struct stat status {};
    if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
        descriptor_ = open(path.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) refuse(name_);
        return;
    }
    target_ = followLinks(path);
    openBeside();
    const mode_t mode = stat(target_.c_str(), &status) == 0 ? status.st_mode & 07777 : defaultMode();
    fchmod(descriptor_, mode);
}

void OutputFile::openBeside() {
    temporary_ = target_ + ".XXXXXX";
    // A signal that came after making the file and before registering it would leave it behind.
    const BlockedSignals blocked(allSignals());
    descriptor_ = mkostemp(temporary_.data(), O_CLOEXEC);
    if (descriptor_ < 0) refuse(name_);
    try {
        registerTemporaryFile(temporary_);
    } catch (...) {
        discard();
        throw;
    }
}

OutputFile::~OutputFile() {
    discard();
}

void OutputFile::discard() noexcept {
    if (descriptor_ >= 0 && descriptor_ != STDOUT_FILENO) close(descriptor_);
    descriptor_ = -1;
    if (temporary_.empty()) return;
    unlink(temporary_.c_str());
    forgetTemporaryFile(temporary_);
    temporary_.clear();
}

void OutputFile::fail() {
    const int problem = errno;
    discard();
    errno = problem;
    refuse(name_);
}

void OutputFile::write(std::string_view bytes) {
    buffer_ += bytes;
    if (buffer_.size() >= bufferSize) flush();
}

void OutputFile::flush() {
    std::string_view rest = buffer_;
    while (!rest.empty()) {
        const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail();
        rest.remove_prefix(at(count));
    }
    buffer_.clear();
}

void OutputFile::commit() {
    flush();
    // Some file systems report a lack of space only on closing. Standard output itself stays open.
    const int last = descriptor_ == STDOUT_FILENO ? dup(descriptor_) : descriptor_;
    descriptor_ = -1;
    if (last < 0 || close(last) != 0) fail();
    if (target_.empty()) return;
    if (rename(temporary_.c_str(), target_.c_str()) != 0) fail();
    forgetTemporaryFile(temporary_);
    temporary_.clear();
}

void protectFromOutput(const std::string& path, const std::string& what) {
    protectedFiles().push_back({path == "-" ? "/dev/stdin" : path, what});
}

bool isSameFile(const std::string& one, const std::string& other) {
    if (one == other) return true;
    std::error_code problem; // a file that is missing has only its name
    if (std::filesystem::equivalent(one, other, problem)) return true;
    const auto whole = [&](const std::string& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(followLinks(path), problem),
                                                 problem);
    };
    return one != "-" && other != "-" && whole(one) == whole(other);
}

void verifyWritable(const std::string& path) {
    if (path == "-") return;
    struct stat status {};
    if (stat(path.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode)) throw FileError(path, "is a folder", "Name a file");
        if (!S_ISREG(status.st_mode)) return;
        for (const ProtectedFile& file : protectedFiles())
            if (isSameFile(path, file.path)) throw FileError(path, file.what, "Name another file");
    }
    const std::string folder = folderOf(followLinks(path));
    if (access(folder.c_str(), F_OK) != 0)
        throw FileError(path, "cannot be written: there is no folder " + folder, "Make it first");
    if (access(folder.c_str(), W_OK | X_OK) != 0) refuse(path);
}

void writeFile(const std::string& path, std::string_view bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.commit();
}

} // namespace qm
