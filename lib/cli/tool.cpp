#include "cli/tool.h"

#include "base/joined.h"
#include "cli/system/output_file.h"
#include "cli/system/signals.h"
#include "cli/terminal/messages.h"
#include "document/files/files.h"
#include "document/schema/schema.h"

#include <algorithm>
#include <chrono>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace qm {
namespace {

/// Tells the C library to keep what is freed instead of handing it back to the system at once. Solvers take
/// and free the same arrays thousands of times a second, and each new page costs a fault: the searches take
/// half the time, the fits four fifths. What is above 256 megabytes is handed back all the same.
void keepFreedMemory() {
#ifdef __GLIBC__
    constexpr int megabyte = 1 << 20;
    mallopt(M_TRIM_THRESHOLD, 256 * megabyte);
    mallopt(M_MMAP_THRESHOLD, 32 * megabyte); // the largest that the C library allows
#endif
}

} // namespace

Tool::Tool(const std::string& name, const std::string& summary) : console_(name, general_) {
    usage_.tool = name;
    usage_.summary = summary;
}

// ------------------------------------------------------------------------------------------ declarations

void Tool::reads(const std::string& operand, const std::string& what) {
    hasInput_ = true;
    usage_.operands.push_back({operand, what + "; - or nothing means standard input", false, {}});
    operands_.push_back(&input_);
}

void Tool::operand(const std::string& name, std::string& value, const std::string& help, bool required,
                   std::vector<std::string> suggestions) {
    usage_.operands.push_back({name, help, required, std::move(suggestions)});
    operands_.push_back(&value);
}

void Tool::writes(const std::string& what) {
    hasOutput_ = true;
    usage_.writes = what;
}

void Tool::text(const std::string& name, std::string& value, const std::string& placeholder,
                const std::string& help, std::vector<std::string> suggestions) {
    OptionRecord record = makeTextOption(name, value, placeholder, help);
    record.suggestions = std::move(suggestions);
    add(std::move(record));
}

void Tool::add(OptionRecord record) {
    record.group = group_;
    usage_.options.push_back(std::move(record));
}

void Tool::addGeneralOptions() {
    group_ = generalOptions;
    for (OptionRecord& record : describeGeneral(general_, hasOutput_, !usage_.schema.empty()))
        add(std::move(record));
    needs({"verbose"}, "messages, which --quiet turns off", [this] { return !general_.quiet; });
    std::stable_partition(usage_.options.begin(), usage_.options.end(),
                          [](const OptionRecord& record) { return record.group != generalOptions; });
}

// --------------------------------------------------------------------------------------- the command line

void Tool::parse(int argc, char** argv) {
    CommandLine line = readCommandLine(argc, argv, usage_.options);
    given_ = std::move(line.given);
    if (general_.asksAboutTheTool()) return;
    if (!line.problem.empty()) throw UsageError(line.problem);
    assignOperands(line.operands, usage_.operands, operands_, more_);
    requireEffects(conditions_, given_);
    if (verify_) try {
            verify_();
        } catch (const Error& error) {
            throw UsageError(error.what()); // options are all that has been read
        }
    if (hasInput_ && input_ == "-" && isatty(STDIN_FILENO) != 0)
        throw UsageError("standard input is a terminal. Name a file, or pipe one in");
}

// ------------------------------------------------------------------------------------------- for the body

std::string Tool::inputName() const {
    return displayName(input_);
}

std::string Tool::readInput() const {
    const auto begin = std::chrono::steady_clock::now();
    std::string bytes = readFile(input_);
    statistics_.addReading(std::chrono::steady_clock::now() - begin);
    return bytes;
}

void Tool::protect(const std::string& path, const std::string& what) const {
    protectFromOutput(path, what);
    if (hasOutput_) verifyWritable(general_.output);
}

void Tool::write(std::string_view bytes) const {
    console_.hideProgress();
    writeFile(general_.output, bytes);
}

Control Tool::control(const std::string& label) const {
    Control control;
    control.jobs = general_.jobs;
    if (isGraceful_) {
        deferInterrupt();
        control.stopRequested = [] { return wasInterrupted(); };
    }
    if (const auto show = console_.showProgress(label)) control.progress = show;
    return control;
}

// ------------------------------------------------------------------------------------------- the one main

void Tool::noteSettings() const {
    std::vector<std::string> settings;
    for (const OptionRecord& option : usage_.options) {
        if (option.group == generalOptions) continue;
        if (const std::string value = option.show(); !value.empty())
            settings.push_back(option.name + " " + value);
    }
    note("settings: " + (settings.empty() ? "none" : joined(settings)));
}

int Tool::answer(const ToolBody& body) {
    const auto print = [](const std::string& text) {
        writeFile("-", text);
        return exitDone;
    };
    if (general_.help) return print(helpText(usage_));
    if (general_.version) return print(versionText(usage_.tool));
    if (general_.schema) return print(standaloneSchema(usage_.schema));
    if (general_.usage) return print(jsonUsage(usage_));
    noteSettings();
    if (hasOutput_) verifyWritable(general_.output);
    int status = body();
    if (wasInterrupted() && (status == exitDone || status == exitUnmet)) {
        warn("interrupted: what is written is the best that was found until then");
        status = exitUnmet;
    }
    if (general_.stats) {
        console_.hideProgress();
        printMessage(statistics_.line(usage_.tool));
    }
    return status;
}

int runTool(int argc, char** argv, const std::string& name, const std::string& summary,
            const std::function<ToolBody(Tool&)>& declare) {
    Tool tool(name, summary);
    const auto work = [&] {
        keepFreedMemory();
        openStandardStreams();
        watchSignals();
        watchMemory(name);
        const ToolBody body = declare(tool);
        tool.addGeneralOptions();
        tool.parse(argc, argv);
        return tool.answer(body);
    };
    return statusOf(
        work, name, [&] { return tool.hasInput_ ? tool.inputName() : std::string(); },
        [&](const std::string& message) { tool.console_.say(message); });
}

} // namespace qm
