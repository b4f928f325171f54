#include "mesh/validate.h"

#include "base/error.h"
#include "mesh/soup_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace qm {
namespace {

constexpr const char* repairHint = "qm-basecomplex --repair mends this";

std::string plural(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string edgePlace(const Soup& soup, Side side) {
    const auto [a, b] = std::minmax({sideFrom(soup, side), sideTo(soup, side)});
    return "edge between vertices " + std::to_string(a) + " and " + std::to_string(b);
}

void checkQuads(const Soup& soup) {
    if (soup.faceCount() == 0) throw Error("", "it holds no faces", "is it empty, or another format?");
    std::optional<std::size_t> first;
    std::size_t others = 0;
    for (std::size_t k = 0; k < soup.faceCount(); ++k) {
        if (soup.face(k).size() == 4) continue;
        if (!first) first = k;
        ++others;
    }
    if (first)
        throw Error(soup.facePlace(*first),
                    "it has " + plural(soup.face(*first).size(), "side") + "; " + std::to_string(others) +
                        " of " + plural(soup.faceCount(), "face") + " are no quads",
                    "remesh the model with quads only");
}

void checkIndices(const Soup& soup) {
    const auto count = static_cast<std::int64_t>(soup.points.size());
    const auto [lowest, highest] = std::ranges::minmax_element(soup.corners);
    for (std::size_t k = 0; k < soup.faceCount(); ++k)
        for (const std::int64_t corner : soup.face(k)) {
            if (corner >= 0 && corner < count) continue;
            const bool oneBased = *lowest == 1 && *highest == count;
            throw Error(soup.facePlace(k),
                        "vertex index " + std::to_string(corner) + " is out of range, there are " +
                            std::to_string(soup.points.size()) + " vertices, counted from 0",
                        oneBased ? "the file seems to count from 1: subtract 1 from every index"
                                 : "get the file whole, or mend the index");
        }
}

void checkPoints(const Soup& soup) {
    for (std::size_t k = 0; k < soup.points.size(); ++k)
        for (const double value : soup.points[k])
            if (!std::isfinite(value))
                throw Error(soup.pointPlace(k),
                            std::isnan(value) ? "a coordinate is not a number" : "a coordinate is infinite",
                            "mend the vertex");
}

std::array<std::int64_t, 4> sortedCorners(const Soup& soup, std::size_t face) {
    std::array<std::int64_t, 4> corners;
    std::ranges::copy(soup.face(face), corners.begin());
    std::ranges::sort(corners);
    return corners;
}

void checkRepeatedVertices(const Soup& soup) {
    for (std::size_t k = 0; k < soup.faceCount(); ++k) {
        const auto corners = sortedCorners(soup, k);
        const auto twice = std::ranges::adjacent_find(corners);
        if (twice != corners.end())
            throw Error(soup.facePlace(k), "vertex " + std::to_string(*twice) + " occurs twice in it",
                        repairHint);
    }
}

void checkDuplicateFaces(const Soup& soup, const SoupEdges& edges) {
    for (std::size_t k = 0; k < edges.count(); ++k)
        for (std::size_t i = 1; i < edges.edge(k).size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const std::size_t a = edges.edge(k)[j] / 4, b = edges.edge(k)[i] / 4;
                if (a == b || sortedCorners(soup, a) != sortedCorners(soup, b) || i > 8) continue;
                if (soup.faceCount() == 2) return; // two quads back to back are a closed mesh
                throw Error(soup.facePlace(b), "it has the same vertices as " + soup.facePlace(a),
                            repairHint);
            }
}

void checkEdges(const Soup& soup, const SoupEdges& edges) {
    for (std::size_t k = 0; k < edges.count(); ++k) {
        const auto sides = edges.edge(k);
        if (sides.size() > 2)
            throw Error(edgePlace(soup, sides[0]),
                        std::to_string(sides.size()) + " faces meet there: " + soup.facePlace(sides[0] / 4) +
                            ", " + soup.facePlace(sides[1] / 4) + ", " + soup.facePlace(sides[2] / 4),
                        "the surface is no manifold; take the extra faces out");
    }
    std::size_t wrong = 0;
    std::optional<std::size_t> first;
    for (std::size_t k = 0; k < edges.count(); ++k) {
        const auto sides = edges.edge(k);
        if (sides.size() != 2 || sideFrom(soup, sides[0]) != sideFrom(soup, sides[1])) continue;
        if (!first) first = k;
        ++wrong;
    }
    if (first) {
        const auto sides = edges.edge(*first);
        throw Error(edgePlace(soup, sides[0]),
                    soup.facePlace(sides[0] / 4) + " and " + soup.facePlace(sides[1] / 4) +
                        " are oriented inconsistently, as at " + plural(wrong, "edge") + " in all",
                    "qm-basecomplex --repair orients them, unless the surface has one side only");
    }
}

/// Every corner's next corner around the same vertex, counter-clockwise; its own count of corners if there is
/// none.
std::vector<Side> nextAround(const Soup& soup, const SoupEdges& edges) {
    const auto none = static_cast<Side>(soup.corners.size());
    std::vector<Side> twin(soup.corners.size(), none);
    for (std::size_t k = 0; k < edges.count(); ++k)
        if (const auto sides = edges.edge(k); sides.size() == 2) {
            twin[sides[0]] = sides[1];
            twin[sides[1]] = sides[0];
        }
    std::vector<Side> next(soup.corners.size());
    for (Side corner = 0; corner < soup.corners.size(); ++corner)
        next[corner] = twin[(corner & ~3U) | ((corner + 3) & 3U)];
    return next;
}

void checkFans(const Soup& soup, const SoupEdges& edges) {
    const std::vector<Side> next = nextAround(soup, edges);
    std::vector<bool> hasPrevious(next.size(), false), seen(next.size(), false),
        met(soup.points.size(), false);
    for (const Side corner : next)
        if (corner < next.size()) hasPrevious[corner] = true;
    const auto walk = [&](Side start) {
        const auto vertex = static_cast<std::size_t>(soup.corners[start]);
        if (met[vertex])
            throw Error(soup.pointPlace(vertex), "the faces around it fall into several fans",
                        "the surface is no manifold there; split the vertex");
        met[vertex] = true;
        for (Side corner = start; corner < next.size() && !seen[corner]; corner = next[corner])
            seen[corner] = true;
    };
    for (Side corner = 0; corner < next.size(); ++corner) // open fans from where they begin
        if (!hasPrevious[corner]) walk(corner);
    for (Side corner = 0; corner < next.size(); ++corner)
        if (!seen[corner]) walk(corner);
}

} // namespace

void validateElements(const Soup& soup) {
    checkQuads(soup);
    checkIndices(soup);
    checkPoints(soup);
}

void validateSoup(const Soup& soup) {
    validateElements(soup);
    checkRepeatedVertices(soup);
    const SoupEdges edges = findEdges(soup);
    checkDuplicateFaces(soup, edges);
    checkEdges(soup, edges);
    checkFans(soup, edges);
}

} // namespace qm
