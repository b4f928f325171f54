#include "prune/prune_optimum.h"

#include "base/at.h"
#include "base/deadline.h"
#include "base/error.h"
#include "layout/quality.h"
#include "layout/tracks.h"
#include "program/neighbourhood_search.h"
#include "program/solve_program.h"
#include "prune/grid_program.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What a search is after.
struct Aim {
    double beta = 0; ///< price of a segment
    double maxSegments = infinity;
};

class Pruner {
public:
    Pruner(const QuadMesh& mesh, const BaseComplex& complex, const Layout& layout,
           const std::vector<double>& dihedralAngles, const std::vector<double>& edgeCosts,
           const PruneOptions& options, const Control& control)
        : mesh_(mesh), complex_(complex), dihedralAngles_(dihedralAngles), edgeCosts_(edgeCosts),
          options_(options), control_(control), graph_(buildArcGraph(mesh, complex)),
          grids_(gridProgram(mesh, complex, graph_, dihedralAngles, edgeCosts, layout,
                             options.smooth ? Smoothness{options.maxTurn, options.minCorner} : Smoothness())),
          layout_(layout), known_{valuesOf(layout)} {
        if (!grids_.program.allows(known_.front()))
            throw Error("/layout/tracks", "they are not made of whole arcs of the base complex",
                        "Leave --method optimum out, or run qm-merge again");
    }

    /// What the options ask for.
    [[nodiscard]] PruneResult prune(double seconds) {
        if (options_.fewestPatches) return pruneToFewest(seconds);
        if (std::isfinite(options_.maxSegments)) return prune({0, options_.maxSegments}, seconds);
        return prune({options_.beta}, seconds);
    }

    [[nodiscard]] PruneResult prune(const Aim& aim, double seconds) {
        const IntegerProgram program = programFor(aim);
        const Deadline end(control_, seconds);
        const bool limited = std::isfinite(aim.maxSegments);
        prepare(program, limited ? dearest : aim.beta);
        if (limited) approach(aim.maxSegments, end);
        Found found = solve(program, aim.maxSegments, end);
        PruneResult result;
        result.layout = layoutOf(found.values);
        result.objectiveBound = found.lowerBound + aim.beta * grids_.corners / 4;
        result.proven = found.proven;
        return result;
    }

    /// Layouts for a range of prices.
    [[nodiscard]] std::vector<FrontPoint> front(double rho, double seconds) {
        const Deadline end(control_, seconds);
        std::vector<FrontPoint> points;
        int left = frontPrices;
        for (double beta = cheapestPrice; left > 0 && !control_.stopRequested(); beta *= 2, --left) {
            const PruneResult pruned = prune({beta}, std::min(end.secondsLeft(), seconds) / left);
            const LayoutQuality quality = measureLayout(mesh_, pruned.layout, dihedralAngles_, rho);
            const FrontPoint point{beta,
                                   quality.segments,
                                   pruned.layout.cost,
                                   quality.capturedSharpness,
                                   *pruned.objectiveBound,
                                   pruned.proven};
            if (std::ranges::any_of(points, [&](const FrontPoint& other) { return covers(other, point); }))
                continue;
            std::erase_if(points, [&](const FrontPoint& other) { return covers(point, other); });
            points.push_back(point);
        }
        std::ranges::sort(points, std::ranges::greater{}, &FrontPoint::segments);
        return points;
    }

private:
    struct Found {
        ColumnValues values;
        double lowerBound = 0;
        bool proven = false;
    };

    /// A price beyond which only the number of segments counts.
    static constexpr double dearest = std::numeric_limits<double>::max();
    static constexpr double cheapestPrice = 1.0 / 16; ///< of a front; the next is twice as much
    static constexpr int frontPrices = 11;            ///< up to 64, where next to nothing but segments counts
    static constexpr double highestPrice = 1024;      ///< a layout of few segments is looked for up to here
    static constexpr double priceGrowth = 4;          ///< ... in few steps, each of which is a search
    static constexpr double shareOfApproach = 1.0 / 12; ///< of the time, for each of them: six take half
    static constexpr double rounding = 1e-9;            ///< of sums of costs, and of numbers of corners

    /// Whether the first is as good in everything.
    static bool covers(const FrontPoint& a, const FrontPoint& b) {
        return a.segments <= b.segments && a.cost <= b.cost + rounding &&
               a.capturedSharpness >= b.capturedSharpness - rounding;
    }

    /// First their number, then G_T with no more than that.
    PruneResult pruneToFewest(double seconds) {
        IntegerProgram numbers = grids_.program;
        numbers.costs.assign(numbers.costs.size(), 0);
        addPrice(numbers, 1);
        const Deadline end(control_, seconds), proofEnd(control_, seconds / 8),
            firstEnd(control_, seconds / 2);
        prepare(numbers, dearest);
        Found fewest = solve(numbers, infinity, proofEnd);
        if (!fewest.proven) {
            // Most neighbours of a layout have as many segments; G_T tells which of them lead on.
            improveAt(highestPrice, seconds / 4);
            const Found better = solve(numbers, infinity, firstEnd);
            fewest = {better.values, std::max(fewest.lowerBound, better.lowerBound), better.proven};
        }
        PruneResult result = prune({0, grids_.segments(fewest.values)}, end.secondsLeft());
        result.proven = result.proven && fewest.proven;
        result.objectiveBound = std::ceil(fewest.lowerBound + grids_.corners / 4 - integral);
        return result;
    }

    void addPrice(IntegerProgram& program, double beta) const {
        for (const ColumnId column : program.costs.ids())
            program.costs[column] += beta * grids_.quarters[column] / 4;
    }

    IntegerProgram programFor(const Aim& aim) const {
        IntegerProgram program = grids_.program;
        addPrice(program, aim.beta);
        if (std::isfinite(aim.maxSegments)) program.rows.push_back(limitOn(aim.maxSegments));
        return program;
    }

    /// Makes solutions known to begin with.
    /// \param worth  of a segment
    void prepare(const IntegerProgram& program, double worth) {
        removeTracks(layout_, worth);
        removeTracks(layoutOf(*bestKnown(program, infinity)), worth);
    }

    /// Half of the time to prove the optimum; otherwise the rest for the best without a proof.
    Found solve(const IntegerProgram& program, double maxSegments, const Deadline& end) {
        const std::optional<ColumnValues> start = bestKnown(program, maxSegments);
        const double seconds = end.secondsLeft();
        ProgramSolution solution =
            solveProgram(program, start.value_or(ColumnValues{}), {.seconds = seconds / 2}, control_);
        if (!solution.values && !start)
            throw Error("--max-segments", "no layout of so few segments was found",
                        "allow more, or more time");
        ColumnValues values = solution.values ? valuesOf(*solution.values) : *start;
        if (start && program.cost(*start) < program.cost(values)) values = *start;
        if (!solution.proven)
            values = valuesOf(improveByNeighbourhoods(program, std::move(values), lines(),
                                                      {.seconds = end.secondsLeft()}, control_));
        known_.push_back(values);
        return {std::move(values), solution.lowerBound, solution.proven};
    }

    /// Of the solutions that were found so far.
    std::optional<ColumnValues> bestKnown(const IntegerProgram& program, double maxSegments) const {
        const ColumnValues* best = nullptr;
        for (const ColumnValues& values : known_)
            if (grids_.segments(values) <= maxSegments + rounding &&
                (!best || program.cost(values) < program.cost(*best)))
                best = &values;
        return best ? std::optional(*best) : std::nullopt;
    }

    /// Adds what greedy removal makes of a layout when a segment costs so much: each removed track saves one.
    void removeTracks(const Layout& layout, double worth) {
        PruneOptions greedy = options_;
        greedy.eta = -worth;
        ColumnValues values =
            valuesOf(pruneLayout(mesh_, layout, dihedralAngles_, edgeCosts_, greedy, control_).layout);
        if (grids_.program.allows(values)) known_.push_back(std::move(values));
    }

    /// Looks for a first layout of so few segments, by making them dearer and dearer. Takes at most half of
    /// the time.
    void approach(double maxSegments, const Deadline& end) {
        const double seconds = end.secondsLeft() * shareOfApproach;
        for (double beta = 1; beta <= highestPrice && !bestKnown(grids_.program, maxSegments);
             beta *= priceGrowth)
            improveAt(beta, seconds);
    }

    /// Adds what neighbourhoods make of the best layout when a segment costs so much.
    void improveAt(double beta, double seconds) {
        const IntegerProgram program = programFor({beta});
        known_.push_back(valuesOf(improveByNeighbourhoods(program, *bestKnown(program, infinity), lines(),
                                                          {.seconds = seconds}, control_)));
    }

    /// The columns of every line's arcs.
    std::vector<std::vector<ColumnId>> lines() const {
        std::vector<std::vector<ColumnId>> columns;
        for (const Line& line : graph_.lines) {
            columns.emplace_back();
            for (int k = 0; k < line.arcCount; ++k)
                columns.back().push_back(GridProgram::columnOf(line.firstArc + k));
        }
        return columns;
    }

    IntegerProgram::Row limitOn(double segments) const {
        IntegerProgram::Row row{{}, {}, -infinity, 4 * segments - grids_.corners};
        for (const ColumnId column : grids_.quarters.ids())
            if (grids_.quarters[column] != 0) {
                row.columns.push_back(column);
                row.weights.push_back(grids_.quarters[column]);
            }
        return row;
    }

    ColumnValues valuesOf(const Layout& layout) const {
        // The loops that components without sources get are on no arc; they are made anew.
        std::vector<bool> onArc(mesh_.n_edges(), false);
        for (std::size_t arc = 0; arc < graph_.arcs.size(); ++arc)
            for (const HalfedgeId halfedge : halfedgesOf(graph_, complex_, ArcId(arc)))
                onArc[at(mesh_.edge_handle(halfedge))] = true;
        std::vector<Track> tracks;
        for (const LayoutTrack& track : layout.tracks)
            if (!track.transversal && onArc[at(mesh_.edge_handle(track.track.halfedges.front()))])
                tracks.push_back(track.track);
        return grids_.valuesOf(presentArcs(mesh_, complex_, graph_, tracks));
    }

    /// Columns that follow from the arcs may have any value that costs nothing; here they get their own.
    ColumnValues valuesOf(const ColumnValues& solved) const {
        std::vector<bool> present(graph_.arcs.size());
        for (std::size_t arc = 0; arc < present.size(); ++arc)
            present[arc] = solved[GridProgram::columnOf(ArcId(arc))] > 0.5;
        return grids_.valuesOf(present);
    }

    /// Every run of arcs that are in, along a line, is a track.
    Layout layoutOf(const ColumnValues& values) const {
        std::vector<Track> tracks;
        for (const Line& line : graph_.lines) {
            bool running = false;
            for (int k = 0; k < line.arcCount; ++k) {
                const ArcId arc = line.firstArc + k;
                const bool in = values[GridProgram::columnOf(arc)] > 0.5;
                if (in && !running) tracks.emplace_back();
                running = in;
                if (!in) continue;
                for (const HalfedgeId halfedge : halfedgesOf(graph_, complex_, arc)) {
                    tracks.back().halfedges.push_back(halfedge);
                    tracks.back().cost += edgeCosts_[at(mesh_.edge_handle(halfedge))];
                }
            }
        }
        return buildLayout(mesh_, tracks, dihedralAngles_, edgeCosts_);
    }

    const QuadMesh& mesh_;
    const BaseComplex& complex_;
    const std::vector<double>& dihedralAngles_;
    const std::vector<double>& edgeCosts_;
    const PruneOptions& options_;
    const Control& control_;
    ArcGraph graph_;
    GridProgram grids_;
    const Layout& layout_;
    std::vector<ColumnValues> known_; ///< solutions, whatever they cost
};

} // namespace

PruneResult prune(const QuadMesh& mesh, const BaseComplex& complex, const Layout& layout,
                  const std::vector<double>& dihedralAngles, const std::vector<double>& edgeCosts,
                  const PruneOptions& options, double rho, const Control& control) {
    const bool greedy = options.method == PruneMethod::greedy;
    PruneResult result;
    if (greedy) result = pruneLayout(mesh, layout, dihedralAngles, edgeCosts, options, control);
    if (greedy && !options.front) return result;
    const Deadline end(control, options.timeLimit);
    Pruner pruner(mesh, complex, layout, dihedralAngles, edgeCosts, options, control);
    if (!greedy) result = pruner.prune(options.timeLimit / (options.front ? 2 : 1));
    if (options.front) result.front = pruner.front(rho, end.secondsLeft());
    return result;
}

} // namespace qm
