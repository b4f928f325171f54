#include "cli/messages.h"

#include "document/utf8.h"

#include <fcntl.h>
#include <unistd.h>

namespace qm {

void printMessage(const std::string& message) {
    constexpr std::size_t longest = 4000;
    std::string line = message.size() <= longest ? message : message.substr(0, longest) + " ...";
    const bool readable = isUtf8(line);
    for (char& c : line) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f || (byte > 0x7f && !readable)) c = '?';
    }
    line += '\n';
    // Where standard error is closed there is nobody to tell.
    [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, line.data(), line.size());
}

void openStandardStreams() {
    // Opened the wrong way round, so that reading and writing fail as they would have.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) == -1)
            while (true) {
                const int opened = open("/dev/null", stream == STDOUT_FILENO ? O_RDONLY : O_WRONLY);
                if (opened < 0 || opened >= stream) break;
            }
}

} // namespace qm
