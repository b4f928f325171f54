#include "summary/summary.h"

#include "base/positions.h"
#include "bspline/splines/evaluate.h"
#include "mesh/bounding_box.h"
#include "mesh/nesting.h"
#include "mesh/topology.h"
#include "summary/figure_text.h"

#include <algorithm>

namespace qm {
namespace {

/// The number of those of a closed mesh's pieces that are cavities of others.
std::size_t cavityCount(const QuadMesh& mesh) {
    const auto isCavity = [](const Nesting& nesting) { return nesting.cavityOf.has_value(); };
    return countWhere(nestingOf(mesh, closedComponents(mesh)), isCavity);
}

std::string missedTolerance(const Summary& summary, const std::string& unit) {
    const FitSummary& fit = *summary.fit;
    const auto [found, allowed] = figuresApart(fit.deviation.max, fit.tolerance);
    return "the tolerance is missed: " + found + unit + " where " + allowed + unit + " are allowed, " +
           placeText(fit.farthest, summary.diagonal) + ". Allow more, or " +
           (fit.scan ? "make more quads of the scan" : "mend the mesh there");
}

/// A scan that is farther away somewhere than its noise explains shows what the surfaces do not: of many
/// vertices' noise the largest is five times that of one, which is 1.4 times that within triangles.
double farFromScan(const FitSummary& fit) {
    constexpr double timesAllowed = 2;
    constexpr double timesNoise = 7;
    return timesAllowed * fit.tolerance + timesNoise * fit.scan->noise;
}

std::string scanTooFarAway(const Summary& summary, const std::string& unit) {
    const FitSummary& fit = *summary.fit;
    const auto [found, explained] = figuresApart(fit.scan->max, farFromScan(fit));
    return "the scan is up to " + found + unit + " away where tolerance and noise explain " + explained +
           unit + ", " + placeText(fit.farthestFromScan, summary.diagonal) +
           ": it shows something there that the quads do not. Make more quads of it, or mend it";
}

} // namespace

std::optional<BridgedVertex> bridgedVertex(const Surfaces& surfaces, double allowed) {
    const Deviation& deviation = surfaces.deviation;
    if (surfaces.scan || deviation.maxFromVertices <= std::max(deviation.max, allowed)) return std::nullopt;
    const auto farthest = std::ranges::max_element(surfaces.ofPatch, {}, &Deviation::maxFromVertices);
    return BridgedVertex{deviation.maxFromVertices, positionIn(surfaces.ofPatch, farthest)};
}

Summary summarise(const QuadMesh& mesh, const Layout* layout, const Surfaces* surfaces,
                  const FitOptions& fit) {
    Summary summary;
    summary.quads = mesh.n_faces();
    summary.vertices = mesh.n_vertices();
    summary.pieces = pieceCount(mesh);
    summary.loops = boundaryLoops(mesh);
    if (summary.loops.empty() && summary.pieces > 1) summary.cavities = cavityCount(mesh);
    const BoundingBox box = boundingBox(mesh);
    const Point size = box.size();
    summary.size = {size[0], size[1], size[2]};
    summary.diagonal = box.diagonal();
    if (layout != nullptr) summary.patches = layout->segments.size();
    if (surfaces == nullptr || surfaces->patches.empty()) return summary;
    FitSummary& figures = summary.fit.emplace();
    figures.smooth = fit.fit == Fit::smooth;
    figures.tolerance = allowedDistance(*surfaces, fit, summary.diagonal);
    figures.deviation = surfaces->deviation;
    figures.scan = surfaces->scan;
    const auto withPoint = [&](const LayoutPlace& place) {
        return SurfacePlace{place, pointAt(surfaces->patches, place)};
    };
    figures.farthest = withPoint(surfaces->farthest);
    if (figures.scan) figures.farthestFromScan = withPoint(figures.scan->farthest);
    if (!surfaces->folds.empty()) figures.fold = withPoint(surfaces->folds.front());
    if (figures.smooth) figures.bridged = bridgedVertex(*surfaces, figures.tolerance);
    return summary;
}

bool isSolid(const Summary& summary) {
    return summary.fit && summary.loops.empty() && summary.fit->deviation.largestGap <= stepTolerance;
}

std::vector<std::string> unmetLimits(const Summary& summary, const Limits& limits, const std::string& unit) {
    std::vector<std::string> unmet;
    const std::string length = " " + unit;
    if (limits.maxPatches && summary.patches && *summary.patches > *limits.maxPatches)
        unmet.push_back("there are " + std::to_string(*summary.patches) + " patches where " +
                        std::to_string(*limits.maxPatches) + " are allowed. Allow more, or smooth the mesh");
    if (!summary.fit || !summary.fit->smooth) return unmet;
    const FitSummary& fit = *summary.fit;
    if (fit.deviation.max > fit.tolerance)
        unmet.push_back(missedTolerance(summary, length));
    else if (fit.scan && fit.scan->max > farFromScan(fit))
        unmet.push_back(scanTooFarAway(summary, length));
    if (fit.deviation.largestNormalAngle > limits.maxNormalAngle) {
        const auto [found, allowed] = figuresApart(fit.deviation.largestNormalAngle, limits.maxNormalAngle);
        unmet.push_back("normals differ by " + found + " degrees across a smooth border where " + allowed +
                        " are allowed. Give a larger tolerance, or a finer mesh");
    }
    if (summary.loops.empty() && !isSolid(summary))
        unmet.push_back("patches are " + figureText(fit.deviation.largestGap) + length +
                        " apart, so the closed mesh gives no solid. Scale it down, or move it to the origin");
    return unmet;
}

} // namespace qm
