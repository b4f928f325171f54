/// \file Tuning of the search for cuts. They move the bound, so with any values a proof finds the same.
#pragma once

#include <array>
#include <cstddef>

namespace qm {

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

} // namespace qm
