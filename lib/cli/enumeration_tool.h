/// \file What qm-enum may be asked for besides its options.
#pragma once

#include "cli/tool.h"
#include "document/model.h"
#include "enumerate/enumerate.h"

#include <string>
#include <vector>

namespace qm {

struct EnumerationRequests {
    std::string allGraphs;  ///< file for every graph; empty: none
    std::string bestGraphs; ///< file for the best graphs, which the document then does not hold
    bool requireComplete = false;
    bool requireOptimal = false;
    std::string part;                      ///< "I/N"
    bool join = false;                     ///< the inputs are parts, to be united
    std::vector<std::string> furtherParts; ///< besides the input
};

void declareRequests(Tool& tool, EnumerationRequests& requests, EnumerationOptions& options);

/// Unites the parts that are the tool's input.
/// \return the exit status
int joinParts(const Tool& tool, const EnumerationRequests& requests);

/// What the search is to keep for the document: only the best graph where all of them go to a file.
[[nodiscard]] EnumerationOptions forDocument(const EnumerationOptions& options,
                                             const EnumerationRequests& requests);

/// If it was asked for, writes every graph, or the best, as one line of JSON: {"subMesh", "cost", "tracks"}.
void streamGraphs(const Tool& tool, const Model& model, const EnumerationOptions& options,
                  const EnumerationRequests& requests);

/// The exit status: `exitUnmet` if the search is not what was required. Warns of a search that a limit ended.
[[nodiscard]] int judge(const Tool& tool, const Enumeration& enumeration,
                        const EnumerationRequests& requests);

} // namespace qm
