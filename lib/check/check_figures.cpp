#include "base/at.h"
#include "base/number_text.h"
#include "check/check_sections.h"
#include "check/surfaces/bilinear_quad.h"
#include "check/surfaces/distance.h"
#include "check/surfaces/distance_to_surfaces.h"
#include "check/surfaces/folds.h"
#include "check/surfaces/spline.h"
#include "check/tracks/check_segments.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace qm::check {
namespace {

using Patch = SurfacesPart::Patch;
using Figures = SurfacesPart::Figures;
using Parameters = std::array<double, 2>;

class FigureCheck {
public:
    FigureCheck(const Context& context, const LayoutPart& layout, const SurfacesPart& part, Report& report)
        : mesh_(context.mesh), around_(context.around), angles_(context.angles), layout_(layout), part_(part),
          report_(report), surfaces_(context, layout, part) {}

    void run() {
        for (std::size_t p = 0; p < part_.patches.size(); ++p)
            patchFigures(p);
    }

private:
    bool compare(std::size_t p, const char* figure, const std::optional<double>& stated, double found,
                 double slack, const std::string& where) {
        return checkFigure(p, figure, stated, found, slack, where, report_);
    }

    void patchFigures(std::size_t p) {
        const auto& segment = layout_.segments[p];
        Report unused;
        const std::vector<int> vertices = gridOf(mesh_, segment, "", unused);
        for (int row = 0; row < segment.size[1]; ++row)
            if (!rowFigures(p, vertices, row)) return;
    }

    /// A row of quads.
    /// \return false if something was wrong
    bool rowFigures(std::size_t p, const std::vector<int>& vertices, int row) {
        const auto& [columns, rows] = layout_.segments[p].size;
        std::vector<double> us;
        std::vector<double> vs;
        for (int i = 0; i <= columns * samplesPerEdge; ++i)
            us.push_back(static_cast<double>(i) / samplesPerEdge);
        for (int j = 0; j <= samplesPerEdge; ++j)
            vs.push_back(row + static_cast<double>(j) / samplesPerEdge);
        const auto points = evaluateLattice(part_.patches[p], us, vs);
        for (int column = 0; column < columns; ++column) {
            const Cell cell = cellAt(p, vertices, column, row);
            const QuadSamples samples{points, us.size(), at(column * samplesPerEdge)};
            if (anyTooFar(p, cell, samples, {column + 1 == columns, row + 1 == rows})) return false;
            if (anyFold(p, cell, samples)) return false;
        }
        return true;
    }

    /// A quad of a segment, with its corners in the segment's order.
    struct Cell {
        BilinearQuad quad;
        int face = -1;
        int column = 0;
        int row = 0;
    };

    [[nodiscard]] Cell cellAt(std::size_t p, const std::vector<int>& vertices, int column, int row) const {
        const int columns = layout_.segments[p].size[0];
        const std::size_t low = at(row * (columns + 1) + column);
        const std::size_t high = low + at(columns) + 1;
        const auto point = [&](std::size_t k) { return mesh_.points[at(vertices[k])]; };
        return {{{point(low), point(low + 1), point(high + 1), point(high)}},
                layout_.segments[p].faces[at(row * columns + column)],
                column,
                row};
    }

    /// \param isLast  of its row and of its column: a cell before it shares the samples of the side between
    bool anyTooFar(std::size_t p, const Cell& cell, const QuadSamples& samples,
                   const std::array<bool, 2>& isLast) {
        for (int j = 0; j < samplesPerEdge + (isLast[1] ? 1 : 0); ++j)
            for (int i = 0; i < samplesPerEdge + (isLast[0] ? 1 : 0); ++i)
                if (isTooFar(p, cell, i, j, samples.at(i, j).point)) return true;
        return false;
    }

    /// Share of a distance by which two searches for the nearest point may differ.
    static constexpr double unsure = 1e-4;

    bool isTooFar(std::size_t p, const Cell& cell, int i, int j, const Place& on) {
        const Figures& figures = part_.patches[p].figures;
        const double s = static_cast<double>(i) / samplesPerEdge;
        const double t = static_cast<double>(j) / samplesPerEdge;
        const Place of = cell.quad.at(s, t);
        const double plain = distance(of, on);
        const Parameters parameters{cell.column + s, cell.row + t};
        const double rounding = 1e-12 * cell.quad.largestCoordinate();
        const auto slackOf = [&](double stated) { return rounding + unsure * stated; };
        const auto& fromFacets = figures.maxFromFacets;
        if (fromFacets && plain > *fromFacets + slackOf(*fromFacets)) {
            const double slack = slackOf(*fromFacets);
            const double limit = *fromFacets + slack;
            double error = distanceToFace(mesh_, cell.face, startIn(cell, s, t), on);
            if (error > limit) error = distanceToMesh(mesh_, around_, cell.face, on);
            if (error <= limit) error = surfaces_.distanceFrom(of, cell.face, p, parameters, limit);
            if (compare(p, "maxFromFacets", fromFacets, error, slack, placeOf(cell))) return true;
        }
        const auto& fromVertices = figures.maxFromVertices;
        const bool atVertex = i % samplesPerEdge == 0 && j % samplesPerEdge == 0;
        if (!atVertex || !fromVertices || plain <= *fromVertices + slackOf(*fromVertices)) return false;
        const double slack = slackOf(*fromVertices);
        const double error = surfaces_.distanceFrom(of, cell.face, p, parameters, *fromVertices + slack);
        return compare(p, "maxFromVertices", fromVertices, error, slack, placeOf(cell));
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

    bool anyFold(std::size_t p, const Cell& cell, const QuadSamples& samples) {
        if (part_.patches[p].figures.folds.value_or(1) > 0) return false;
        if (!cell.quad.isConvex() || liesAgainstNeighbour(mesh_, around_, angles_, cell.face)) return false;
        if (!isFolded(cell.quad, samples)) return false;
        report_.violate(below(below(below("/surfaces/patches", p), "deviation"), "folds"), "deviation",
                        "the normal turns over " + placeOf(cell));
        return true;
    }

    const CheckedMesh& mesh_;
    const Neighbourhoods& around_;
    const Angles& angles_;
    const LayoutPart& layout_;
    const SurfacesPart& part_;
    Report& report_;
    DistanceToSurfaces surfaces_;
};

} // namespace

void checkFigures(const Context& context, const LayoutPart& layout, const SurfacesPart& part,
                  Report& report) {
    FigureCheck(context, layout, part, report).run();
    checkMeetings(context, layout, part, report);
    checkAgreement(context.mesh, part, report);
}

} // namespace qm::check
