#include "cli/system/browser.h"

#include "base/error.h"
#include "cli/system/child_process.h"
#include "cli/system/output_file.h"
#include "document/files/files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <unistd.h>

namespace qm {
namespace {

/// The first one shows nothing but pages without a window, and needs half the time.
constexpr std::array browsers{"chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"};
constexpr std::chrono::seconds patience{120};

/// The address of a file, in which all bytes that might mean something in addresses are numbers.
std::string addressOf(const std::string& path) {
    static constexpr std::string_view digits = "0123456789ABCDEF";
    std::string address = "file://";
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || c == '/' || c == '.')
            address += c;
        else
            ((address += '%') += digits[byte >> 4]) += digits[byte & 15];
    }
    return address;
}

std::vector<std::string> commandLine(const char* browser, const TemporaryFolder& folder, int width,
                                     int height) {
    std::vector<std::string> words = {
        browser, "--headless", "--no-first-run", "--disable-background-networking", "--disable-extensions",
        "--hide-scrollbars", "--force-device-scale-factor=1",
        // Rendering and compositing in software gives the same picture everywhere, and is a sixth faster
        // together.
        "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-compositing",
        "--user-data-dir=" + folder.file("profile"),
        "--window-size=" + std::to_string(width) + "," + std::to_string(height),
        "--screenshot=" + folder.file("picture.png")};
    if (geteuid() == 0) words.emplace_back("--no-sandbox"); // Chromium does not start otherwise
    words.push_back(addressOf(folder.file("page.html")));
    return words;
}

} // namespace

std::string photographPage(std::string_view page, int width, int height) {
    const HeldSignals signals;
    const TemporaryFolder folder("qm-page");
    writeFile(folder.file("page.html"), page);
    const bool found = std::ranges::any_of(browsers, [&](const char* browser) {
        return runProgram(commandLine(browser, folder, width, height), signals, "/dev/null", patience);
    });
    if (!found)
        throw Error("", "there is no Chromium to take a picture with", "Install Debian's package chromium");
    if (!std::filesystem::exists(folder.file("picture.png")))
        throw Error("", "Chromium has made no picture", "Write the page with -o and open it in a browser");
    return readFile(folder.file("picture.png"));
}

} // namespace qm
