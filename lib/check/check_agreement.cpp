#include "base/number_text.h"
#include "check/check_sections.h"
#include "check/surfaces/bilinear_quad.h"
#include "check/surfaces/mesh_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace qm::check {
namespace {

using Figures = SurfacesPart::Figures;
using Names = std::pair<const char*, const char*>;

/// Relative: of what is computed twice.
constexpr double rounding = 1e-9;

/// A mean, or a percentile, and the maximum of the same values.
constexpr std::array<Names, 4> ofLengths{{{"rms", "max"},
                                          {"percentile95", "max"},
                                          {"rmsFromFacets", "maxFromFacets"},
                                          {"rmsFromVertices", "maxFromVertices"}}};
constexpr std::array<Names, 3> ofAngles{{{"rmsNormalAngle", "largestNormalAngle"},
                                         {"percentile95NormalAngle", "largestNormalAngle"},
                                         {"rmsNormalDeviation", "largestNormalDeviation"}}};

/// A relative length, and the length.
constexpr std::array<Names, 4> relativeLengths{{{"maxRelative", "max"},
                                                {"rmsRelative", "rms"},
                                                {"percentile95Relative", "percentile95"},
                                                {"largestGapRelative", "largestGap"}}};

constexpr std::array<const char*, 7> maxima{"max",
                                            "maxFromFacets",
                                            "maxFromVertices",
                                            "largestGap",
                                            "largestNormalAngle",
                                            "largestInnerNormalAngle",
                                            "largestNormalDeviation"};

/// Whether no quad is folded or has a corner that is so flat, seen along the quad's normal, that the vertices
/// around it may have been moved before the fit.
bool hasOnlySoundCorners(const CheckedMesh& mesh) {
    constexpr double minSine = 0.14; // of 8 degrees
    for (std::size_t face = 0; face < mesh.quads.size(); ++face)
        if (!quadOf(mesh, static_cast<int>(face)).isConvex(minSine)) return false;
    return true;
}

class Agreement {
public:
    Agreement(const CheckedMesh& mesh, const SurfacesPart& part, Report& report)
        : mesh_(mesh), part_(part), report_(report), samePlace_(samePlace(mesh)) {}

    void run() {
        const double diagonal = boundingBoxDiagonal(mesh_);
        for (std::size_t p = 0; p < part_.patches.size(); ++p)
            ofOne(part_.patches[p].figures, below("/surfaces/patches", p, "deviation"), diagonal);
        ofOne(part_.figures, all, diagonal);
        for (const char* figure : maxima)
            total(figure, [](double sum, double next) { return std::max(sum, next); });
        total("folds", [](double sum, double next) { return sum + next; });
        fromVertices();
    }

private:
    static constexpr const char* all = "/surfaces/deviation";

    void ofOne(const Figures& figures, const std::string& pointer, double diagonal) {
        constexpr double sameAngle = 1e-5;  // degrees
        constexpr double negligible = 1e-5; // of the diagonal: no closer are maxima determined
        for (const Names& names : ofLengths)
            notAbove(names, figures, negligible * diagonal, pointer);
        for (const Names& names : ofAngles)
            notAbove(names, figures, sameAngle, pointer);
        for (const auto& [relative, absolute] : relativeLengths) {
            const auto share = figures[relative], length = figures[absolute];
            if (!share || !length) continue;
            const double product = *share * diagonal;
            if (std::abs(product - *length) <= rounding * std::max(product, *length)) continue;
            report_.violate(below(pointer, relative), "deviation",
                            "'" + std::string(absolute) + "' is " + numberText(*length) +
                                ", and the diagonal " + numberText(diagonal));
        }
    }

    /// \param slack  because means and maxima are measured in different ways
    void notAbove(const Names& names, const Figures& figures, double slack, const std::string& pointer) {
        const auto& [ofMean, ofMaximum] = names;
        const auto mean = figures[ofMean], maximum = figures[ofMaximum];
        if (mean && maximum && *mean > *maximum + slack)
            report_.violate(below(pointer, ofMean), "deviation",
                            std::string("it is above '") + ofMaximum + "'");
    }

    /// What is stated of all patches together is what is stated of each.
    template <class Combine> void total(const char* figure, const Combine& combine) {
        const auto stated = part_.figures[figure];
        if (!stated) return;
        double found = 0;
        for (const auto& patch : part_.patches) {
            const auto ofPatch = patch.figures[figure];
            if (!ofPatch) return;
            found = combine(found, *ofPatch);
        }
        if (found != *stated)
            report_.violate(below(all, figure), "deviation",
                            "by the figures of the patches it is " + numberText(found));
    }

    /// The reference passes through the vertices (where plane parts were evened, in other places of the same
    /// plane), unless it is a scan or folded quads have been bridged; so no vertex is farther from the
    /// surfaces than the reference is.
    void fromVertices() {
        const auto max = part_.figures["max"], maxFromVertices = part_.figures["maxFromVertices"];
        if (part_.isOfScan || !max || !maxFromVertices) return;
        constexpr double unsure = 1e-4;
        if (*maxFromVertices <= (1 + unsure) * *max + samePlace_) return;
        if (hasOnlySoundCorners(mesh_))
            report_.violate(below(all, "max"), "deviation",
                            "a vertex, which the reference passes through, is " +
                                numberText(*maxFromVertices) + " away");
    }

    const CheckedMesh& mesh_;
    const SurfacesPart& part_;
    Report& report_;
    double samePlace_;
};

} // namespace

void checkAgreement(const CheckedMesh& mesh, const SurfacesPart& part, Report& report) {
    Agreement(mesh, part, report).run();
}

} // namespace qm::check
