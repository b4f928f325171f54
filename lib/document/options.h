/// \file The option tables of all modules (see option.h): name, member, range and help of every option.
#pragma once

#include "bspline/fit.h"
#include "cut/cut.h"
#include "document/cost_text.h"
#include "document/option.h"
#include "enumerate/enumerate.h"
#include "features/features.h"
#include "merge/merge.h"
#include "prune/prune.h"

#include <cmath>
#include <numbers>

namespace qm {

template <> struct Choices<Terminals> {
    static constexpr std::array all{
        Choice<Terminals>{Terminals::irregular, "irregular",
                          "centres of two groups of extraordinary vertices"},
        Choice<Terminals>{Terminals::farthest, "farthest", "the two vertices farthest apart"},
        Choice<Terminals>{Terminals::box, "box",
                          "the best of three cuts between opposite walls of the bounding box"}};
};

template <> struct Choices<Method> {
    static constexpr std::array all{
        Choice<Method>{Method::optimum, "optimum", "branch and bound, with a lower bound"},
        Choice<Method>{Method::naive, "naive", "all coordinate vectors, filtered"},
        Choice<Method>{Method::bounds, "bounds", "the paper's rules B1 to B4"},
        Choice<Method>{Method::improved, "improved", "the paper's improved algorithm"},
        Choice<Method>{Method::plain, "plain", "the plain motorcycle graph, as a baseline"}};
};

template <> struct Choices<PruneMethod> {
    static constexpr std::array all{
        Choice<PruneMethod>{PruneMethod::greedy, "greedy", "whole tracks, the most expensive first"},
        Choice<PruneMethod>{PruneMethod::optimum, "optimum",
                            "the cheapest layout of grids, over the whole base complex"}};
};

template <> struct Choices<GraphClass> {
    static constexpr std::array all{
        Choice<GraphClass>{GraphClass::motorcycle, "motorcycle", "every track begins at a source"},
        Choice<GraphClass>{GraphClass::tmesh, "tmesh",
                           "tracks may begin and end on others, of the whole mesh only: often much cheaper"}};
};

template <> struct Choices<Fit> {
    static constexpr std::array all{
        Choice<Fit>{Fit::smooth, "smooth",
                    "watertight, smooth across all borders that are no creases, within the tolerance"},
        Choice<Fit>{Fit::interpolate, "interpolate",
                    "the paper's: through every vertex, every patch by itself"}};
};

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double smallestPositive = std::numeric_limits<double>::denorm_min();
constexpr double maxCount = 1e9; ///< limit of any count that a user can ask for
/// Price of a segment. Above it the solver is not precise enough, and only the number of segments counts
/// anyway.
constexpr double highestPrice = 1e4;

/// The conditions under which options have an effect. Every call lists some options, says in words what they
/// need, and whether that is true at present. Options that are not listed always have an effect.
template <class Options, class Visitor> void conditions(const Options&, Visitor&&) {}

template <class Visitor> void describe(FeatureOptions& options, Visitor&& option) {
    option("rho", options.rho, Range{0, std::numbers::pi},
           "every edge of a curve has a dihedral angle above this, radians");
    option("min-length", options.minLength, Range{0, infinite},
           "a curve is at least this long, in the mesh's unit or, with %, as a share of the bounding box's "
           "diagonal");
    option("min-distance", options.minDistance, Range{0, infinite},
           "the ends of a curve are at least this far, along its line, from every extraordinary vertex");
    option(
        "tau", options.tau, Range{1, maxCount},
        "a curve has at least this many edges; 15 is the paper's, and then --min-length is 0 unless given");
    option("zeta", options.zeta, Range{0, maxCount},
           "the ends of a curve are more than this many edges, along its line, from every extraordinary "
           "vertex; 30 is the paper's, and then --min-distance is 0 unless given");
}

template <class Visitor> void describe(CutOptions& options, Visitor&& option) {
    option("chi", options.chi, Range{0, infinite}, "cut a sub-mesh while its quasi-complexity reaches this");
    option("terminals", options.terminals, Range{}, "source and sink of every cut");
    option("lambda", options.lambda, Range{0, infinite}, "weight of cutting a mesh edge");
    option("high-penalty", options.highPenalty, Range{0, infinite},
           "Wh, the cost of giving a vertex that is near one terminal to the other");
    option("low-penalty", options.lowPenalty, Range{0, infinite},
           "Wl, the cost of giving a vertex to a terminal that it is near");
    option("near-limit", options.nearLimit, Range{0, 1}, "m1, up to this nearness the high penalty holds");
    option("far-limit", options.farLimit, Range{0, 1}, "m2, above this nearness the low penalty holds");
    option("avoid-features", options.avoidFeatures, Range{}, "make cutting across sharp edges dearer");
}

template <class Visitor> void describe(EnumerationOptions& options, Visitor&& option) {
    option("alpha", options.cost.alpha, Range{}, "penalty of a flat edge");
    option("epsilon", options.cost.epsilon, Range{0, std::numbers::pi},
           "an edge is flat below this dihedral angle, radians; 1 suits models with sharp edges");
    option("cost", options.cost.terms, Range{},
           "what to minimise, a sum such as dihedral+0.5*segments of the terms dihedral (of edges, with "
           "alpha and "
           "epsilon), length (of edges), segments (their number) and custom (what the document gives edges)");
    option("class", options.graphClass, Range{}, "which graphs");
    option("method", options.method, Range{}, "how to search");
    option("best", options.best, Range{1, maxCount}, "keep this many graphs of every sub-mesh, the cheapest");
    option("count", options.count, Range{},
           "count the graphs of every sub-mesh exactly: those up to --max-cost");
    option("sample", options.sample, Range{0, maxCount},
           "draw this many graphs of every sub-mesh, each as likely as any other");
    option("seed", options.seed, Range{0, maxCount}, "of the draws: another one draws other graphs");
    option("max-cost", options.maxCost, Range{}, "only graphs up to this cost in every sub-mesh");
    option("time-limit", options.timeLimit, Range{0, infinite},
           "stop after this many seconds with the best so far");
    option("gap", options.gap, Range{0, infinite},
           "stop a sub-mesh when its cost is at most this much above the lower bound");
}

template <class Visitor> void conditions(const EnumerationOptions& options, Visitor&& needs) {
    needs({"alpha", "epsilon"}, "the term dihedral in --cost",
          [&options] { return options.cost.terms.dihedral != 0; });
    needs({"best", "max-cost", "time-limit", "count"}, "a --method that searches",
          [&options] { return options.method != Method::plain; });
    needs({"gap", "sample"}, "--method optimum", [&options] { return options.method == Method::optimum; });
    needs({"seed"}, "--sample", [&options] { return options.sample > 0; });
}

template <class Visitor> void describe(MergeOptions& options, Visitor&& option) {
    option("max-rounds", options.maxRounds, Range{0, maxCount},
           "passes of the complete generator before free particles are simply extended");
    option("improve", options.improve, Range{0, infinite},
           "improve the layout for up to this many seconds, and bound what the best one costs");
}

template <class Visitor> void describe(PruneOptions& options, Visitor&& option) {
    option("method", options.method, Range{}, "what to remove");
    option("eta", options.eta, Range{}, "remove tracks that cost more than this; -3 suits soft models");
    option("smooth", options.smooth, Range{}, "leave out the smoothness criterion");
    option("max-turn", options.maxTurn, Range{0, 180},
           "P, the most that the boundary may turn where a removed track ended, degrees");
    option("min-corner", options.minCorner, Range{0, 90},
           "the least that a corner keeps beside a side that passes straight through an extraordinary "
           "vertex, degrees; 0 as in the paper");
    option("beta", options.beta, Range{0, highestPrice}, "with --method optimum: the price of a segment");
    option("fewest-patches", options.fewestPatches, Range{},
           "with --method optimum: as few segments as can be, and only then the lowest G_T");
    option("max-segments", options.maxSegments, Range{0, infinite},
           "with --method optimum: the cheapest layout of so many segments at most, instead of their price");
    option("time-limit", options.timeLimit, Range{0, infinite},
           "with --method optimum or --front: stop after this many seconds with the best so far");
    option("front", options.front, Range{},
           "list which numbers of segments, G_T and captured sharpness can be had, for prices of 1/16 to 64");
}

template <class Visitor> void conditions(const PruneOptions& options, Visitor&& needs) {
    const auto optimum = [&options] { return options.method == PruneMethod::optimum; };
    needs({"eta"}, "--method greedy", [&options] { return options.method == PruneMethod::greedy; });
    needs({"max-turn", "min-corner"}, "the smoothness criterion", [&options] { return options.smooth; });
    needs({"beta", "fewest-patches", "max-segments"}, "--method optimum", optimum);
    needs({"beta"}, "segments whose number is free",
          [&options] { return !options.fewestPatches && !std::isfinite(options.maxSegments); });
    needs({"time-limit"}, "--method optimum or --front",
          [&options] { return options.method == PruneMethod::optimum || options.front; });
}

template <class Visitor> void describe(FitOptions& options, Visitor&& option) {
    option("fit", options.fit, Range{}, "how surfaces follow the mesh");
    option("tolerance", options.tolerance, Range{smallestPositive, infinite},
           "with --fit smooth: the largest distance between the surfaces and what they are fitted to (the "
           "smooth "
           "surface through the mesh's vertices, or the scan, beside its noise), in the mesh's unit, or with "
           "% as "
           "a share of the bounding box's diagonal");
    option("rho", options.rho, Range{0, std::numbers::pi},
           "a border edge is smooth up to this dihedral angle, radians");
}

template <class Visitor> void conditions(const FitOptions& options, Visitor&& needs) {
    needs({"tolerance"}, "--fit smooth", [&options] { return options.fit == Fit::smooth; });
}

} // namespace qm
