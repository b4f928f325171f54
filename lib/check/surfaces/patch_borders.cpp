#include "check/surfaces/patch_borders.h"

#include "base/at.h"

#include <array>
#include <cmath>

namespace qm::check {

std::vector<std::vector<BorderPlace>> patchBorders(const Neighbourhoods& around, const LayoutPart& layout) {
    std::vector<std::vector<BorderPlace>> places(at(around.edges()));
    for (std::size_t patch = 0; patch < layout.segments.size(); ++patch) {
        const auto& segment = layout.segments[patch];
        const double a = segment.size[0];
        const double b = segment.size[1];
        const std::array<Parameters, 4> corners{{{0, 0}, {a, 0}, {a, b}, {0, b}}};
        const std::array<Parameters, 4> ways{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t i = 1; i < segment.sides[k].size(); ++i) {
                const int step = around.stepBetween(segment.sides[k][i - 1], segment.sides[k][i]);
                const auto parameters = [&](std::size_t n) {
                    return Parameters{corners[k][0] + ways[k][0] * static_cast<double>(n),
                                      corners[k][1] + ways[k][1] * static_cast<double>(n)};
                };
                places[at(around.edge(step))].push_back({patch, parameters(i - 1), parameters(i)});
            }
    }
    return places;
}

SurfacePoint evaluateAlong(const SurfacesPart& part, const BorderPlace& place, double share) {
    return evaluate(part.patches[place.patch], std::lerp(place.begin[0], place.end[0], share),
                    std::lerp(place.begin[1], place.end[1], share));
}

} // namespace qm::check
