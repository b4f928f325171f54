/// \file The tables that show what the search can do. Each prints itself and its heading.
#pragma once

#include <regex>

namespace qm::bench {

struct TableOptions {
    std::regex meshes;        ///< only those whose name it finds
    double cbcSeconds = 60;   ///< after which plain CBC is ended
    double gapSeconds = 60;   ///< for every hard mesh and class; 0: none of them
    double torusSeconds = 60; ///< after which each of the paper's algorithms is ended
};

/// The proven optimum of whole meshes, both classes, beside plain CBC.
/// \return whether every optimum is proven, and the known one
bool printOptima(const TableOptions& options);

/// What is left between best graph and bound on meshes that are too hard to prove at once.
void printGaps(const TableOptions& options);

/// Counts and their known values.
/// \return whether they agree
bool printCounts(const TableOptions& options);

/// How fast all graphs are visited and written, on one thread and on two.
void printListing();

/// The paper's torus: all graphs by ours, and by its algorithms.
void printTorus(const TableOptions& options);

} // namespace qm::bench
