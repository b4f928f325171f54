#include "cli/tool.h"

#include "cli/command_line.h"
#include "cli/general_options.h"
#include "cli/known_results.h"
#include "cli/messages.h"
#include "cli/output_file.h"
#include "cli/progress.h"
#include "cli/run_statistics.h"
#include "cli/signals.h"
#include "cli/usage.h"
#include "document/files.h"
#include "document/schema.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <unistd.h>

namespace qm {

/// Options, what they need to have an effect, and whether it is there.
struct Condition {
    std::vector<std::string> names;
    std::string what;
    std::function<bool()> holds;
};

struct Tool::State {
    Usage usage;
    std::string group = ownOptions;
    std::vector<std::string*> operands;       ///< targets of usage.operands
    std::vector<std::string>* more = nullptr; ///< for operands beyond those
    bool hasInput = false;
    bool hasOutput = false;
    bool graceful = false;
    std::vector<Condition> conditions;
    std::function<void()> verify;

    std::string input = "-";
    GeneralOptions general;
    std::set<std::string> given;

    RunStatistics statistics;
    std::shared_ptr<Progress> progress;

    void say(const std::string& message) const {
        if (progress) progress->hide();
        printMessage(usage.tool + ": " + message);
    }
};

Tool::Tool(std::string name, std::string summary) : state_(std::make_unique<State>()) {
    state_->usage.tool = std::move(name);
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
    assignOperands(line.operands);
}

void Tool::assignOperands(const std::vector<std::string>& operands) {
    State& s = *state_;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        const bool more = i >= s.operands.size();
        if (more && s.more == nullptr) throw UsageError("unexpected operand " + operands[i]);
        if (operands[i].empty())
            throw UsageError((more ? "operand " + std::to_string(i + 1) : s.usage.operands[i].name) +
                             " is empty");
        if (more)
            s.more->push_back(operands[i]);
        else
            *s.operands[i] = operands[i];
    }
    for (std::size_t i = operands.size(); i < s.operands.size(); ++i)
        if (s.usage.operands[i].required) throw UsageError(s.usage.operands[i].name + " is missing");
    requireEffects();
    if (s.verify) try {
            s.verify();
        } catch (const Error& error) {
            throw UsageError(error.what()); // options are all that has been read
        }
    if (s.hasInput && s.input == "-" && isatty(STDIN_FILENO) != 0)
        throw UsageError("standard input is a terminal. Name a file, or pipe one in");
}

void Tool::requireEffects() const {
    for (const Condition& condition : state_->conditions)
        for (const std::string& name : condition.names)
            if (given(name) && !condition.holds())
                throw UsageError("--" + name + " has no effect without " + condition.what + ". Leave it out");
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

void Tool::protect(const std::string& path) const {
    protectFromOutput(path);
    if (state_->hasOutput) verifyWritable(state_->general.output);
}

void Tool::write(std::string_view bytes) const {
    if (state_->progress) state_->progress->hide();
    writeFile(state_->general.output, bytes);
}

void Tool::warn(const std::string& message) const {
    if (!state_->general.quiet) state_->say(message);
}

void Tool::note(const std::string& message) const {
    if (state_->general.verbose && !state_->general.quiet) state_->say(message);
}

void Tool::count(const std::string& counter, double value) const {
    state_->statistics.count(counter, value);
}

Control Tool::control(const std::string& label) const {
    Control control;
    control.jobs = state_->general.jobs;
    if (state_->graceful) {
        deferInterrupt();
        control.stopRequested = [] { return wasInterrupted(); };
    }
    if (!state_->general.quiet && isatty(STDERR_FILENO) != 0) {
        state_->progress = std::make_shared<Progress>(state_->usage.tool + ": " + label);
        control.progress = [bar = state_->progress](double fraction) { bar->show(fraction); };
    }
    return control;
}

KnownCost Tool::sayingKnown() const {
    if (state_->general.quiet) return {};
    return [this, last = std::make_shared<LastReport>()](double cost, double lowerBound) {
        if (last->isDue()) state_->say(knownText(cost, lowerBound));
    };
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
    if (s.general.help) return writeFile("-", helpText(s.usage)), exitDone;
    if (s.general.version) return writeFile("-", versionText(s.usage.tool)), exitDone;
    if (s.general.schema) return writeFile("-", standaloneSchema(s.usage.schema)), exitDone;
    if (s.general.usage) return writeFile("-", jsonUsage(s.usage)), exitDone;
    noteSettings();
    if (s.hasOutput) verifyWritable(s.general.output);
    int status = body();
    if (wasInterrupted() && status == exitDone) {
        warn("interrupted: what is written is the best that was found until then");
        status = exitUnmet;
    }
    if (s.general.stats) {
        if (s.progress) s.progress->hide();
        printMessage(s.statistics.line(s.usage.tool));
    }
    return status;
}

int Tool::run(int argc, char** argv, const std::function<ToolBody(Tool&)>& declare) {
    const auto fail = [this](const std::string& message) {
        state_->say(message);
        return exitFailure;
    };
    const auto misused = [this](const std::string& message) {
        state_->say(message + ". Try '" + state_->usage.tool + " --help'.");
        return exitUsage;
    };
    try {
        openStandardStreams();
        watchSignals();
        watchMemory(state_->usage.tool);
        const ToolBody body = declare(*this);
        addGeneralOptions();
        parse(argc, argv);
        return answer(body);
    } catch (const UsageError& error) {
        return misused(error.what());
    } catch (const FileError& error) {
        return fail(error.what());
    } catch (const Error& error) {
        return fail((state_->hasInput ? inputName() + ": " : std::string()) + error.what());
    } catch (const std::bad_alloc&) {
        return fail("out of memory");
    } catch (const std::exception& error) {
        return fail(std::string("unexpected failure: ") + error.what() +
                    ". This is a fault of the tool: please report it");
    }
}

int runTool(int argc, char** argv, const std::string& name, const std::string& summary,
            const std::function<ToolBody(Tool&)>& declare) {
    return Tool(name, summary).run(argc, argv, declare);
}

} // namespace qm
