/// \file The description of a tool: --help for people, --json-usage for programs.
#pragma once

#include "cli/options/option_record.h"

#include <string>
#include <vector>

namespace qm {

struct Operand {
    std::string name; ///< "DOCUMENT"
    std::string help;
    bool required = false;
    std::vector<std::string> suggestions{}; ///< values to suggest; others are allowed
};

/// All declarations of a tool.
struct Usage {
    std::string tool;
    std::string summary; ///< one sentence
    std::vector<std::string> paragraphs;
    std::vector<Operand> operands;
    std::vector<OptionRecord> options; ///< in the order of --help
    std::vector<std::string> examples;
    std::string writes; ///< the output; empty if there is none
    std::string schema; ///< the kind of document written; may be empty
};

[[nodiscard]] std::string helpText(const Usage& usage);
[[nodiscard]] std::string jsonUsage(const Usage& usage);
/// The version, such as "qm-enum (quadmesh) 1.0.0", and what the tool was built with.
[[nodiscard]] std::string versionText(const std::string& tool);

} // namespace qm
