/// \file The one `main` of all tools: a tool declares what it reads, writes and can be told, and has a body.
///
///     int main(int argc, char** argv) {
///         qm::PruneOptions options;
///         return qm::runTool(argc, argv, "qm-prune", "Remove flat boundaries from a layout.",
///                            [&](qm::Tool& tool) -> qm::ToolBody {
///             tool.reads("DOCUMENT", "a document with a layout");
///             tool.writes("the document with a smaller layout");
///             tool.options(options);
///             tool.example("qm-prune --eta -3 part.layout.json -o part.pruned.json");
///             return [&] {
///                 tool.write(prune(tool.readInput(), options));
///                 return qm::exitDone;
///             };
///         });
///     }
///
/// So every tool has --help, --version, --quiet, --verbose, --stats, --jobs, --json-usage and, where it
/// applies, --output and --schema. Declarations open no file: a wrong command line ends with status 2 before
/// anything is touched. What the body throws becomes one line on standard error and status 1. Tools whose
/// document grows along the pipe use stage.h, which declares operand, --mesh, output and schema in one go.
#pragma once

#include "base/control.h"
#include "cli/options/command_line.h"
#include "cli/options/general_options.h"
#include "cli/system/exit_status.h"
#include "cli/system/run_statistics.h"
#include "cli/terminal/console.h"
#include "document/options/option.h"

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace qm {

using ToolBody = std::function<int()>;

class Tool {
public:
    Tool(const std::string& name, const std::string& summary);
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    // ---- What to declare. Names of options come without dashes.

    /// The input operand, a file or "-"; standard input if it is left out.
    void reads(const std::string& operand, const std::string& what);
    /// A further operand, given before the input.
    /// \param required  a usage error if it is left out
    /// \param suggestions  values that completion offers
    void operand(const std::string& name, std::string& value, const std::string& help, bool required = true,
                 std::vector<std::string> suggestions = {});
    /// Operands beyond those that are declared; more than none only where the caller's `verify` allows it.
    void readsMore(std::vector<std::string>& files) { more_ = &files; }
    /// -o, --output: a file or "-"; standard output if it is left out.
    void writes(const std::string& what);
    /// --schema prints the schema of this kind of document, such as "layout".
    void schema(const std::string& kind) { usage_.schema = kind; }

    /// These options have an effect only if this holds once the command line has been read; given without it,
    /// they are a usage error, `--NAME has no effect without WHAT`.
    void needs(std::vector<std::string> names, std::string what, std::function<bool()> holds) {
        conditions_.push_back({std::move(names), std::move(what), std::move(holds)});
    }
    /// Options that are declared from here on stand under this heading in --help; `ownOptions` at first.
    /// Those under `generalOptions` come last.
    void group(const std::string& heading) { group_ = heading; }
    static constexpr const char* ownOptions = "Options";
    static constexpr const char* generalOptions = "General options";
    /// All options of a struct, from its table in document/options/options.h.
    template <class Options> void options(Options& values);
    /// A single option: bool (a flag), int, std::size_t, double, or an enumeration that has `Choices`.
    template <class Value>
    void option(const std::string& name, Value& value, const Range& range, const std::string& help);
    template <class Value> void option(const std::string& name, Value& value, const std::string& help) {
        option(name, value, Range{}, help);
    }
    /// An option whose value is text.
    /// \param placeholder  "FILE", "NAME"
    /// \param suggestions  that completion offers, each as a part of a list with commas
    void text(const std::string& name, std::string& value, const std::string& placeholder,
              const std::string& help, std::vector<std::string> suggestions = {});
    /// A command that works; shown under "Examples" in --help, in the order of the calls. The files part.obj
    /// and part.KIND.json exist where the examples are tried.
    void example(const std::string& command) { usage_.examples.push_back(command); }
    /// A paragraph of --help, below the summary.
    void explain(const std::string& paragraph) { usage_.paragraphs.push_back(paragraph); }
    /// The first interrupt asks the body through `Control::stopRequested` to end with the best so far, and
    /// the exit status is `exitUnmet`; a second one, later than a second, ends the tool. Without this the
    /// first one does.
    void stopsGracefully() { isGraceful_ = true; }
    /// Called when the command line has been read and before anything else. What it throws, UsageError or
    /// Error, is a usage error.
    void verify(std::function<void()> check) { verify_ = std::move(check); }

    // ---- What the body may use.

    [[nodiscard]] const std::string& name() const { return usage_.tool; }
    /// As in messages: the path, or "standard input".
    [[nodiscard]] std::string inputName() const;
    /// The path as it was given; "-" for standard input.
    [[nodiscard]] const std::string& inputPath() const { return input_; }
    /// "-" for standard output.
    [[nodiscard]] const std::string& outputPath() const { return general_.output; }
    /// True if the user gave this option on the command line.
    [[nodiscard]] bool given(const std::string& optionName) const { return given_.contains(optionName); }
    /// All bytes of the input.
    [[nodiscard]] std::string readInput() const;
    /// No output of this run may replace this file.
    /// \param what  why not, to complete a sentence that begins with the file
    /// \throw FileError  if one would
    void protect(const std::string& path,
                 const std::string& what = "is the mesh that the result refers to") const;
    /// The same for the input, where the output is no document that could replace it.
    void protectInput() const { protect(inputPath(), "is the input"); }
    /// To the output, whole or not at all. Once per run.
    void write(std::string_view bytes) const;

    /// One line on standard error, `tool: message`; warnings are left out with --quiet, notes are shown with
    /// --verbose only.
    void warn(const std::string& message) const { console_.warn(message); }
    void note(const std::string& message) const { console_.note(message); }
    /// A warning that begins with the name of the input.
    void warnOfInput(const std::string& message) const { warn(inputName() + ": " + message); }

    /// A figure for --stats.
    template <class Number> void count(const std::string& counter, Number value) const {
        statistics_.count(counter, static_cast<double>(value));
    }

    [[nodiscard]] unsigned jobs() const { return general_.jobs; }
    /// Progress bar, interrupts and threads for a long computation. The bar appears on terminals only, after
    /// two seconds.
    [[nodiscard]] Control control(const std::string& label) const;
    /// Says every few seconds what a search tells it; not with --quiet.
    [[nodiscard]] KnownCost sayingKnown() const { return console_.sayingKnown(); }

private:
    friend int runTool(int argc, char** argv, const std::string& name, const std::string& summary,
                       const std::function<ToolBody(Tool&)>& declare);

    void add(OptionRecord record);
    void addGeneralOptions();
    void parse(int argc, char** argv);
    void noteSettings() const;
    int answer(const ToolBody& body);

    Usage usage_;
    std::string group_ = ownOptions;
    std::vector<std::string*> operands_;       ///< targets of those of `usage_`
    std::vector<std::string>* more_ = nullptr; ///< for operands beyond those
    bool hasInput_ = false;
    bool hasOutput_ = false;
    bool isGraceful_ = false;
    std::vector<OptionCondition> conditions_;
    std::function<void()> verify_;

    std::string input_ = "-";
    GeneralOptions general_;
    std::set<std::string> given_;

    // What a run says and counts changes nothing of the tool.
    mutable RunStatistics statistics_;
    mutable Console console_;
};

/// Runs a tool and returns its exit status.
/// \param declare  declares the options and returns the body
int runTool(int argc, char** argv, const std::string& name, const std::string& summary,
            const std::function<ToolBody(Tool&)>& declare);

// ---- Templates.

template <class Value>
void Tool::option(const std::string& name, Value& value, const Range& range, const std::string& help) {
    add(makeOption(name, value, range, help));
}

template <class Options> void Tool::options(Options& values) {
    describe(values, [this](const char* name, auto& value, const Range& range, const char* help) {
        this->option(name, value, range, help);
    });
    conditions(values, [this](std::vector<std::string> names, std::string what, std::function<bool()> holds) {
        needs(std::move(names), std::move(what), std::move(holds));
    });
}

} // namespace qm
