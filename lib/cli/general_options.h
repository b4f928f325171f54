/// \file The options that all tools have.
#pragma once

#include "cli/option_record.h"

#include <string>
#include <vector>

namespace qm {

struct GeneralOptions {
    std::string output = "-";
    unsigned jobs; ///< as many as processors, unless told otherwise
    bool quiet = false;
    bool verbose = false;
    bool stats = false;
    // What is printed instead of running the tool:
    bool help = false;
    bool version = false;
    bool schema = false;
    bool usage = false;

    GeneralOptions();
    [[nodiscard]] bool asksAboutTheTool() const { return help || version || schema || usage; }
};

/// In the order of --help.
/// \param values  set by the options; must outlive them
/// \param hasOutput, hasSchema  whether the tool writes something, and whether that is a document
[[nodiscard]] std::vector<OptionRecord> describeGeneral(GeneralOptions& values, bool hasOutput,
                                                        bool hasSchema);

} // namespace qm
