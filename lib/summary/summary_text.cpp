#include "base/joined.h"
#include "base/number_text.h"
#include "summary/figure_text.h"
#include "summary/summary.h"

#include <algorithm>
#include <span>

namespace qm {
namespace {

constexpr std::size_t loopsShown = 4;

std::string line(const std::string& label, const std::string& text) {
    return label + std::string(12 - label.size(), ' ') + text + "\n";
}

std::string sizeText(const Summary& summary, const std::string& unit) {
    return figureText(summary.size[0]) + " x " + figureText(summary.size[1]) + " x " +
           figureText(summary.size[2]) + " " + unit;
}

/// "2 open loops, 12.3, 4.5 mm long".
std::string loopsText(const Summary& summary, const std::string& unit) {
    const auto first = std::span(summary.loops).first(std::min(summary.loops.size(), loopsShown));
    return countText(summary.loops.size(), "open loop") + ", " +
           joined(first, ", ", [](const BoundaryLoop& loop) { return figureText(loop.length); }) +
           (first.size() < summary.loops.size() ? ", ... " : " ") + unit + " long";
}

std::string shapeText(const Summary& summary, const std::string& unit) {
    if (!summary.loops.empty()) return (summary.fit ? "shell, " : "") + loopsText(summary, unit);
    if (isSolid(summary)) {
        const std::size_t solids = summary.pieces - summary.cavities;
        std::string text = solids == 1 ? "solid" : countText(solids, "solid");
        const std::string joined = solids == 1 ? " with " : " and "; // of several, one may have all of them
        if (summary.cavities == 1) text += joined + "a cavity";
        if (summary.cavities > 1) text += joined + std::to_string(summary.cavities) + " cavities";
        return text;
    }
    return summary.fit ? "closed, but patches are apart" : "closed";
}

/// Per cent of the tolerance; more than 100 wherever it is missed.
std::string shareText(const FitSummary& fit) {
    const double percent = 100 * fit.deviation.max / fit.tolerance;
    return fit.deviation.max > fit.tolerance ? figuresApart(percent, 100)[0] : figureText(percent);
}

std::string deviationLines(const FitSummary& fit, double diagonal, const std::string& unit) {
    std::string text = figureText(fit.deviation.max) + " " + unit + (fit.scan ? " without it" : "");
    if (fit.smooth)
        text += ", " + shareText(fit) + "% of the tolerance, " + figureText(fit.tolerance) + " " + unit;
    text = line("deviation", text) + line("  largest", placeText(fit.farthest, diagonal));
    // Of fine meshes it is about the same; between the vertices of coarse ones, a smooth surface bulges.
    if (fit.smooth && !fit.scan && fit.deviation.maxFromFacets > fit.tolerance)
        text += line("  facets", "up to " + figureText(fit.deviation.maxFromFacets) + " " + unit +
                                     " from the mesh's quads themselves");
    return text;
}

/// How much of the mesh the scan shows is never rounded to all of it.
std::string scanLines(const ScanFigures& scan, const std::string& unit) {
    const double shown = scan.coverage < 1 ? std::min(100 * scan.coverage, 99.9) : 100;
    return line("scan", "shows " + figureText(shown) + "% of the mesh, noise " + figureText(scan.noise) +
                            " " + unit) +
           line("  distance", "with its noise " + figureText(scan.rms) + " " + unit + " RMS, 95% " +
                                  figureText(scan.percentile95) + ", at most " + figureText(scan.max));
}

std::string normalsText(const Deviation& deviation) {
    if (deviation.largestNormalAngle == 0) return "agree across all smooth borders";
    return "differ by " + figureText(deviation.largestNormalAngle) + " degrees at most, 95% by less than " +
           figureText(deviation.percentile95NormalAngle);
}

std::string fitLines(const FitSummary& fit, double diagonal, const std::string& unit) {
    std::string text = (fit.scan ? scanLines(*fit.scan, unit) : "") + deviationLines(fit, diagonal, unit) +
                       line("gap", figureText(fit.deviation.largestGap) + " " + unit) +
                       line("normals", normalsText(fit.deviation));
    if (fit.deviation.folds > 0)
        text += line("folds", countText(fit.deviation.folds, "piece") + " of patches may fold over");
    if (fit.fold) text += line("  first", placeText(*fit.fold, diagonal));
    if (fit.bridged)
        text += line("vertices", "up to " + figureText(fit.bridged->distance) + " " + unit +
                                     " away where quads fold or nearly fold, patch " +
                                     std::to_string(fit.bridged->patch));
    return text;
}

} // namespace

std::string summaryText(const Summary& summary, const std::string& name, const std::string& unit,
                        std::optional<double> seconds) {
    std::string text =
        line("mesh", name) +
        line("quads", std::to_string(summary.quads) + " in " + countText(summary.pieces, "piece")) +
        line("size", sizeText(summary, unit));
    if (summary.patches) text += line("patches", std::to_string(*summary.patches));
    if (summary.fit) text += fitLines(*summary.fit, summary.diagonal, unit);
    text += line("shape", shapeText(summary, unit));
    if (seconds) text += line("seconds", figureText(*seconds));
    return text;
}

} // namespace qm
