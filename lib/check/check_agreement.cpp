#include "base/number_text.h"
#include "check/check_sections.h"
#include "check/mesh/vectors.h"
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
    for (std::size_t face = 0; face < mesh.quads.size(); ++face) {
        const BilinearQuad quad = quadOf(mesh, static_cast<int>(face));
        const Vector normal = quad.normal();
        const double size = length(normal);
        for (std::size_t k = 0; k < 4; ++k) {
            const Vector to = minus(quad.corners[(k + 1) % 4], quad.corners[k]);
            const Vector from = minus(quad.corners[(k + 3) % 4], quad.corners[k]);
            if (!(dot(cross(to, from), normal) > minSine * size * length(to) * length(from))) return false;
        }
    }
    return true;
}

class Agreement {
public:
    Agreement(const CheckedMesh& mesh, const SurfacesPart& part, Report& report)
        : mesh_(mesh), part_(part), report_(report), samePlace_(samePlace(mesh)) {}

    void run() {
        const double diagonal = boundingBoxDiagonal(mesh_);
        for (std::size_t p = 0; p < part_.patches.size(); ++p)
            ofOne(part_.patches[p].figures, below(below("/surfaces/patches", p), "deviation"), diagonal);
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
            mean(names, figures, negligible * diagonal, pointer);
        for (const Names& names : ofAngles)
            mean(names, figures, sameAngle, pointer);
        for (const auto& [relative, absolute] : relativeLengths) {
            if (!figures.has(relative) || !figures.has(absolute)) continue;
            const double product = figures.at(relative) * diagonal;
            if (std::abs(product - figures.at(absolute)) <=
                rounding * std::max(product, figures.at(absolute)))
                continue;
            report_.violate(below(pointer, relative), "deviation",
                            "'" + std::string(absolute) + "' is " + numberText(figures.at(absolute)) +
                                ", and the diagonal " + numberText(diagonal));
        }
    }

    /// \param slack  because means and maxima are measured in different ways
    void mean(const Names& names, const Figures& figures, double slack, const std::string& pointer) {
        const auto& [mean, maximum] = names;
        if (figures.has(mean) && figures.has(maximum) && figures.at(mean) > figures.at(maximum) + slack)
            report_.violate(below(pointer, mean), "deviation", std::string("it is above '") + maximum + "'");
    }

    /// What is stated of all patches together is what is stated of each.
    template <class Combine> void total(const char* figure, const Combine& combine) {
        if (!part_.figures.has(figure)) return;
        double found = 0;
        for (const auto& patch : part_.patches) {
            if (!patch.figures.has(figure)) return;
            found = combine(found, patch.figures.at(figure));
        }
        if (found != part_.figures.at(figure))
            report_.violate(below(all, figure), "deviation",
                            "by the figures of the patches it is " + numberText(found));
    }

    /// The reference passes through the vertices, unless it is a scan or folded quads have been bridged; so
    /// no vertex is farther from the surfaces than the reference is.
    void fromVertices() {
        const Figures& figures = part_.figures;
        if (part_.isOfScan || !figures.has("max") || !figures.has("maxFromVertices")) return;
        constexpr double unsure = 1e-4;
        if (figures.at("maxFromVertices") <= (1 + unsure) * figures.at("max") + samePlace_) return;
        if (hasOnlySoundCorners(mesh_))
            report_.violate(below(all, "max"), "deviation",
                            "a vertex, which the reference passes through, is " +
                                numberText(figures.at("maxFromVertices")) + " away");
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
