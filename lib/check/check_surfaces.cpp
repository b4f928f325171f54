#include "base/at.h"
#include "base/number_text.h"
#include "check/check_sections.h"
#include "check/surfaces/mesh_size.h"
#include "check/surfaces/patch_borders.h"
#include "check/surfaces/spline.h"
#include "check/tracks/check_segments.h"

#include <algorithm>
#include <cmath>

namespace qm::check {

namespace {

using Patch = SurfacesPart::Patch;

class SurfaceCheck {
public:
    SurfaceCheck(const CheckedMesh& mesh, const Neighbourhoods& around, const LayoutPart& layout,
                 const SurfacesPart& part, Report& report)
        : mesh_(mesh), around_(around), layout_(layout), part_(part), report_(report),
          samePlace_(samePlace(mesh)) {}

    void run() {
        if (part_.patches.size() != layout_.segments.size()) {
            report_.violate("/surfaces/patches", "one patch per segment",
                            "there are " + std::to_string(layout_.segments.size()) + " segments");
            return;
        }
        bool sound = true;
        for (std::size_t p = 0; p < part_.patches.size(); ++p) {
            const bool thisOne = shape(p);
            if (thisOne && part_.interpolates) interpolation(p);
            sound = sound && thisOne;
        }
        if (sound && part_.watertight) gaps();
        if (sound && part_.farthest) place(*part_.farthest, "/surfaces/farthest", "farthest place");
        for (std::size_t k = 0; sound && k < part_.folds.size(); ++k)
            place(part_.folds[k], below("/surfaces/foldPlaces", k), "place of a fold");
        if (const double told = part_.figures["folds"].value_or(0);
            !part_.folds.empty() && told != static_cast<double>(part_.folds.size()))
            report_.violate("/surfaces/foldPlaces", "place of a fold",
                            "there are " + std::to_string(part_.folds.size()) + " places for " +
                                numberText(told) + " folds");
    }

private:
    [[nodiscard]] static std::string pointer(std::size_t patch) { return below("/surfaces/patches", patch); }

    bool shape(std::size_t p) {
        const Patch& patch = part_.patches[p];
        const std::size_t before = report_.total();
        if (patch.segment != layout_.segments[p].id)
            report_.violate(below(pointer(p), "segment"), "one patch per segment",
                            "patches stand in the order of the segments; here " +
                                std::to_string(layout_.segments[p].id) + " belongs");
        if (!patch.rectangular)
            report_.violate(below(pointer(p), "controlPoints"), "control points",
                            "its rows differ in length");
        for (std::size_t k = 0; k < 2; ++k)
            direction(p, k);
        for (std::size_t i = 0; i < patch.controlPoints.size(); ++i)
            for (const double x : patch.controlPoints[i])
                if (!std::isfinite(x)) {
                    const std::size_t columns = std::max<std::size_t>(1, at(patch.count[0]));
                    report_.violate(below(pointer(p), "controlPoints", i / columns, i % columns), "finite",
                                    "a coordinate is no finite number");
                }
        return report_.total() == before;
    }

    void direction(std::size_t p, std::size_t k) {
        const Patch& patch = part_.patches[p];
        const auto& knots = patch.knots[k];
        const std::string here = below(pointer(p), "knots", k);
        if (patch.degree[k] < 1 || patch.degree[k] > maxDegree) {
            report_.violate(below(pointer(p), "degree", k), "degree",
                            "degrees are 1 to " + std::to_string(maxDegree));
            return;
        }
        const std::size_t degree = at(patch.degree[k]);
        const std::size_t count = at(std::max(0, patch.count[k]));
        if (count < degree + 1) {
            report_.violate(below(pointer(p), "controlPoints"), "control points",
                            "fewer than degree + 1 in a direction");
            return;
        }
        if (knots.size() != count + degree + 1) {
            report_.violate(here, "knots",
                            "there must be control points + degree + 1, that is " +
                                std::to_string(count + degree + 1));
            return;
        }
        for (std::size_t i = 0; i < knots.size(); ++i)
            if (!std::isfinite(knots[i]) || (i > 0 && knots[i] < knots[i - 1])) {
                report_.violate(below(here, i), "knots", "knots are finite and do not decrease");
                return;
            }
        const double max = layout_.segments[p].size[k];
        if (std::abs(knots[degree]) > 1e-9 || std::abs(knots[count] - max) > 1e-9 * std::max(1.0, max))
            report_.violate(here, "domain",
                            "the surface must run from 0 to " + numberText(max) + ", as its segment");
    }

    void interpolation(std::size_t p) {
        const std::vector<int> vertices = soundGridOf(mesh_, layout_.segments[p]);
        const std::size_t width = at(layout_.segments[p].size[0]) + 1;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const std::size_t column = i % width, row = i / width;
            const auto here =
                evaluate(part_.patches[p], static_cast<double>(column), static_cast<double>(row));
            const double error = distance(here.point, mesh_.points[at(vertices[i])]);
            if (error <= samePlace_) continue;
            report_.violate(pointer(p), "interpolation",
                            "it misses vertex " + std::to_string(vertices[i]) + " by " + numberText(error));
            return;
        }
    }

    /// Neighbours have the same points along every edge of their common border.
    void gaps() {
        for (const auto& place : patchBorders(around_, layout_)) {
            if (place.size() < 2) continue;
            for (const double along : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                const double gap = distance(evaluateAlong(part_, place[0], along).point,
                                            evaluateAlong(part_, place[1], 1 - along).point);
                if (gap <= samePlace_) continue;
                report_.violate(pointer(place[1].patch), "watertight",
                                "a gap of " + numberText(gap) + " to patch " +
                                    std::to_string(place[0].patch));
                break;
            }
        }
    }

    /// A point that is said to be on a patch is there.
    void place(const SurfacesPart::Claim& place, const std::string& pointer, const char* rule) {
        const bool there = place.patch >= 0 && at(place.patch) < part_.patches.size();
        const auto inside = [&](std::size_t k) {
            return place.at[k] >= 0 && place.at[k] <= layout_.segments[at(place.patch)].size[k];
        };
        if (!there || !inside(0) || !inside(1)) {
            report_.violate(pointer, rule, "it lies on no patch");
            return;
        }
        const Place point = evaluate(part_.patches[at(place.patch)], place.at[0], place.at[1]).point;
        if (!(distance(point, place.point) <= samePlace_))
            report_.violate(below(pointer, "point"), rule, "the patch is elsewhere at these parameters");
    }

    const CheckedMesh& mesh_;
    const Neighbourhoods& around_;
    const LayoutPart& layout_;
    const SurfacesPart& part_;
    Report& report_;
    double samePlace_;
};

} // namespace

void checkSurfaces(const CheckedMesh& mesh, const Neighbourhoods& around, const LayoutPart& layout,
                   const SurfacesPart& part, Report& report) {
    SurfaceCheck(mesh, around, layout, part, report).run();
}

} // namespace qm::check
