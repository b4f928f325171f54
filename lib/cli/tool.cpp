#include "cli/tool.h"

#include "cli/options/command_line_rules.h"
#include "cli/options/general_options.h"
#include "cli/options/usage.h"
#include "cli/system/allocation.h"
#include "cli/system/output_file.h"
#include "cli/system/run_statistics.h"
#include "cli/system/signals.h"
#include "cli/terminal/console.h"
#include "cli/terminal/messages.h"
#include "document/files/files.h"
#include "document/schema/schema.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <unistd.h>

namespace qm {

struct Tool::State {
    explicit State(std::string tool) : console(tool, general) { usage.tool = std::move(tool); }

    Usage usage;
    std::string group = ownOptions;
    std::vector<std::string*> operands;       ///< targets of usage.operands
    std::vector<std::string>* more = nullptr; ///< for operands beyond those
    bool hasInput = false;
    bool hasOutput = false;
    bool graceful = false;
    std::vector<OptionCondition> conditions;
    std::function<void()> verify;

    std::string input = "-";
    GeneralOptions general;
    std::set<std::string> given;

    RunStatistics statistics;
    Console console;
};

Tool::Tool(std::string name, std::string summary) : state_(std::make_unique<State>(std::move(name))) {
    state_->usage.summary = std::move(summary);
}

Tool::~Tool() = default;

// ------------------------------------------------------------------------------------------ declarations

void Tool::reads(const std::string& operand, const std::string& what) {
    state_->hasInput = true;
    state_->usage.operands.push_back({operand, what + "; - or nothing means standard input", false, {}});
    state_->operands.push_back(&state_->input);
}

void Tool::readsMore(std::vector<std::string>& files) {
    state_->more = &files;
}

void Tool::operand(const std::string& name, std::string& value, const std::string& help, bool required,
                   std::vector<std::string> suggestions) {
    state_->usage.operands.push_back({name, help, required, std::move(suggestions)});
    state_->operands.push_back(&value);
}

void Tool::writes(const std::string& what) {
    state_->hasOutput = true;
    state_->usage.writes = what;
}

void Tool::schema(const std::string& kind) {
    state_->usage.schema = kind;
}

void Tool::group(const std::string& heading) {
    state_->group = heading;
}

void Tool::text(const std::string& name, std::string& value, const std::string& placeholder,
                const std::string& help, std::vector<std::string> suggestions) {
    OptionRecord record = makeTextOption(name, value, placeholder, help);
    record.suggestions = std::move(suggestions);
    add(std::move(record));
}

void Tool::example(const std::string& command) {
    state_->usage.examples.push_back(command);
}

void Tool::explain(const std::string& paragraph) {
    state_->usage.paragraphs.push_back(paragraph);
}

void Tool::stopsGracefully() {
    state_->graceful = true;
}

void Tool::verify(std::function<void()> check) {
    state_->verify = std::move(check);
}

void Tool::needs(std::vector<std::string> names, std::string what, std::function<bool()> holds) {
    state_->conditions.push_back({std::move(names), std::move(what), std::move(holds)});
}

void Tool::add(OptionRecord record) {
    record.group = state_->group;
    state_->usage.options.push_back(std::move(record));
}

void Tool::addGeneralOptions() {
    State& s = *state_;
    s.group = generalOptions;
    for (OptionRecord& record : describeGeneral(s.general, s.hasOutput, !s.usage.schema.empty()))
        add(std::move(record));
    needs({"verbose"}, "messages, which --quiet turns off", [&s] { return !s.general.quiet; });
    std::stable_partition(s.usage.options.begin(), s.usage.options.end(),
                          [](const OptionRecord& record) { return record.group != generalOptions; });
}

// --------------------------------------------------------------------------------------- the command line

void Tool::parse(int argc, char** argv) {
    State& s = *state_;
    CommandLine line = readCommandLine(argc, argv, s.usage.options);
    s.given = std::move(line.given);
    if (s.general.asksAboutTheTool()) return;
    if (!line.problem.empty()) throw UsageError(line.problem);
    assignOperands(line.operands, s.usage.operands, s.operands, s.more);
    requireEffects(s.conditions, s.given);
    if (s.verify) try {
            s.verify();
        } catch (const Error& error) {
            throw UsageError(error.what()); // options are all that has been read
        }
    if (s.hasInput && s.input == "-" && isatty(STDIN_FILENO) != 0)
        throw UsageError("standard input is a terminal. Name a file, or pipe one in");
}

// ------------------------------------------------------------------------------------------- for the body

const std::string& Tool::name() const {
    return state_->usage.tool;
}
std::string Tool::inputName() const {
    return displayName(state_->input);
}
const std::string& Tool::inputPath() const {
    return state_->input;
}
const std::string& Tool::outputPath() const {
    return state_->general.output;
}
bool Tool::given(const std::string& optionName) const {
    return state_->given.contains(optionName);
}
unsigned Tool::jobs() const {
    return state_->general.jobs;
}

std::string Tool::readInput() const {
    const auto begin = std::chrono::steady_clock::now();
    std::string bytes = readFile(state_->input);
    state_->statistics.addReading(std::chrono::steady_clock::now() - begin);
    return bytes;
}

void Tool::protect(const std::string& path, const std::string& what) const {
    protectFromOutput(path, what);
    if (state_->hasOutput) verifyWritable(state_->general.output);
}

void Tool::write(std::string_view bytes) const {
    state_->console.hideProgress();
    writeFile(state_->general.output, bytes);
}

void Tool::warn(const std::string& message) const {
    state_->console.warn(message);
}

void Tool::note(const std::string& message) const {
    state_->console.note(message);
}

void Tool::addCounter(const std::string& name, double value) const {
    state_->statistics.count(name, value);
}

Control Tool::control(const std::string& label) const {
    Control control;
    control.jobs = state_->general.jobs;
    if (state_->graceful) {
        deferInterrupt();
        control.stopRequested = [] { return wasInterrupted(); };
    }
    if (const auto show = state_->console.showProgress(label)) control.progress = show;
    return control;
}

KnownCost Tool::sayingKnown() const {
    return state_->console.sayingKnown();
}

// ------------------------------------------------------------------------------------------- the one main

void Tool::noteSettings() const {
    std::string text;
    for (const OptionRecord& option : state_->usage.options) {
        if (option.group == generalOptions) continue;
        const std::string value = option.show();
        if (!value.empty()) text += (text.empty() ? "" : ", ") + option.name + " " + value;
    }
    note("settings: " + (text.empty() ? "none" : text));
}

int Tool::answer(const ToolBody& body) {
    const State& s = *state_;
    const auto print = [](const std::string& text) {
        writeFile("-", text);
        return exitDone;
    };
    if (s.general.help) return print(helpText(s.usage));
    if (s.general.version) return print(versionText(s.usage.tool));
    if (s.general.schema) return print(standaloneSchema(s.usage.schema));
    if (s.general.usage) return print(jsonUsage(s.usage));
    noteSettings();
    if (s.hasOutput) verifyWritable(s.general.output);
    int status = body();
    if (wasInterrupted() && (status == exitDone || status == exitUnmet)) {
        warn("interrupted: what is written is the best that was found until then");
        status = exitUnmet;
    }
    if (s.general.stats) {
        s.console.hideProgress();
        printMessage(s.statistics.line(s.usage.tool));
    }
    return status;
}

int Tool::run(int argc, char** argv, const std::function<ToolBody(Tool&)>& declare) {
    const auto work = [&] {
        keepFreedMemory();
        openStandardStreams();
        watchSignals();
        watchMemory(state_->usage.tool);
        const ToolBody body = declare(*this);
        addGeneralOptions();
        parse(argc, argv);
        return answer(body);
    };
    return statusOf(
        work, state_->usage.tool, [this] { return state_->hasInput ? inputName() : std::string(); },
        [this](const std::string& message) { state_->console.say(message); });
}

int runTool(int argc, char** argv, const std::string& name, const std::string& summary,
            const std::function<ToolBody(Tool&)>& declare) {
    return Tool(name, summary).run(argc, argv, declare);
}

} // namespace qm
