#include "base/at.h"
#include "base/parallel.h"
#include "check/check_sections.h"
#include "check/surfaces/bilinear_quad.h"
#include "check/surfaces/distance.h"
#include "check/surfaces/folds.h"
#include "check/surfaces/spline.h"
#include "check/tracks/check_segments.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace qm::check {
namespace {

/// In both directions.
struct Distances {
    DistanceToMesh toMesh;
    DistanceToSurfaces toSurfaces;
};

/// The figures of one patch that concern its distance from the mesh, and its folds.
class PatchCheck {
public:
    PatchCheck(const Context& context, const LayoutPart& layout, const SurfacesPart& part, std::size_t patch,
               const Distances& distances)
        : mesh_(context.mesh), around_(context.around), angles_(context.angles), part_(part), patch_(patch),
          segment_(layout.segments[patch]), distances_(distances), vertices_(soundGridOf(mesh_, segment_)),
          fromFacets_(part.patches[patch].figures["maxFromFacets"]),
          fromVertices_(part.patches[patch].figures["maxFromVertices"]),
          mayFold_(part.patches[patch].figures["folds"].value_or(1) > 0) {}

    /// Up to the first violation.
    Report run() {
        for (int row = 0; row < segment_.size[1]; ++row)
            if (!checkRow(row)) break;
        return std::move(report_);
    }

private:
    /// A row of quads, piece by piece: the samples of a quad take 20 kB.
    /// \return false if something was wrong
    bool checkRow(int row) {
        constexpr int wanted = 64;
        const int columns = segment_.size[0];
        for (int begin = 0; begin < columns; begin += wanted)
            if (!checkPiece(row, begin, std::min(begin + wanted, columns))) return false;
        return true;
    }

    /// The quads of a row from one column up to but not including another.
    bool checkPiece(int row, int begin, int end) {
        const auto& [columns, rows] = segment_.size;
        std::vector<double> us;
        std::vector<double> vs;
        for (int i = begin * samplesPerEdge; i <= end * samplesPerEdge; ++i)
            us.push_back(static_cast<double>(i) / samplesPerEdge);
        for (int j = 0; j <= samplesPerEdge; ++j)
            vs.push_back(row + static_cast<double>(j) / samplesPerEdge);
        const auto points = evaluateLattice(part_.patches[patch_], us, vs);
        for (int column = begin; column < end; ++column) {
            const Cell cell = cellAt(column, row);
            const QuadSamples samples{points, us.size(), at((column - begin) * samplesPerEdge)};
            if (anyTooFar(cell, samples, {column + 1 == columns, row + 1 == rows})) return false;
            if (anyFold(cell, samples)) return false;
        }
        return true;
    }

    /// A quad of the segment, with its corners in the segment's order.
    struct Cell {
        BilinearQuad quad;
        int face = -1;
        int column = 0;
        int row = 0;
    };

    [[nodiscard]] Cell cellAt(int column, int row) const {
        const int columns = segment_.size[0];
        const std::size_t low = at(row * (columns + 1) + column);
        const std::size_t high = low + at(columns) + 1;
        const auto point = [&](std::size_t k) { return mesh_.points[at(vertices_[k])]; };
        return {{{point(low), point(low + 1), point(high + 1), point(high)}},
                segment_.faces[at(row * columns + column)],
                column,
                row};
    }

    /// \param isLast  of its row and of its column: a cell before it shares the samples of the side between
    bool anyTooFar(const Cell& cell, const QuadSamples& samples, const std::array<bool, 2>& isLast) {
        for (int j = 0; j < samplesPerEdge + (isLast[1] ? 1 : 0); ++j)
            for (int i = 0; i < samplesPerEdge + (isLast[0] ? 1 : 0); ++i)
                if (isTooFar(cell, i, j, samples.at(i, j).point)) return true;
        return false;
    }

    bool isTooFar(const Cell& cell, int i, int j, const Place& on) {
        // Share of a distance by which two searches for the nearest point may differ.
        constexpr double unsure = 1e-4;
        const double s = static_cast<double>(i) / samplesPerEdge;
        const double t = static_cast<double>(j) / samplesPerEdge;
        const Place of = cell.quad.at(s, t);
        const double plain = distance(of, on);
        const double rounding = 1e-12 * largestCoordinate(cell.quad.corners);
        const auto slackOf = [&](double stated) { return rounding + unsure * stated; };
        if (fromFacets_ && plain > *fromFacets_ + slackOf(*fromFacets_)) {
            const double slack = slackOf(*fromFacets_);
            const double limit = *fromFacets_ + slack;
            double error = distances_.toMesh.from(on, cell.face, startIn(cell, s, t), limit, lastOfMesh_);
            if (error <= limit)
                error = distances_.toSurfaces.from(of, cell.face, {s, t}, limit, lastOfSurfaces_);
            if (checkFigure(part_, patch_, {"maxFromFacets", error, slack, placeOf(cell)}, report_))
                return true;
        }
        const bool atVertex = i % samplesPerEdge == 0 && j % samplesPerEdge == 0;
        if (!atVertex || !fromVertices_ || plain <= *fromVertices_ + slackOf(*fromVertices_)) return false;
        const double slack = slackOf(*fromVertices_);
        const double error =
            distances_.toSurfaces.from(of, cell.face, {s, t}, *fromVertices_ + slack, lastOfSurfaces_);
        return checkFigure(part_, patch_, {"maxFromVertices", error, slack, placeOf(cell)}, report_);
    }

    [[nodiscard]] static std::string placeOf(const Cell& cell) {
        return "at face " + std::to_string(cell.face);
    }

    /// From the segment's parameters in a quad to those of the face, which may begin at another corner.
    [[nodiscard]] Parameters startIn(const Cell& cell, double s, double t) const {
        const auto& face = mesh_.quads[at(cell.face)];
        std::size_t turns = 0;
        while (turns < 3 && mesh_.points[at(face[turns])] != cell.quad.corners[0])
            ++turns;
        for (std::size_t k = 0; k < turns; ++k) {
            const double turned = 1 - t;
            t = s;
            s = turned;
        }
        return {s, t};
    }

    bool anyFold(const Cell& cell, const QuadSamples& samples) {
        if (mayFold_ || !cell.quad.isConvex() || liesAgainstNeighbour(mesh_, around_, angles_, cell.face) ||
            !isFolded(cell.quad, samples))
            return false;
        report_.violate(below("/surfaces/patches", patch_, "deviation", "folds"), "deviation",
                        "the normal turns over " + placeOf(cell));
        return true;
    }

    const CheckedMesh& mesh_;
    const Neighbourhoods& around_;
    const Angles& angles_;
    const SurfacesPart& part_;
    std::size_t patch_;
    const LayoutPart::Segment& segment_;
    const Distances& distances_;
    Report report_;
    std::vector<int> vertices_;                       ///< of the segment's grid
    std::optional<double> fromFacets_, fromVertices_; ///< as stated
    bool mayFold_;
    LastFace lastOfMesh_, lastOfSurfaces_;
};

} // namespace

void checkFigures(const Context& context, const LayoutPart& layout, const SurfacesPart& part, unsigned jobs,
                  Report& report) {
    const Distances distances{{context.mesh, context.around}, {context.mesh, context.around, layout, part}};
    std::vector<Report> ofPatch(part.patches.size());
    parallelFor(ofPatch.size(), jobs, [&](std::size_t patch) {
        ofPatch[patch] = PatchCheck(context, layout, part, patch, distances).run();
    });
    for (const Report& one : ofPatch)
        report.add(one);
    checkMeetings(context, layout, part, report);
    checkAgreement(context.mesh, part, report);
}

} // namespace qm::check
