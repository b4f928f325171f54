#include "document/files/files.h"

#include "base/at.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace qm {

namespace {

/// Far above the size of any real mesh, and small enough that an endless stream does not exhaust memory.
constexpr std::size_t maxBytes = std::size_t{4} << 30;

class Descriptor {
public:
    explicit Descriptor(const std::string& path)
        : number_(path == "-" ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC)),
          owned_(path != "-") {}
    ~Descriptor() {
        if (owned_ && number_ >= 0) close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int number() const { return number_; }

private:
    int number_;
    bool owned_;
};

} // namespace

std::string displayName(const std::string& path) {
    return path == "-" ? "standard input" : path;
}

bool isRegularFile(const std::string& path) {
    struct stat status {};
    return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

std::string readFile(const std::string& path) {
    const std::string name = displayName(path);
    const Descriptor file(path);
    struct stat status {};
    if (file.number() < 0 || fstat(file.number(), &status) != 0)
        throw FileError(name, std::string("cannot be read: ") + std::strerror(errno));
    if (S_ISDIR(status.st_mode)) throw FileError(name, "is a folder", "Name a file");
    if (path != "-" && (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)))
        throw FileError(name, "is a device", "Name a file");

    std::string bytes;
    std::size_t used = 0;
    if (S_ISREG(status.st_mode) && status.st_size > 0 && at(status.st_size) <= maxBytes)
        bytes.resize(at(status.st_size) + 1); // one more byte, so that a single read meets the end
    while (true) {
        if (used == bytes.size()) bytes.resize(std::max<std::size_t>(2 * used, 1 << 16));
        const ssize_t count = read(file.number(), bytes.data() + used, bytes.size() - used);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw FileError(name, std::string("cannot be read: ") + std::strerror(errno));
        if (count == 0) break;
        used += at(count);
        if (used > maxBytes) throw FileError(name, "is larger than 4 GiB");
    }
    bytes.resize(used);
    return bytes;
}

} // namespace qm
