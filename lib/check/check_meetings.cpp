#include "base/at.h"
#include "base/number_text.h"
#include "check/check_sections.h"
#include "check/surfaces/patch_borders.h"
#include "check/surfaces/spline.h"
#include "check/tracks/paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace qm::check {

namespace {

using Patch = SurfacesPart::Patch;

constexpr double sameAngle = 1e-4; // degrees

/// Degrees; 0 if one of both surfaces has no normal.
double angleBetween(const SurfacePoint& a, const SurfacePoint& b) {
    const Vector left = cross(a.alongU, a.alongV);
    const Vector right = cross(b.alongU, b.alongV);
    const Vector both = cross(left, right);
    const double cosine = dot(left, right);
    return std::atan2(std::hypot(both[0], both[1], both[2]), cosine + 0.0) * 180 / std::numbers::pi;
}

class MeetingCheck {
public:
    MeetingCheck(const Context& context, const LayoutPart& layout, const SurfacesPart& part, Report& report)
        : around_(context.around), layout_(layout), part_(part), report_(report) {
        for (const Patch& patch : part.patches)
            rounding_.push_back(1e-12 * largestCoordinate(patch.controlPoints));
    }

    void run() {
        for (std::size_t p = 0; p < part_.patches.size(); ++p)
            innerLines(p);
        const auto places = patchBorders(around_, layout_);
        if (part_.creases) readCreases(places);
        for (std::size_t edge = 0; edge < places.size(); ++edge)
            if (places[edge].size() == 2) meet(places[edge], edge);
    }

private:
    /// Lines within a patch at which a knot stands as often as the degree says, or more often.
    void innerLines(std::size_t p) {
        const Patch& patch = part_.patches[p];
        for (std::size_t k = 0; k < 2; ++k) {
            const auto& knots = patch.knots[k];
            const auto degree = at(patch.degree[k]);
            const auto count = at(patch.count[k]);
            for (std::size_t i = degree + 1; i + degree <= count; ++i) {
                const double line = knots[i];
                const bool begins = knots[i - 1] < line;
                if (!begins || knots[i + degree - 1] > line || line >= knots[count]) continue;
                if (isCreased(p, k, line)) return;
            }
        }
    }

    bool isCreased(std::size_t p, std::size_t direction, double line) {
        const Patch& patch = part_.patches[p];
        const double before = std::nextafter(line, -HUGE_VAL);
        const int steps = layout_.segments[p].size[1 - direction] * samplesPerEdge;
        for (int step = 0; step <= steps; ++step) {
            const double along = static_cast<double>(step) / samplesPerEdge;
            const auto there = [&](double across) {
                return direction == 0 ? evaluate(patch, across, along) : evaluate(patch, along, across);
            };
            const SurfacePoint left = there(before);
            const SurfacePoint right = there(line);
            const std::string where =
                std::string("at ") + (direction == 0 ? "u" : "v") + " = " + numberText(line);
            if (checkFigure(part_, p,
                            {"largestInnerNormalAngle", angleBetween(left, right), sameAngle, where},
                            report_) ||
                hasGap(p, left, right, where))
                return true;
        }
        return false;
    }

    bool hasGap(std::size_t p, const SurfacePoint& left, const SurfacePoint& right,
                const std::string& where) {
        return checkFigure(part_, p, {"largestGap", distance(left.point, right.point), rounding_[p], where},
                           report_);
    }

    /// Marks the edges of creases, which must be borders of two patches.
    void readCreases(const std::vector<std::vector<BorderPlace>>& places) {
        isCrease_.assign(places.size(), false);
        for (std::size_t k = 0; k < part_.creases->size(); ++k) {
            const std::string pointer = below("/surfaces/creases", k, "vertices");
            const auto steps = readPath(around_, (*part_.creases)[k], pointer, report_);
            for (std::size_t i = 0; steps && i < steps->size(); ++i) {
                const auto edge = at(around_.edge((*steps)[i]));
                isCrease_[edge] = true;
                if (places[edge].size() != 2)
                    report_.violate(below(pointer, i + 1), "crease",
                                    "the edge to this vertex is no border of two patches");
            }
        }
    }

    /// Where two patches meet along an edge.
    void meet(const std::vector<BorderPlace>& place, std::size_t edge) {
        constexpr double nearEnd = 1.0 / 200;
        const bool smooth = part_.creases && !isCrease_[edge];
        for (int sample = 0; sample < samplesPerEdge; ++sample) {
            const double along =
                std::clamp(static_cast<double>(sample) / (samplesPerEdge - 1), nearEnd, 1 - nearEnd);
            const SurfacePoint left = evaluateAlong(part_, place[0], along);
            const SurfacePoint right = evaluateAlong(part_, place[1], 1 - along);
            for (std::size_t side = 0; side < 2; ++side) {
                const std::size_t p = place[side].patch;
                const std::string where =
                    "along the border to patch " + std::to_string(place[1 - side].patch);
                if (hasGap(p, left, right, where) ||
                    (smooth &&
                     checkFigure(part_, p,
                                 {"largestNormalAngle", angleBetween(left, right), sameAngle, where},
                                 report_)))
                    return;
            }
        }
    }

    const Neighbourhoods& around_;
    const LayoutPart& layout_;
    const SurfacesPart& part_;
    Report& report_;
    std::vector<double> rounding_; ///< by patch: length of a gap that rounding alone may make
    std::vector<bool> isCrease_;   ///< by edge; if creases are given
};

} // namespace

void checkMeetings(const Context& context, const LayoutPart& layout, const SurfacesPart& part,
                   Report& report) {
    MeetingCheck(context, layout, part, report).run();
}

bool checkFigure(const SurfacesPart& part, std::size_t patch, const FoundFigure& found, Report& report) {
    const auto stated = part.patches[patch].figures[found.figure];
    if (!stated || found.value <= *stated * (1 + 1e-6) + found.slack) return false;
    report.violate(below("/surfaces/patches", patch, "deviation", found.figure), "deviation",
                   "it is " + numberText(found.value) + " " + found.where);
    return true;
}

} // namespace qm::check
