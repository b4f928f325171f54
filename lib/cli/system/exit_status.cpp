#include "cli/system/exit_status.h"

#include "base/error.h"
#include "cli/options/command_line.h"
#include "document/files/files.h"

#include <exception>
#include <new>

namespace qm {

int statusOf(const std::function<int()>& work, const std::string& tool,
             const std::function<std::string()>& input,
             const std::function<void(const std::string& message)>& say) {
    const auto fail = [&](const std::string& message) {
        say(message);
        return exitFailure;
    };
    try {
        return work();
    } catch (const UsageError& error) {
        say(error.what() + std::string(". Try '") + tool + " --help'.");
        return exitUsage;
    } catch (const FileError& error) {
        return fail(error.what());
    } catch (const Error& error) {
        const std::string name = input();
        return fail((name.empty() ? "" : name + ": ") + error.what());
    } catch (const std::bad_alloc&) {
        return fail("out of memory. Ask for less, or use a machine with more");
    } catch (const std::exception& error) {
        return fail(std::string("unexpected failure: ") + error.what() +
                    ". This is a fault of the tool: please report it");
    }
}

} // namespace qm
