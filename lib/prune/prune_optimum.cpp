#include "prune/prune_optimum.h"

#include "base/error.h"
#include "layout/quality.h"
#include "layout/tracks.h"
#include "program/neighbourhood_search.h"
#include "program/solve_program.h"
#include "prune/grid_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace qm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double flat = 180; ///< degrees: no border turns by more

std::size_t at(EdgeId edge) {
    return static_cast<std::size_t>(edge.idx());
}

class Pruner {
public:
    Pruner(const QuadMesh& mesh, const BaseComplex& complex, const Layout& layout,
           const std::vector<double>& dihedralAngles, const std::vector<double>& edgeCosts,
           const PruneOptions& options, const Control& control)
        : mesh_(mesh), complex_(complex), dihedralAngles_(dihedralAngles), edgeCosts_(edgeCosts),
          options_(options), control_(control), graph_(buildArcGraph(mesh, complex)),
          grids_(gridProgram(mesh, complex, graph_, sumOverArcs(mesh, graph_, complex, edgeCosts), layout,
                             options.smooth ? options.maxTurn : flat)),
          layout_(layout), known_{valuesOf(layout)} {}

    /// \param beta  price of a segment
    [[nodiscard]] PruneResult prune(double beta, double maxSegments) {
        IntegerProgram program = pricedAt(beta);
        const double worth = std::isfinite(maxSegments) ? infinity : beta;
        removeTracks(layout_, worth);
        removeTracks(layoutOf(*bestKnown(program, infinity)), worth);
        if (!bestKnown(grids_.program, maxSegments)) approach(maxSegments);
        if (std::isfinite(maxSegments)) program.rows.push_back(limitOn(maxSegments));
        const std::optional<Values> start = bestKnown(program, maxSegments);
        // Half of the time to prove the optimum; otherwise the rest for the best without a proof.
        ProgramSolution solution =
            solveProgram(program, start.value_or(Values{}), {.seconds = options_.timeLimit / 2}, control_);
        if (!solution.values && !start)
            throw Error("--max-segments", "no layout of so few segments was found",
                        "allow more, or more time");
        Values values = start.value_or(Values{});
        if (solution.values) values = std::move(*solution.values);
        if (!solution.proven)
            values = improveByNeighbourhoods(program, std::move(values), lines(),
                                             {.seconds = options_.timeLimit / 2}, control_);
        PruneResult result;
        result.layout = layoutOf(values);
        // Every component without sources gets a loop, whatever the program says.
        const double loops = result.layout.cost - grids_.program.cost(values);
        result.objectiveBound = solution.lowerBound + beta * grids_.corners / 4 + loops;
        result.proven = solution.proven;
        known_.push_back(std::move(values));
        return result;
    }

private:
    using Values = std::vector<double>; ///< of every column of the program

    IntegerProgram pricedAt(double beta) const {
        IntegerProgram program = grids_.program;
        for (std::size_t column = 0; column < program.costs.size(); ++column)
            program.costs[column] += beta * grids_.quarters[column] / 4;
        return program;
    }

    /// The cheapest solution found so far, of at most so many segments.
    std::optional<Values> bestKnown(const IntegerProgram& program, double maxSegments) const {
        const Values* best = nullptr;
        for (const Values& values : known_)
            if (grids_.segments(values) <= maxSegments + 1e-9 &&
                (!best || program.cost(values) < program.cost(*best)))
                best = &values;
        return best ? std::optional(*best) : std::nullopt;
    }

    /// Adds what greedy removal makes of a layout when a segment costs so much: each removed track saves one.
    void removeTracks(const Layout& layout, double worth) {
        PruneOptions greedy = options_;
        greedy.eta = -worth;
        Values values =
            valuesOf(pruneLayout(mesh_, layout, dihedralAngles_, edgeCosts_, greedy, control_).layout);
        if (grids_.program.allows(values)) known_.push_back(std::move(values));
    }

    /// Looks for a first layout of so few segments by raising their price.
    void approach(double maxSegments) {
        constexpr double dearest = 1024;
        for (double beta = 1; beta <= dearest && !bestKnown(grids_.program, maxSegments); beta *= 4) {
            const IntegerProgram program = pricedAt(beta);
            known_.push_back(improveByNeighbourhoods(program, *bestKnown(program, infinity), lines(),
                                                     {.seconds = options_.timeLimit / 12}, control_));
        }
    }

    /// The columns of every line's arcs.
    std::vector<std::vector<int>> lines() const {
        std::vector<std::vector<int>> columns;
        for (const Line& line : graph_.lines) {
            columns.emplace_back(static_cast<std::size_t>(line.arcCount));
            std::iota(columns.back().begin(), columns.back().end(), line.firstArc.value());
        }
        return columns;
    }

    IntegerProgram::Row limitOn(double segments) const {
        IntegerProgram::Row row{{}, {}, -infinity, 4 * segments - grids_.corners};
        for (std::size_t column = 0; column < grids_.quarters.size(); ++column)
            if (grids_.quarters[column] != 0) {
                row.columns.push_back(static_cast<int>(column));
                row.weights.push_back(grids_.quarters[column]);
            }
        return row;
    }

    Values valuesOf(const Layout& layout) const {
        // The loops that components without sources get are on no arc; they are made anew.
        std::vector<bool> onArc(mesh_.n_edges(), false);
        for (std::size_t arc = 0; arc < graph_.arcs.size(); ++arc)
            for (const HalfedgeId halfedge : halfedgesOf(graph_, complex_, ArcId(arc)))
                onArc[at(mesh_.edge_handle(halfedge))] = true;
        std::vector<Track> tracks;
        for (const LayoutTrack& track : layout.tracks)
            if (!track.transversal && onArc[at(mesh_.edge_handle(track.track.halfedges.front()))])
                tracks.push_back(track.track);
        const std::vector<bool> present = presentArcs(mesh_, complex_, graph_, tracks);
        Values values(present.begin(), present.end());
        for (const Junction& junction : graph_.junctions)
            values.push_back(std::ranges::any_of(junction.arcs,
                                                 [&](ArcId arc) { return arc.valid() && present[arc.idx()]; })
                                 ? 1
                                 : 0);
        return values;
    }

    /// Every run of arcs that are in, along a line, is a track.
    Layout layoutOf(const Values& values) const {
        std::vector<Track> tracks;
        for (const Line& line : graph_.lines) {
            bool running = false;
            for (int k = 0; k < line.arcCount; ++k) {
                const ArcId arc(line.firstArc.value() + k);
                const bool in = values[arc.idx()] > 0.5;
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
    std::vector<Values> known_; ///< solutions, whatever they cost
};

/// Whether the first is as good as the second, or better, in everything.
bool covers(const FrontPoint& a, const FrontPoint& b) {
    constexpr double tiny = 1e-9;
    return a.segments <= b.segments && a.cost <= b.cost + tiny &&
           a.capturedSharpness >= b.capturedSharpness - tiny;
}

} // namespace

PruneResult pruneToOptimum(const QuadMesh& mesh, const BaseComplex& complex, const Layout& layout,
                           const std::vector<double>& dihedralAngles, const std::vector<double>& edgeCosts,
                           const PruneOptions& options, const Control& control) {
    Pruner pruner(mesh, complex, layout, dihedralAngles, edgeCosts, options, control);
    return pruner.prune(std::isfinite(options.maxSegments) ? 0 : options.beta, options.maxSegments);
}

std::vector<FrontPoint> pruneFront(const QuadMesh& mesh, const BaseComplex& complex, const Layout& layout,
                                   const std::vector<double>& dihedralAngles,
                                   const std::vector<double>& edgeCosts, const PruneOptions& options,
                                   double rho, const Control& control) {
    Pruner pruner(mesh, complex, layout, dihedralAngles, edgeCosts, options, control);
    std::vector<FrontPoint> points;
    for (double beta = 1.0 / 16; beta <= 64 && !control.stopRequested(); beta *= 2) {
        const PruneResult pruned = pruner.prune(beta, infinity);
        const LayoutQuality quality = measureLayout(mesh, pruned.layout, dihedralAngles, rho);
        const FrontPoint point{beta, quality.segments, pruned.layout.cost, quality.capturedSharpness};
        if (std::ranges::any_of(points, [&](const FrontPoint& other) { return covers(other, point); }))
            continue;
        std::erase_if(points, [&](const FrontPoint& other) { return covers(point, other); });
        points.push_back(point);
    }
    std::ranges::sort(points, std::ranges::greater{}, &FrontPoint::segments);
    return points;
}

PruneResult prune(const QuadMesh& mesh, const BaseComplex& complex, const Layout& layout,
                  const std::vector<double>& dihedralAngles, const std::vector<double>& edgeCosts,
                  const PruneOptions& options, double rho, const Control& control) {
    PruneResult result =
        options.method == PruneMethod::optimum
            ? pruneToOptimum(mesh, complex, layout, dihedralAngles, edgeCosts, options, control)
            : pruneLayout(mesh, layout, dihedralAngles, edgeCosts, options, control);
    if (options.front)
        result.front = pruneFront(mesh, complex, layout, dihedralAngles, edgeCosts, options, rho, control);
    return result;
}

} // namespace qm
