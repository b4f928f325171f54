/// \file The options shared by all tools.
#pragma once

#include "cli/options/option_record.h"

#include <string>
#include <vector>

namespace qm {

struct GeneralOptions {
    std::string output = "-";
    unsigned jobs; ///< by default the number of processors
    bool quiet = false;
    bool verbose = false;
    bool stats = false;
    // Information to be printed instead of running the tool:
    bool help = false;
    bool version = false;
    bool schema = false;
    bool usage = false;

    GeneralOptions();
    [[nodiscard]] bool asksAboutTheTool() const { return help || version || schema || usage; }
};

/// The general options in the order of --help.
/// \param values  set by the options; must outlive them
/// \param hasOutput, hasSchema  whether the tool writes output, and whether that is a document
[[nodiscard]] std::vector<OptionRecord> describeGeneral(GeneralOptions& values, bool hasOutput,
                                                        bool hasSchema);

} // namespace qm
