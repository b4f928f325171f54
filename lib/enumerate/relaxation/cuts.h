/// \file Cuts of the relaxation: rows that every graph satisfies and a relaxed solution violates. Each kind
/// is defined in the source of its name.
#pragma once

#include "enumerate/relaxation/pass_graph.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// Tuning of the search for cuts. They move the bound, so with any values a proof finds the same.
struct CutTuning {
    /// Smallest violation of a row to be added: others barely move the bound.
    static constexpr double minViolation = 0.05;
    /// Smallest value of an arrival that a trail begins with: smaller ones gain nothing.
    static constexpr double minArrival = 0.2;
    /// Smallest share of such an arrival that stops at the crossing.
    static constexpr double minLoss = 0.01;
    /// Passes of smaller value always count as leading out of the set.
    static constexpr double slight = 1e-3;
    /// Largest number of crossings in the set of a trail: trails that are lost at all are lost sooner.
    static constexpr std::size_t maxCrossings = 400;
    /// Prices of a pass, one after the other. High prices come first: they make rows with few columns, which
    /// take the solver little time and move the bound most.
    static constexpr std::array prices{0.01, 0.003, 0.001};
    /// Length added to every step of a cycle: of equally violated cycles, the shortest are the strongest.
    static constexpr double step = 1e-4;
    /// Largest number of places visited for a cycle: long cycles are seldom violated.
    static constexpr std::size_t maxPlaces = 1000;
    /// If no violated cycle leads through a side, sides within this distance are skipped.
    static constexpr double near = 0.02;
    /// Largest number of rounds of cuts at the root, and the smallest share of the way from bound to cost
    /// that a round must gain.
    static constexpr int maxRounds = 40;
    static constexpr double minGain = 0.002;
};

/// Trail cuts (trail_cuts.cpp, docs/METHOD.md#trail-cuts): wherever a particle arrives, some particle goes
/// on.
///
/// A particle that arrives at a crossing passes it or is stopped by one that passes, and whoever passes
/// arrives at the next crossing. So the trail from an arrival leaves every set of crossings in which it
/// cannot go round in a cycle: at least one pass is taken among those that lead out of the set or would close
/// a cycle in it.
/// \param values  of every column of the formulation
/// \param price   added to the value of every pass: the higher, the fewer passes a row has, and the fewer
/// rows are found
/// \return rows that every graph satisfies and these values violate
[[nodiscard]] std::vector<Formulation::Row> brokenTrails(const PassGraph& graph, const ColumnValues& values,
                                                         double price);

/// Odd cycle cuts (odd_cycle_cuts.cpp, docs/METHOD.md#odd-cycle-cuts): of an odd number of lines, each
/// crossing the next and the last the first, fewer than half can be passed at both crossings by one particle.
/// \param values  of every column of the formulation
/// \return rows that every graph satisfies and these values violate
[[nodiscard]] std::vector<Formulation::Row> brokenOddCycles(const PassGraph& graph,
                                                            const ColumnValues& values);

} // namespace qm
