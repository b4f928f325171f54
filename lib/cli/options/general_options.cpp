#include "cli/options/general_options.h"

#include <algorithm>
#include <thread>

namespace qm {
namespace {

constexpr unsigned maxJobs = 1024;

OptionRecord withShort(const char* shortName, OptionRecord record) {
    record.shortName = shortName;
    return record;
}

} // namespace

GeneralOptions::GeneralOptions() : jobs(std::max(1U, std::thread::hardware_concurrency())) {}

std::vector<OptionRecord> describeGeneral(GeneralOptions& values, bool hasOutput, bool hasSchema) {
    std::vector<OptionRecord> options;
    if (hasOutput) {
        options.push_back(withShort("o", makeTextOption("output", values.output, "FILE",
                                                        "write to this file instead of standard output")));
        options.back().defaultText.clear();
    }
    options.push_back(withShort(
        "j",
        makeOption("jobs", values.jobs, Range{1, maxJobs},
                   "number of threads; results do not depend on it, unless a time limit ends the work")));
    options.back().defaultText = "as many as processors";
    options.push_back(
        withShort("q", makeOption("quiet", values.quiet, {}, "errors only: no warnings, no progress bar")));
    options.push_back(
        withShort("v", makeOption("verbose", values.verbose, {}, "report the settings in effect, and more")));
    options.push_back(makeOption("stats", values.stats, {},
                                 "write time (the tool's own, and that of reading the input), memory and "
                                 "counters to standard error as one line of JSON"));
    if (hasSchema)
        options.push_back(
            makeOption("schema", values.schema, {}, "print the JSON schema of the document that is written"));
    options.push_back(makeOption("json-usage", values.usage, {}, "print this help as JSON"));
    options.push_back(withShort("h", makeOption("help", values.help, {}, "print this help")));
    options.push_back(makeOption("version", values.version, {}, "print the version"));
    return options;
}

} // namespace qm
