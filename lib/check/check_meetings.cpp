#include "base/at.h"
#include "base/number_text.h"
#include "check/check_sections.h"
#include "check/distance.h"
#include "check/patch_borders.h"
#include "check/spline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace qm::check {

namespace {

using Patch = SurfacesPart::Patch;

constexpr int perEdge = 16;

Place cross(const Place& a, const Place& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Degrees; 0 if one of both surfaces has no normal.
double angleBetween(const SurfacePoint& a, const SurfacePoint& b) {
    const Place left = cross(a.alongU, a.alongV);
    const Place right = cross(b.alongU, b.alongV);
    const Place both = cross(left, right);
    const double cosine = left[0] * right[0] + left[1] * right[1] + left[2] * right[2];
    return std::atan2(std::hypot(both[0], both[1], both[2]), cosine + 0.0) * 180 / std::numbers::pi;
}

class MeetingCheck {
public:
    MeetingCheck(const Context& context, const LayoutPart& layout, const SurfacesPart& part, Report& report)
        : around_(context.around), angles_(context.angles), layout_(layout), part_(part), report_(report) {}

    void run() {
        for (std::size_t p = 0; p < part_.patches.size(); ++p)
            innerLines(p);
        const auto places = patchBorders(around_, layout_);
        isBorder_.resize(places.size());
        for (std::size_t edge = 0; edge < places.size(); ++edge)
            isBorder_[edge] = !places[edge].empty();
        steps_.resize(places.size());
        leads_.resize(at(around_.steps()));
        for (int step = 0; step < around_.steps(); ++step)
            steps_[at(around_.edge(step))] = step;
        for (std::size_t edge = 0; edge < places.size(); ++edge)
            if (places[edge].size() == 2) meet(places[edge], edge);
    }

private:
    /// Where a line of borders goes on to.
    enum class Leads : char { unknown, nowhere, somewhere };

    bool compare(std::size_t p, const char* figure, const std::optional<double>& stated, double found,
                 double slack, const std::string& where) {
        return checkFigure(p, figure, stated, found, slack, where, report_);
    }

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
        const int steps = layout_.segments[p].size[1 - direction] * perEdge;
        for (int step = 0; step <= steps; ++step) {
            const double along = static_cast<double>(step) / perEdge;
            const auto there = [&](double across) {
                return direction == 0 ? evaluate(patch, across, along) : evaluate(patch, along, across);
            };
            const SurfacePoint left = there(before);
            const SurfacePoint right = there(line);
            const std::string where =
                std::string("at ") + (direction == 0 ? "u" : "v") + " = " + numberText(line);
            if (compare(p, "largestInnerNormalAngle", patch.figures.largestInnerNormalAngle,
                        angleBetween(left, right), 1e-4, where) ||
                compare(p, "largestGap", patch.figures.largestGap, distance(left.point, right.point),
                        1e-12 * size(patch), where))
                return true;
        }
        return false;
    }

    /// The largest coordinate, by which rounding is judged.
    [[nodiscard]] static double size(const Patch& patch) {
        double largest = 0;
        for (const Place& control : patch.controlPoints)
            for (const double x : control)
                largest = std::max(largest, std::abs(x));
        return largest;
    }

    /// The border is flatter than rho, and is not sharp because of others, as those above half of rho may be:
    /// a third crease of a corner meets two more borders that are, and one between creases leads straight to
    /// such borders on both sides.
    [[nodiscard]] bool mustBeSmooth(std::size_t edge) {
        if (!part_.rho || isSharp(edge)) return false;
        if (!mayBeSharp(edge)) return true;
        const int step = steps_[edge];
        return sharpBordersAt(around_.from(step)) < 3 && sharpBordersAt(around_.to(step)) < 3 &&
               !(leadsToSharp(step) && leadsToSharp(around_.back(step)));
    }

    [[nodiscard]] bool isSharp(std::size_t edge) const {
        return angles_.angle[edge] + angles_.doubt[edge] > *part_.rho;
    }

    [[nodiscard]] bool mayBeSharp(std::size_t edge) const {
        return angles_.angle[edge] + angles_.doubt[edge] > *part_.rho / 2;
    }

    [[nodiscard]] int sharpBordersAt(int vertex) const {
        if (!around_.interior(vertex)) return 0;
        int count = 0;
        for (int k = 0; k < around_.valence(vertex); ++k) {
            const std::size_t edge = at(around_.edge(around_.firstStep(vertex) + k));
            if (isBorder_[edge] && mayBeSharp(edge)) ++count;
        }
        return count;
    }

    /// Whether straight on over borders that may be sharp there is the mesh boundary, one that is sharp, or
    /// another that may be.
    [[nodiscard]] bool leadsToSharp(int step) {
        std::vector<int> passed;
        auto found = Leads::unknown;
        for (; found == Leads::unknown; step = around_.straightOn(step)) {
            passed.push_back(step);
            leads_[at(step)] = Leads::nowhere; // as long as a closed line has not led anywhere
            found = leadsAcross(around_.to(step), step);
        }
        for (const int each : passed)
            leads_[at(each)] = found;
        return found == Leads::somewhere;
    }

    /// What the vertex that a step leads to, and what is known of the step after it, say.
    [[nodiscard]] Leads leadsAcross(int vertex, int step) const {
        if (!around_.interior(vertex)) return Leads::somewhere;
        const int next = around_.passable(vertex) ? around_.straightOn(step) : -1;
        for (int k = 0; k < around_.valence(vertex); ++k) {
            const int other = around_.firstStep(vertex) + k;
            const std::size_t edge = at(around_.edge(other));
            if (other == around_.back(step) || !isBorder_[edge]) continue;
            if (isSharp(edge) || (other != next && mayBeSharp(edge))) return Leads::somewhere;
        }
        if (next < 0) return Leads::nowhere;
        const std::size_t edge = at(around_.edge(next));
        return isBorder_[edge] && mayBeSharp(edge) ? leads_[at(next)] : Leads::nowhere;
    }

    /// Where two patches meet along an edge.
    void meet(const std::vector<BorderPlace>& place, std::size_t edge) {
        constexpr double nearEnd = 1.0 / 200;
        const bool smooth = mustBeSmooth(edge);
        const auto there = [&](std::size_t side, double along) {
            const BorderPlace& of = place[side];
            return evaluate(part_.patches[of.patch], std::lerp(of.begin[0], of.end[0], along),
                            std::lerp(of.begin[1], of.end[1], along));
        };
        for (int sample = 0; sample < perEdge; ++sample) {
            const double along =
                std::clamp(static_cast<double>(sample) / (perEdge - 1), nearEnd, 1 - nearEnd);
            const SurfacePoint left = there(0, along);
            const SurfacePoint right = there(1, 1 - along);
            for (std::size_t side = 0; side < 2; ++side) {
                const std::size_t p = place[side].patch;
                const Patch& patch = part_.patches[p];
                const std::string where =
                    "along the border to patch " + std::to_string(place[1 - side].patch);
                if (compare(p, "largestGap", patch.figures.largestGap, distance(left.point, right.point),
                            1e-12 * size(patch), where) ||
                    (smooth && compare(p, "largestNormalAngle", patch.figures.largestNormalAngle,
                                       angleBetween(left, right), 1e-4, where)))
                    return;
            }
        }
    }

    const Neighbourhoods& around_;
    const Angles& angles_;
    const LayoutPart& layout_;
    const SurfacesPart& part_;
    Report& report_;
    std::vector<bool> isBorder_; ///< by edge: of a patch
    std::vector<int> steps_;     ///< by edge: one of its two
    std::vector<Leads> leads_;   ///< by step, what is known of it
};

} // namespace

void checkMeetings(const Context& context, const LayoutPart& layout, const SurfacesPart& part,
                   Report& report) {
    MeetingCheck(context, layout, part, report).run();
}

bool checkFigure(std::size_t patch, const char* figure, const std::optional<double>& stated, double found,
                 double slack, const std::string& where, Report& report) {
    if (!stated || found <= *stated * (1 + 1e-6) + slack) return false;
    report.violate(below(below(below("/surfaces/patches", patch), "deviation"), figure), "deviation",
                   "it is " + numberText(found) + " " + where);
    return true;
}

} // namespace qm::check
