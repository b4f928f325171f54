/// \file Tables of the search's performance. Each function prints a table with its heading.
#pragma once

#include <regex>

namespace qm::bench {

struct TableOptions {
    std::regex meshes;        ///< only those whose names match
    double cbcSeconds = 60;   ///< limit for plain CBC
    double gapSeconds = 60;   ///< for every hard mesh and class; 0 leaves them out
    double torusSeconds = 60; ///< limit for each of the paper's algorithms
};

/// The proven optima of whole meshes, for both classes, compared with plain CBC.
/// \return whether every optimum is proven and equals the known one
bool printOptima(const TableOptions& options);

/// The gaps between best graph and bound on meshes that are too hard for a quick proof.
void printGaps(const TableOptions& options);

/// Numbers of graphs, compared with known values.
/// \return whether they agree
bool printCounts(const TableOptions& options);

/// The speed of visiting and of writing all graphs, with one thread and with two.
void printListing();

/// All graphs of the paper's torus, by this project's search and by the paper's algorithms.
void printTorus(const TableOptions& options);

} // namespace qm::bench
