#include "prune/pruning_search.h"

#include "base/error.h"
#include "base/infinity.h"
#include "mesh/topology.h"
#include "program/neighbourhood_search.h"
#include "program/solve_program.h"
#include "prune/layout_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace qm {
namespace {

struct Tuning {
    /// The price of a segment when only the number of segments counts.
    static constexpr double prohibitive = std::numeric_limits<double>::max();
    static constexpr double highestPrice = 1024; ///< last price in the search for a layout of few segments
    static constexpr double priceGrowth = 4;     ///< factor between two prices; each of them is a search
    static constexpr double shareOfApproach = 1.0 / 12; ///< of the time, for each price: six take half of it
    static constexpr double rounding = 1e-9; ///< for numbers of segments, which are sums of corners
};

} // namespace

PruningSearch::PruningSearch(const PrunedMesh& pruned, const Layout& layout, const PruneOptions& options,
                             const Control& control)
    : pruned_(pruned), layout_(layout), options_(options), control_(control),
      grids_(gridProgram(pruned, layout,
                         options.smooth ? Smoothness{options.maxTurn, options.minCorner} : Smoothness(),
                         options.constraints)),
      known_{valuesOf(pruned_, grids_, layout)} {
    if (!grids_.program.allows(known_.front()))
        throw Error("/layout/tracks", "they are not made of whole arcs of the base complex",
                    "Leave --method optimum out, or run qm-merge again");
}

PruningSearch::Found PruningSearch::findCheapest(const PruningAim& aim, double seconds) {
    const IntegerProgram program = programFor(aim);
    const Deadline end(control_, seconds);
    const bool limited = std::isfinite(aim.maxSegments);
    prepare(program, limited ? Tuning::prohibitive : aim.beta);
    if (limited) approach(aim.maxSegments, end);
    Found found = solve(program, aim.maxSegments, end);
    found.lowerBound += aim.beta * grids_.corners / 4;
    return found;
}

PruningSearch::Found PruningSearch::findFewest(double seconds) {
    IntegerProgram numbers = grids_.program;
    numbers.costs.assign(numbers.costs.size(), 0);
    addPrice(numbers, 1);
    const Deadline proofEnd(control_, seconds / 4), end(control_, seconds);
    prepare(numbers, Tuning::prohibitive);
    auto bound = static_cast<double>(pieceCount(pruned_.mesh)); // each of them has a segment
    const auto solveUntil = [&](const Deadline& deadline) {
        Found found = solve(numbers, infinity, deadline);
        bound = std::max(bound, std::ceil(found.lowerBound + grids_.corners / 4 - integral));
        found.lowerBound = bound;
        found.proven = found.proven || segments(found.values) <= bound; // as the number is whole
        return found;
    };
    Found fewest = solveUntil(proofEnd);
    if (fewest.proven) return fewest;
    // Most neighbours of a layout have the same number of segments, so G_T guides the search among them.
    improveAt(Tuning::highestPrice, seconds / 2);
    return solveUntil(end);
}

void PruningSearch::addPrice(IntegerProgram& program, double beta) const {
    for (const ColumnId column : program.costs.ids())
        program.costs[column] += beta * grids_.quarters[column] / 4;
}

IntegerProgram PruningSearch::programFor(const PruningAim& aim) const {
    IntegerProgram program = grids_.program;
    addPrice(program, aim.beta);
    if (std::isfinite(aim.maxSegments)) program.rows.push_back(limitOn(aim.maxSegments));
    return program;
}

IntegerProgram::Row PruningSearch::limitOn(double segments) const {
    IntegerProgram::Row row{{}, {}, -infinity, 4 * segments - grids_.corners};
    for (const ColumnId column : grids_.quarters.ids())
        if (grids_.quarters[column] != 0) {
            row.columns.push_back(column);
            row.weights.push_back(grids_.quarters[column]);
        }
    return row;
}

/// Finds solutions to start from.
/// \param worth  price of a segment
void PruningSearch::prepare(const IntegerProgram& program, double worth) {
    removeTracks(layout_, worth);
    removeTracks(layoutOf(*bestKnown(program, infinity)), worth);
}

/// Adds the result of greedy removal at a given price of a segment; each removed track saves one segment.
void PruningSearch::removeTracks(const Layout& layout, double worth) {
    PruneOptions greedy = options_;
    greedy.eta = -worth;
    ColumnValues values = valuesOf(pruned_, grids_, pruneLayout(pruned_, layout, greedy, control_).layout);
    if (grids_.program.allows(values)) known_.push_back(std::move(values));
}

/// Looks for a layout with at most so many segments by raising their price step by step. Takes at most half
/// of the time.
void PruningSearch::approach(double maxSegments, const Deadline& end) {
    const double seconds = end.secondsLeft() * Tuning::shareOfApproach;
    for (double beta = 1; beta <= Tuning::highestPrice && !bestKnown(grids_.program, maxSegments);
         beta *= Tuning::priceGrowth)
        improveAt(beta, seconds);
}

/// Improves the best layout by neighbourhoods at a given price of a segment, and adds the result.
void PruningSearch::improveAt(double beta, double seconds) {
    const IntegerProgram program = programFor({beta});
    known_.push_back(improved(program, *bestKnown(program, infinity), seconds));
}

ColumnValues PruningSearch::improved(const IntegerProgram& program, ColumnValues values,
                                     double seconds) const {
    return completed(grids_, improveByNeighbourhoods(program, std::move(values), columnsOfLines(grids_.graph),
                                                     {.seconds = seconds}, control_));
}

/// The cheapest solution found so far that has at most `maxSegments` segments.
std::optional<ColumnValues> PruningSearch::bestKnown(const IntegerProgram& program,
                                                     double maxSegments) const {
    const ColumnValues* best = nullptr;
    for (const ColumnValues& values : known_)
        if (grids_.segments(values) <= maxSegments + Tuning::rounding &&
            (!best || program.cost(values) < program.cost(*best)))
            best = &values;
    return best ? std::optional(*best) : std::nullopt;
}

/// Half of the time goes into the proof; if that fails, the rest goes into better solutions without one.
PruningSearch::Found PruningSearch::solve(const IntegerProgram& program, double maxSegments,
                                          const Deadline& end) {
    const std::optional<ColumnValues> start = bestKnown(program, maxSegments);
    const double seconds = end.secondsLeft();
    const ProgramSolution solution =
        solveProgram(program, start.value_or(ColumnValues{}), {.seconds = seconds / 2}, control_);
    if (!solution.values && !start)
        throw Error("--max-segments", "no layout of so few segments was found", "Allow more, or more time");
    ColumnValues values = solution.values ? completed(grids_, *solution.values) : *start;
    if (start && program.cost(*start) < program.cost(values)) values = *start;
    if (!solution.proven) values = improved(program, std::move(values), end.secondsLeft());
    known_.push_back(values);
    return {std::move(values), solution.lowerBound, solution.proven};
}

Layout PruningSearch::layoutOf(const ColumnValues& values) const {
    return qm::layoutOf(pruned_, grids_, values);
}

} // namespace qm
