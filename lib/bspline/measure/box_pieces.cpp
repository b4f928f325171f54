#include "bspline/measure/box_pieces.h"

#include "bspline/measure/quarter_turns.h"
#include "layout/sides.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace qm {
namespace {

/// How parameters continue in the patch beyond a side.
struct Continuation {
    Parameters from; ///< a place of the old patch
    LayoutPlace to;  ///< the same in the new one
    int turns;

    [[nodiscard]] Parameters operator()(const Parameters& at) const {
        const Parameters moved = turned<double>({at[0] - from[0], at[1] - from[1]}, turns);
        return {to.at[0] + moved[0], to.at[1] + moved[1]};
    }
};

/// The one beyond a stretch of a side; nothing if there is none, or more than one, or a gap between.
std::optional<Continuation> continuationOver(const PairedSurfaces& surfaces, std::size_t patch,
                                             std::size_t direction, std::size_t end,
                                             const std::array<double, 2>& stretch) {
    std::optional<Continuation> result;
    Parameters at{};
    at[direction] = end == 0 ? 0 : surfaces.extent(patch)[direction];
    // What lies beyond is the same over a whole edge.
    for (auto edge = static_cast<int>(std::floor(stretch[0])); edge < stretch[1]; ++edge) {
        at[1 - direction] = edge + 0.5;
        const auto crossing = surfaces.across({patch, at}, sideAcross(direction, end == 1));
        if (!crossing || !crossing->isGapless) return {};
        if (!result) {
            result = {at, crossing->to, crossing->turns};
            continue;
        }
        const Parameters expected = (*result)(at);
        if (crossing->to.patch != result->to.patch || crossing->turns != result->turns ||
            std::hypot(expected[0] - crossing->to.at[0], expected[1] - crossing->to.at[1]) > 0.25)
            return {};
    }
    return result;
}

/// A flag of either end along either direction, seen from directions turned by so many quarters.
bool seenTurned(const std::array<std::array<bool, 2>, 2>& flags, int turns, std::size_t direction,
                std::size_t end) {
    const auto [axis, sign] = turnedDirection(direction, turns);
    return flags[axis][sign > 0 ? end : 1 - end];
}

} // namespace

BoxParts boxParts(const PairedSurfaces& surfaces, std::size_t patch, const ParameterBox& box) {
    const Parameters extent = surfaces.extent(patch);
    BoxPart inner{patch, box, 0, {{{true, true}, {true, true}}}};
    for (std::size_t k = 0; k < 2; ++k)
        for (double& end : inner.box[k])
            end = std::clamp(end, 0.0, extent[k]);
    BoxParts result;
    for (std::size_t k = 0; k < 2 && result.empty(); ++k)
        for (const std::size_t end : {0U, 1U}) {
            if (box[k][end] == inner.box[k][end]) continue;
            const auto onwards = continuationOver(surfaces, patch, k, end, inner.box[1 - k]);
            if (!onwards) continue;
            ParameterBox strip = inner.box;
            strip[k] = {inner.box[k][end], box[k][end]};
            const Parameters begin = (*onwards)({strip[0][0], strip[1][0]});
            const Parameters to = (*onwards)({strip[0][1], strip[1][1]});
            BoxPart part{onwards->to.patch, {}, onwards->turns, inner.isAtEnd};
            const Parameters there = surfaces.extent(part.patch);
            for (std::size_t d = 0; d < 2; ++d)
                part.box[d] = {std::clamp(std::min(begin[d], to[d]), 0.0, there[d]),
                               std::clamp(std::max(begin[d], to[d]), 0.0, there[d])};
            part.isAtEnd[k][1 - end] = false;
            inner.isAtEnd[k][end] = false;
            result.push_back(part);
        }
    result.push_back(inner);
    return result;
}

BoxPieces::Cells BoxPieces::cellsOf(const BoxPart& part) const {
    return {surfaces_.cellAt({part.patch, {part.box[0][0], part.box[1][0]}}).interval,
            surfaces_.cellAt({part.patch, {part.box[0][1], part.box[1][1]}}).interval};
}

BoxPiece BoxPieces::take(std::size_t surface, const BoxPart& part, const Cells& cells,
                         const std::array<std::size_t, 2>& interval) {
    constexpr double minWidth = 1e-12; // where a box only touches a cell: derivatives are divided by it
    const Cell cell{part.patch, interval};
    Parameters begin{};
    Parameters end{};
    Parameters width{};
    std::array<std::array<bool, 2>, 2> isOuter{};
    const ParameterBox box = surfaces_.box(cell);
    for (std::size_t k = 0; k < 2; ++k) {
        const auto [from, to] = box[k];
        begin[k] = std::clamp((part.box[k][0] - from) / (to - from), 0.0, 1.0);
        end[k] = std::clamp((part.box[k][1] - from) / (to - from), 0.0, 1.0);
        width[k] = (to - from) * std::max(end[k] - begin[k], minWidth);
        isOuter[k] = {interval[k] == cells.first[k], interval[k] == cells.last[k]};
    }
    restrict(cell_(surface, cell), begin, end, restricted_);
    if (part.turns == 0) {
        std::swap(piece_, restricted_);
    } else {
        const int degree = restricted_.degree[0];
        piece_.degree = restricted_.degree;
        piece_.points.clear();
        for (int j = 0; j <= degree; ++j)
            for (int i = 0; i <= degree; ++i) {
                const auto [column, row] = turnedIndex({i, j}, degree, part.turns);
                piece_.points.push_back(restricted_.at(column, row));
            }
    }
    BoxPiece result{piece_, width, {}};
    if (part.turns % 2 == 1) std::swap(result.width[0], result.width[1]);
    for (std::size_t k = 0; k < 2; ++k)
        for (const std::size_t e : {0U, 1U})
            result.isAtEnd[k][e] = part.isAtEnd[k][e] && seenTurned(isOuter, part.turns, k, e);
    return result;
}

} // namespace qm
