/// \file Requests to qm-enum other than the options of the search.
#pragma once

#include "cli/tool.h"
#include "document/model.h"
#include "enumerate/enumerate.h"

#include <string>
#include <vector>

namespace qm {

struct EnumerationRequests {
    std::string allGraphs;  ///< file for all graphs; empty if not asked for
    std::string bestGraphs; ///< file for the best graphs, which the document then does not contain
    bool requireComplete = false;
    bool requireOptimal = false;
    std::string part;                      ///< "I/N"
    bool join = false;                     ///< whether the inputs are parts to be joined
    std::vector<std::string> furtherParts; ///< inputs after the first
};

void declareRequests(Tool& tool, EnumerationRequests& requests, EnumerationOptions& options);

/// Joins the parts that are the tool's input.
/// \return the exit status
int joinParts(const Tool& tool, const EnumerationRequests& requests);

/// Searches, and then writes every graph, or the best ones, to files if asked for; one line of JSON each:
/// {"subMesh", "cost", "tracks"}. A time limit is that of all together.
/// \return for the document; it keeps only the best graph if all best graphs go to a file
[[nodiscard]] Enumeration searchGraphs(const Tool& tool, const Model& model,
                                       const EnumerationOptions& options,
                                       const EnumerationRequests& requests);

/// The exit status: `exitUnmet` if the result does not meet the requirements. Warns if a limit ended the
/// search.
[[nodiscard]] int judge(const Tool& tool, const Enumeration& enumeration,
                        const EnumerationRequests& requests);

} // namespace qm
