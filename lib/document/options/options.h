/// \file The option tables of all modules (see option.h): name, member, range and help of every option.
#pragma once

#include "base/infinity.h"
#include "bspline/fit.h"
#include "cut/cut.h"
#include "document/options/cost_text.h"
#include "document/options/option.h"
#include "enumerate/enumerate.h"
#include "features/features.h"
#include "merge/merge.h"
#include "prune/prune.h"

#include <cmath>
#include <numbers>

namespace qm {

template <> struct Choices<Terminals> {
    using enum Terminals;
    static constexpr Choice<Terminals> all[]{
        {irregular, "irregular", "centres of two groups of extraordinary vertices"},
        {farthest, "farthest", "the two vertices farthest apart"},
        {box, "box", "the best of three cuts between opposite walls of the bounding box"}};
};

template <> struct Choices<Method> {
    using enum Method;
    static constexpr Choice<Method> all[]{{optimum, "optimum", "branch and bound, with a lower bound"},
                                          {naive, "naive", "all coordinate vectors, filtered"},
                                          {bounds, "bounds", "the paper's rules B1 to B4"},
                                          {improved, "improved", "the paper's improved algorithm"},
                                          {plain, "plain", "the plain motorcycle graph, as a baseline"}};
};

template <> struct Choices<PruneMethod> {
    using enum PruneMethod;
    static constexpr Choice<PruneMethod> all[]{
        {greedy, "greedy", "whole tracks, the most expensive first"},
        {optimum, "optimum", "the cheapest layout of grids, over the whole base complex"}};
};

template <> struct Choices<GraphClass> {
    using enum GraphClass;
    static constexpr Choice<GraphClass> all[]{
        {motorcycle, "motorcycle", "every track begins at a source"},
        {tmesh, "tmesh", "tracks may begin and end on others; often much cheaper, for whole meshes only"}};
};

template <> struct Choices<Fit> {
    using enum Fit;
    static constexpr Choice<Fit> all[]{
        {smooth, "smooth",
         "watertight, smooth across all borders that are not creases, within the tolerance"},
        {interpolate, "interpolate", "the paper's fit, through every vertex, each patch separately"}};
};

constexpr double smallestPositive = std::numeric_limits<double>::denorm_min();
constexpr double maxCount = 1e9;   ///< limit of any count that a user can ask for
constexpr double maxSamples = 1e6; ///< that are kept in memory until all are drawn
/// Price of a segment. Above it the solver is not precise enough, and only the number of segments counts
/// anyway.
constexpr double highestPrice = 1e4;

/// The conditions under which options have an effect. Every call lists some options, says in words what they
/// need, and whether that is true at present. Options that are not listed always have an effect.
template <class Options, class Visitor> void conditions(const Options&, Visitor&&) {}

template <class Visitor> void describe(FeatureOptions& options, Visitor&& option) {
    option("rho", options.rho, Range{0, std::numbers::pi},
           "edges of a curve have a dihedral angle above this, in radians");
    option("min-length", options.minLength, Range{0, infinity},
           "minimum length of a curve, in the mesh's unit or, with %, as a share of the bounding box's "
           "diagonal");
    option("min-distance", options.minDistance, Range{0, infinity},
           "minimum distance, along its line, of the ends of a curve from every extraordinary vertex, unless "
           "a sharp line crosses there (see --short-rho)");
    option("tau", options.tau, Range{1, maxCount},
           "minimum number of edges of a curve; the paper uses 15. With this option --min-length is 0 unless "
           "given, --max-roundness is 1 and --short-rho is pi");
    option("short-rho", options.shortRho, Range{0, std::numbers::pi},
           "a curve with fewer than tau edges counts if all of them have a dihedral angle above this, in "
           "radians, and it ends at the boundary or at other edges as sharp. Lines above rho, and above this "
           "on one side, divide the curves that they cross. Pi leaves out all such curves, and divides none");
    option("zeta", options.zeta, Range{0, maxCount},
           "the ends of a curve are more than this many edges, along its line, from every extraordinary "
           "vertex, unless a sharp line crosses there (see --short-rho); the paper uses 30. With this option "
           "--min-distance is 0 unless given");
    option("max-roundness", options.maxRoundness, Range{0, 1},
           "leave out curves beside which the surface bends by more than this share of their own bend, as it "
           "does on a tube of few quads around; 1 leaves out nothing");
}

template <class Visitor> void describe(CutOptions& options, Visitor&& option) {
    option("chi", options.chi, Range{0, infinity},
           "cut a sub-mesh as long as its quasi-complexity is at least this");
    option("terminals", options.terminals, Range{}, "how the source and sink of every cut are chosen");
    option("lambda", options.lambda, Range{0, infinity}, "weight of cutting a mesh edge");
    option("high-penalty", options.highPenalty, Range{0, infinity},
           "Wh, the cost of assigning a vertex near one terminal to the other");
    option("low-penalty", options.lowPenalty, Range{0, infinity},
           "Wl, the cost of assigning a vertex to a terminal that it is near");
    option("near-limit", options.nearLimit, Range{0, 1},
           "m1, the nearness up to which the high penalty applies");
    option("far-limit", options.farLimit, Range{0, 1},
           "m2, the nearness above which the low penalty applies");
    option("avoid-features", options.avoidFeatures, Range{},
           "make cutting across sharp edges more expensive");
}

template <class Visitor> void describe(EnumerationOptions& options, Visitor&& option) {
    option("alpha", options.cost.alpha, Range{}, "penalty of a flat edge");
    option("epsilon", options.cost.epsilon, Range{0, std::numbers::pi},
           "edges with a dihedral angle below this, in radians, are flat; 1 suits models with sharp edges");
    option("cost", options.cost.terms, Range{},
           "the cost to minimise: a sum, such as dihedral+0.5*segments, of the terms dihedral (angles of "
           "edges, with alpha and epsilon), length (of edges), segments (their number) and custom (weights "
           "of edges in the document)");
    option("class", options.graphClass, Range{}, "the class of graphs to search");
    option("method", options.method, Range{}, "the search method");
    option("best", options.best, Range{1, maxCount},
           "keep this many of the cheapest graphs of every sub-mesh");
    option("count", options.count, Range{}, "count the graphs of every sub-mesh exactly, up to --max-cost");
    option("sample", options.sample, Range{0, maxSamples},
           "draw this many graphs of every sub-mesh at random, all equally likely");
    option("seed", options.seed, Range{0, maxCount}, "seed of --sample");
    option("max-cost", options.maxCost, Range{}, "consider only graphs up to this cost in every sub-mesh");
    option("time-limit", options.timeLimit, Range{0, infinity},
           "stop after this many seconds with the best result so far");
    option("gap", options.gap, Range{0, infinity},
           "end the search of a sub-mesh when its cost is at most this much above the lower bound");
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
           "passes of the complete generator before the remaining free particles are extended straight on");
    option("improve", options.improve, Range{0, infinity},
           "improve the layout for up to this many seconds, and compute a lower bound of the best layout's "
           "cost");
    option("time-limit", options.timeLimit, Range{0, infinity},
           "stop after this many seconds with the best result so far");
}

template <class Visitor> void describe(PruneOptions& options, Visitor&& option) {
    option("method", options.method, Range{}, "how to choose what is removed");
    option("eta", options.eta, Range{}, "remove tracks that cost more than this; -3 suits soft models");
    option("smooth", options.smooth, Range{}, "do not apply the smoothness criterion");
    option("max-turn", options.maxTurn, Range{0, 180},
           "P, the largest angle by which a boundary may turn where a removed track ended, in degrees");
    option("min-corner", options.minCorner, Range{0, 90},
           "the smallest angle that a corner keeps beside a side that passes straight through an "
           "extraordinary vertex, in degrees; 0 as in the paper");
    option("max-sharp-turn", options.maxSharpTurn, Range{0, 180},
           "where sharp edges, or the mesh boundary, turn inside a side by more than this angle, in degrees, "
           "a track from there to the next boundary is added, as no smooth surface has a corner inside a "
           "side; with 180, as in the paper, none is added along sharp edges inside segments either");
    option("beta", options.beta, Range{0, highestPrice}, "with --method optimum: the price of a segment");
    option("fewest-patches", options.fewestPatches, Range{},
           "with --method optimum: minimise the number of segments first, then G_T");
    option("max-segments", options.maxSegments, Range{0, infinity},
           "with --method optimum: find the cheapest layout with at most this many segments, instead of "
           "pricing them");
    option("time-limit", options.timeLimit, Range{0, infinity},
           "with --method optimum or --front: stop after this many seconds with the best result so far");
    option("front", options.front, Range{},
           "list the best trade-offs between segments, G_T and captured sharpness, for prices of 1/16 to 64");
}

template <class Visitor> void conditions(const PruneOptions& options, Visitor&& needs) {
    const auto optimum = [&options] { return options.method == PruneMethod::optimum; };
    needs({"eta"}, "--method greedy", [&options] { return options.method == PruneMethod::greedy; });
    needs({"max-turn", "min-corner", "max-sharp-turn"}, "the smoothness criterion",
          [&options] { return options.smooth; });
    needs({"beta", "fewest-patches", "max-segments"}, "--method optimum", optimum);
    needs({"beta"}, "segments whose number is free",
          [&options] { return !options.fewestPatches && !std::isfinite(options.maxSegments); });
    needs({"time-limit"}, "--method optimum or --front",
          [&options] { return options.method == PruneMethod::optimum || options.front; });
}

template <class Visitor> void describe(FitOptions& options, Visitor&& option) {
    option("fit", options.fit, Range{}, "how surfaces are fitted to the mesh");
    option("tolerance", options.tolerance, Range{smallestPositive, infinity},
           "with --fit smooth: the largest distance between the surfaces and their reference (the smooth "
           "surface through the mesh's vertices; or the scan, whose noise is allowed in addition), in the "
           "mesh's unit or, with %, as a share of the bounding box's diagonal");
    option("rho", options.rho, Range{0, std::numbers::pi},
           "borders are smooth up to this dihedral angle, in radians, and beyond it where a coarse mesh "
           "bends as much beside them");
    option("time-limit", options.timeLimit, Range{0, infinity},
           "with --fit smooth: stop after this many seconds with the best result so far");
}

template <class Visitor> void conditions(const FitOptions& options, Visitor&& needs) {
    needs({"tolerance", "time-limit"}, "--fit smooth", [&options] { return options.fit == Fit::smooth; });
}

} // namespace qm
