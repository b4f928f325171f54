#include "remesh/polygons/convex_pieces.h"

#include "base/at.h"
#include "remesh/polygons/grid_filling.h"
#include "remesh/polygons/planar_polygon.h"
#include "remesh/polygons/triangulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace qm {
namespace {

/// Two triangles are not joined to a quad some angle of which differs by more than this from a right one.
constexpr double maxBadness = std::numbers::pi / 3;

/// The sides of a surface, by their two vertices.
class Sides {
public:
    explicit Sides(const Soup& soup) {
        given_.reserve(soup.corners.size());
        for (std::size_t face = 0; face < soup.faceCount(); ++face) {
            const auto corners = soup.face(face);
            for (std::size_t k = 0; k < corners.size(); ++k)
                given_.push_back(between(corners[k], corners[(k + 1) % corners.size()]));
        }
        std::ranges::sort(given_);
    }

    [[nodiscard]] bool has(std::int64_t a, std::int64_t b) const {
        return std::ranges::binary_search(given_, between(a, b)) || added_.contains(between(a, b));
    }
    void add(std::int64_t a, std::int64_t b) { added_.insert(between(a, b)); }

private:
    using Pair = std::array<std::int64_t, 2>;
    static Pair between(std::int64_t a, std::int64_t b) { return {std::min(a, b), std::max(a, b)}; }

    std::vector<Pair> given_; ///< sorted
    std::set<Pair> added_;
};

/// Without corners that repeat the one before, and faces of which too few are left.
Soup withoutRepetitions(const Soup& soup) {
    Soup result;
    result.points = soup.points;
    std::vector<std::int64_t> kept;
    for (std::size_t face = 0; face < soup.faceCount(); ++face) {
        kept.clear();
        for (const std::int64_t corner : soup.face(face))
            if (kept.empty() || kept.back() != corner) kept.push_back(corner);
        while (kept.size() > 1 && kept.front() == kept.back())
            kept.pop_back();
        if (kept.size() >= 3) result.addFace(kept);
    }
    return result;
}

/// The largest difference of an angle of a quad from a right one.
double badness(const std::vector<PlanarPoint>& quad) {
    double worst = 0;
    for (const double each : turnsOf(quad))
        worst = std::max(worst, std::abs(each - std::numbers::pi / 2));
    return worst;
}

/// Divides a polygon into triangles, and joins pairs of them to the quads whose angles are nearest to right
/// ones.
/// \return the corners of the pieces; all of them where the polygon cannot be divided
std::vector<std::vector<std::size_t>>
dividedPolygon(const std::vector<PlanarPoint>& corners,
               const std::function<bool(std::size_t, std::size_t)>& mayConnect) {
    const std::vector<Corners> triangles = triangulate(corners, mayConnect);
    std::vector<std::vector<std::size_t>> pieces;
    if (triangles.empty()) {
        std::vector<std::size_t>& whole = pieces.emplace_back(corners.size());
        std::iota(whole.begin(), whole.end(), std::size_t{0});
        return pieces;
    }
    std::vector<std::pair<double, Diagonal>> pairs;
    for (const Diagonal& diagonal : diagonalsOf(triangles))
        pairs.emplace_back(badness(placesOf(corners, diagonal.quad)), diagonal);
    std::ranges::stable_sort(pairs, {}, &std::pair<double, Diagonal>::first);
    std::vector<bool> isJoined(triangles.size(), false);
    for (const auto& [bad, diagonal] : pairs) {
        const auto [a, b] = diagonal.triangles;
        if (bad > maxBadness || isJoined[a] || isJoined[b]) continue;
        isJoined[a] = isJoined[b] = true;
        pieces.emplace_back(diagonal.quad.begin(), diagonal.quad.end());
    }
    for (std::size_t t = 0; t < triangles.size(); ++t)
        if (!isJoined[t]) pieces.emplace_back(triangles[t].begin(), triangles[t].end());
    return pieces;
}

} // namespace

ConvexPieces convexPieces(const Soup& given) {
    const Soup soup = withoutRepetitions(given);
    Sides sides(soup);
    ConvexPieces pieces;
    Soup& result = pieces.soup;
    result.points = soup.points;
    std::vector<std::int64_t> piece;
    for (std::size_t face = 0; face < soup.faceCount(); ++face) {
        const auto corners = soup.face(face);
        const std::vector<PlanarPoint> places = planarCorners(soup, face);
        const bool hasArea =
            std::ranges::any_of(places, [&](const PlanarPoint& each) { return each != places[0]; });
        const bool isGrid = needsGrid(places);
        if (isGrid) pieces.grids.emplace(result.faceCount(), gridFilling(places));
        if (isGrid || !hasArea || isSeenFromItsMiddle(places)) {
            result.addFace(corners);
            continue;
        }
        const auto mayConnect = [&](std::size_t a, std::size_t b) {
            return !sides.has(corners[a], corners[b]);
        };
        const auto divided = dividedPolygon(places, mayConnect);
        for (const std::vector<std::size_t>& chosen : divided) {
            piece.clear();
            for (const std::size_t k : chosen)
                piece.push_back(corners[k]);
            result.addFace(piece);
            for (std::size_t k = 0; k < piece.size() && divided.size() > 1; ++k)
                sides.add(piece[k], piece[(k + 1) % piece.size()]);
        }
    }
    return pieces;
}

} // namespace qm
