#include "cli/terminal/messages.h"

#include "document/json/utf8.h"

#include <fcntl.h>
#include <unistd.h>

namespace qm {
namespace {

/// The beginning of a long message, which does not end within a character.
std::string shortened(const std::string& message) {
    std::size_t length = 4000;
    if (message.size() <= length) return message;
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80; };
    while (length > 0 && continues(message[length]))
        --length;
    return message.substr(0, length) + " ...";
}

} // namespace

void printMessage(const std::string& message) {
    std::string line = shortened(message);
    const bool readable = isUtf8(line);
    for (char& c : line) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f || (byte > 0x7f && !readable)) c = '?';
    }
    line += '\n';
    // If standard error is closed, the message is lost.
    [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, line.data(), line.size());
}

void openStandardStreams() {
    // Opened in the wrong direction, so that reading and writing fail as on a closed stream.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) == -1)
            while (true) {
                const int opened = open("/dev/null", stream == STDOUT_FILENO ? O_RDONLY : O_WRONLY);
                if (opened < 0 || opened >= stream) break;
            }
}

} // namespace qm
