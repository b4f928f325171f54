#include "base/at.h"
#include "base/number_text.h"
#include "check/check_sections.h"
#include "check/check_segments.h"
#include "check/distance.h"
#include "check/distance_to_surfaces.h"
#include "check/spline.h"

#include <algorithm>
#include <cmath>

namespace qm::check {
namespace {

using Patch = SurfacesPart::Patch;
using Figures = SurfacesPart::Figures;
using Parameters = std::array<double, 2>;

constexpr int perEdge = 16;

double dot(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Place cross(const Place& a, const Place& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Place normalOf(const SurfacePoint& at) {
    return cross(at.alongU, at.alongV);
}

class FigureCheck {
public:
    FigureCheck(const Context& context, const LayoutPart& layout, const SurfacesPart& part, Report& report)
        : mesh_(context.mesh), around_(context.around), angles_(context.angles), layout_(layout), part_(part),
          report_(report), surfaces_(context, layout, part) {}

    void run() {
        for (std::size_t p = 0; p < part_.patches.size(); ++p)
            patchFigures(p);
        totals();
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
        const Patch& patch = part_.patches[p];
        const auto& [columns, rows] = layout_.segments[p].size;
        std::vector<double> us;
        std::vector<double> vs;
        for (int i = 0; i <= columns * perEdge; ++i)
            us.push_back(static_cast<double>(i) / perEdge);
        for (int j = 0; j <= perEdge; ++j)
            vs.push_back(row + static_cast<double>(j) / perEdge);
        const auto points = evaluateLattice(patch, us, vs);
        const std::size_t width = us.size();
        for (int column = 0; column < columns; ++column) {
            const std::size_t low = at(row * (columns + 1) + column);
            const std::size_t high = low + at(columns) + 1;
            const Quad quad{{mesh_.points[at(vertices[low])], mesh_.points[at(vertices[low + 1])],
                             mesh_.points[at(vertices[high + 1])], mesh_.points[at(vertices[high])]},
                            layout_.segments[p].faces[at(row * columns + column)]};
            const bool last = column + 1 == columns;
            const bool top = row + 1 == rows;
            for (int j = 0; j < (top ? perEdge + 1 : perEdge); ++j)
                for (int i = 0; i < (last ? perEdge + 1 : perEdge); ++i) {
                    const SurfacePoint& on = points[at(j) * width + at(column * perEdge + i)];
                    if (isTooFar(p, quad, {column, row}, i, j, on)) return false;
                }
            if (isFolded(p, quad, points, width, column)) return false;
        }
        return true;
    }

    struct Quad {
        std::array<Place, 4> corners;
        int face;

        [[nodiscard]] Place at(double s, double t) const {
            Place sum{};
            const std::array<double, 4> weight{(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    sum[k] += weight[i] * corners[i][k];
            return sum;
        }
        [[nodiscard]] Place normal() const {
            Place diagonal{};
            Place other{};
            for (std::size_t k = 0; k < 3; ++k) {
                diagonal[k] = corners[2][k] - corners[0][k];
                other[k] = corners[3][k] - corners[1][k];
            }
            return cross(diagonal, other);
        }
        /// At every corner it faces the same way.
        [[nodiscard]] bool isConvex() const {
            const Place outwards = normal();
            for (std::size_t k = 0; k < 4; ++k) {
                Place next{};
                Place before{};
                for (std::size_t i = 0; i < 3; ++i) {
                    next[i] = corners[(k + 1) % 4][i] - corners[k][i];
                    before[i] = corners[(k + 3) % 4][i] - corners[k][i];
                }
                if (!(dot(cross(next, before), outwards) > 0)) return false;
            }
            return true;
        }
    };

    /// Of a distance: what two searches for the nearest point may differ by.
    static constexpr double unsure = 1e-4;

    bool isTooFar(std::size_t p, const Quad& quad, const std::array<int, 2>& cell, int i, int j,
                  const SurfacePoint& on) {
        const Patch& patch = part_.patches[p];
        const double s = static_cast<double>(i) / perEdge;
        const double t = static_cast<double>(j) / perEdge;
        const Place of = quad.at(s, t);
        const double plain = distance(of, on.point);
        const Parameters parameters{cell[0] + s, cell[1] + t};
        const std::string where = "at face " + std::to_string(quad.face);
        const auto slackOf = [&](double stated) { return rounding(quad) + unsure * stated; };
        const auto& fromFacets = patch.figures.maxFromFacets;
        if (fromFacets && plain > *fromFacets + slackOf(*fromFacets)) {
            const double slack = slackOf(*fromFacets);
            const double limit = *fromFacets + slack;
            double error = distanceToFace(mesh_, quad.face, startIn(quad, s, t), on.point);
            if (error > limit) error = distanceToMesh(mesh_, around_, quad.face, on.point);
            if (error <= limit) error = surfaces_.distanceFrom(of, quad.face, p, parameters, limit);
            if (compare(p, "maxFromFacets", fromFacets, error, slack, where)) return true;
        }
        const auto& fromVertices = patch.figures.maxFromVertices;
        const bool atVertex = i % perEdge == 0 && j % perEdge == 0;
        if (!atVertex || !fromVertices || plain <= *fromVertices + slackOf(*fromVertices)) return false;
        const double slack = slackOf(*fromVertices);
        const double error = surfaces_.distanceFrom(of, quad.face, p, parameters, *fromVertices + slack);
        return compare(p, "maxFromVertices", fromVertices, error, slack, where);
    }

    [[nodiscard]] static double rounding(const Quad& quad) {
        double largest = 0;
        for (const Place& corner : quad.corners)
            for (const double x : corner)
                largest = std::max(largest, std::abs(x));
        return 1e-12 * largest;
    }

    /// From the segment's parameters in a quad to those of the face, which may begin at another corner.
    [[nodiscard]] Parameters startIn(const Quad& quad, double s, double t) const {
        const auto& face = mesh_.quads[at(quad.face)];
        std::size_t turns = 0;
        while (turns < 3 && mesh_.points[at(face[turns])] != quad.corners[0])
            ++turns;
        for (std::size_t k = 0; k < turns; ++k) {
            const double turned = 1 - t;
            t = s;
            s = turned;
        }
        return {s, t};
    }

    /// In the middle the normal looks away from the quad, or it turns over from one point to the next.
    bool isFolded(std::size_t p, const Quad& quad, const std::vector<SurfacePoint>& points, std::size_t width,
                  int column) {
        if (part_.patches[p].figures.folds.value_or(1) > 0) return false;
        if (!quad.isConvex() || isTurnedOver(quad.face)) return false;
        const auto normal = [&](int i, int j) {
            return normalOf(points[at(j) * width + at(column * perEdge + i)]);
        };
        // A smooth surface through the corners may itself be turned against the quad by 60 degrees.
        constexpr double away = -0.87;
        bool found = isTurned(normal(perEdge / 2, perEdge / 2), quad.normal(), away);
        constexpr double over = -0.5;
        // At the very corners, where sides may almost be one line, a patch has hardly a normal.
        const auto isCorner = [](int i, int j) { return i % perEdge == 0 && j % perEdge == 0; };
        const auto turns = [&](int i, int j, int right, int down) {
            return !isCorner(i, j) && !isCorner(i + right, j + down) &&
                   isTurned(normal(i, j), normal(i + right, j + down), over);
        };
        for (int j = 0; j < perEdge; ++j)
            for (int i = 0; i < perEdge; ++i)
                found = found || turns(i, j, 1, 0) || turns(i, j, 0, 1);
        if (!found) return false;
        report_.violate(below(below(below("/surfaces/patches", p), "deviation"), "folds"), "deviation",
                        "the normal turns over at face " + std::to_string(quad.face));
        return true;
    }

    /// Whether a quad lies against one beside it, so that no surface should follow both.
    [[nodiscard]] bool isTurnedOver(int face) const {
        constexpr double sharpest = 1.75; // 100 degrees: edges of parts may be as sharp
        const auto& corners = mesh_.quads[at(face)];
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const int step = around_.stepBetween(corners[k], corners[(k + 1) % corners.size()]);
            if (angles_.angle[at(around_.edge(step))] > sharpest) return true;
        }
        return false;
    }

    static bool isTurned(const Place& a, const Place& b, double cosine) {
        return dot(a, b) < cosine * std::sqrt(dot(a, a) * dot(b, b));
    }

    /// The figures of all patches are not less than those of one.
    void totals() {
        const auto total = [&](const char* figure, std::optional<double> Figures::*member) {
            const auto& stated = part_.figures.*member;
            for (const Patch& patch : part_.patches)
                if (stated && (patch.figures.*member).value_or(0) > *stated) {
                    report_.violate(below("/surfaces/deviation", figure), "deviation",
                                    "a patch has " + numberText(*(patch.figures.*member)));
                    return;
                }
        };
        total("maxFromFacets", &Figures::maxFromFacets);
        total("maxFromVertices", &Figures::maxFromVertices);
        total("largestGap", &Figures::largestGap);
        total("largestNormalAngle", &Figures::largestNormalAngle);
        total("largestInnerNormalAngle", &Figures::largestInnerNormalAngle);
        total("folds", &Figures::folds);
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
}

} // namespace qm::check
