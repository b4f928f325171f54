/// \file What qm-enum may be asked for besides its options.
#pragma once

#include "cli/tool.h"
#include "document/model.h"
#include "enumerate/enumerate.h"

#include <string>

namespace qm {

struct EnumerationRequests {
    std::string allGraphs;  ///< file for every graph; empty: none
    std::string bestGraphs; ///< file for the best graphs, which the document then does not hold
    bool requireComplete = false;
    bool requireOptimal = false;
};

void declareRequests(Tool& tool, EnumerationRequests& requests, const EnumerationOptions& options);

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
