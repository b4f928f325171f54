#include "mesh/soup/validate.h"

#include "base/at.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/positions.h"
#include "mesh/soup/soup_repairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace qm {
namespace {

constexpr const char* repairHint = "The option --repair corrects this";

std::string edgePlace(const Soup& soup, Side side) {
    const auto [a, b] = std::minmax({sideFrom(soup, side), sideTo(soup, side)});
    return "edge between vertices " + std::to_string(soup.pointNumber(at(a))) + " and " +
           std::to_string(soup.pointNumber(at(b)));
}

void checkSize(const Soup& soup) {
    constexpr std::size_t max = std::size_t{1} << 29; // sides and halfedges have 32-bit numbers
    if (soup.faceCount() == 0) throw Error("", "it holds no faces", "Is it cut off, or another format?");
    if (std::max(soup.corners.size() / 4, soup.points.size()) > max)
        throw Error("", "it holds more than " + std::to_string(max) + " faces or vertices",
                    "Divide the model");
}

void checkQuads(const Soup& soup) {
    std::optional<std::size_t> first;
    std::size_t others = 0, triangles = 0;
    for (std::size_t k = 0; k < soup.faceCount(); ++k) {
        const std::size_t sides = soup.face(k).size();
        if (sides == 4) continue;
        if (!first) first = k;
        ++others;
        triangles += sides == 3 ? 1 : 0;
    }
    if (!first) return;
    const bool isTriangulated = 2 * triangles > soup.faceCount();
    throw Error(soup.facePlace(*first),
                "it has " + countText(soup.face(*first).size(), "side") + "; " + std::to_string(others) +
                    " of " + countText(soup.faceCount(), "face") + (others == 1 ? " is" : " are") +
                    " not four-sided",
                "Make quads of all faces: " +
                    std::string(isTriangulated ? "quadmesh --quads N and qm-remesh do, with Blender"
                                               : "quadmesh --subdivide and qm-remesh --subdivide do"));
}

void checkSides(const Soup& soup) {
    for (std::size_t k = 0; k < soup.faceCount(); ++k)
        if (soup.face(k).size() < 3)
            throw Error(soup.facePlace(k), "it has " + countText(soup.face(k).size(), "side"),
                        "Use another copy of the file, or take the face out");
}

void checkIndices(const Soup& soup) {
    const auto count = static_cast<std::int64_t>(soup.points.size());
    const auto [lowest, highest] = std::ranges::minmax(soup.corners);
    if (lowest >= 0 && highest < count) return;
    const auto wrong =
        std::ranges::find_if(soup.corners, [&](std::int64_t k) { return k < 0 || k >= count; });
    const bool oneBased = soup.firstIndex == 0 && lowest == 1 && highest == count;
    throw Error(soup.facePlace(soup.faceOf(positionIn(soup.corners, wrong))),
                "vertex index " + std::to_string(*wrong + soup.firstIndex) + " is out of range: there are " +
                    std::to_string(soup.points.size()) + " vertices, counted from " +
                    std::to_string(soup.firstIndex),
                oneBased ? "The file seems to count from 1: subtract 1 from every index"
                         : "Use a complete copy, or correct the index");
}

void checkPoints(const Soup& soup) {
    constexpr double largest = 1e150;
    for (std::size_t k = 0; k < soup.points.size(); ++k)
        for (const double value : soup.points[k]) {
            if (std::abs(value) <= largest) continue;
            if (std::isfinite(value))
                throw Error(soup.pointPlace(k), "a coordinate is larger than 1e150", "Scale the model");
            throw Error(soup.pointPlace(k),
                        std::isnan(value) ? "a coordinate is not a number" : "a coordinate is infinite",
                        "Correct the vertex");
        }
}

void checkRepeatedVertices(const Soup& soup) {
    for (std::size_t k = 0; k < soup.faceCount(); ++k) {
        const auto corners = sortedCorners(soup, k);
        if (const auto twice = std::ranges::adjacent_find(corners); twice != corners.end())
            throw Error(soup.facePlace(k),
                        "vertex " + std::to_string(soup.pointNumber(at(*twice))) + " occurs twice in it",
                        repairHint);
    }
}

/// Throws if a face occurs twice. Equal faces share their edges, so only the few faces at an edge are
/// compared.
void checkDuplicateFaces(const Soup& soup, const SoupEdges& edges) {
    std::vector<std::pair<std::array<std::int64_t, 4>, std::size_t>> faces;
    for (std::size_t k = 0; k < edges.count(); ++k) {
        const auto sides = edges.edge(k);
        // Two sides that run in opposite directions may belong to quads back to back. If those are
        // duplicates, another edge shows it.
        if (sides.size() < 2 || (sides.size() == 2 && sideFrom(soup, sides[0]) != sideFrom(soup, sides[1])))
            continue;
        faces.clear();
        for (const Side side : sides)
            faces.emplace_back(sortedCorners(soup, side / 4), side / 4);
        std::ranges::sort(faces);
        const auto twice =
            std::ranges::adjacent_find(faces, {}, [](const auto& entry) { return entry.first; });
        if (twice != faces.end())
            throw Error(soup.facePlace((twice + 1)->second),
                        "it has the same vertices as " + soup.facePlace(twice->second), repairHint);
    }
}

void checkCrowdedEdges(const Soup& soup, const SoupEdges& edges) {
    for (std::size_t k = 0; k < edges.count(); ++k) {
        const auto sides = edges.edge(k);
        if (sides.size() <= 2) continue;
        // Solids have two faces each at an edge where they touch.
        const bool mayBeSolids = sides.size() % 2 == 0;
        throw Error(edgePlace(soup, sides[0]),
                    std::to_string(sides.size()) + " faces meet there: " + soup.facePlace(sides[0] / 4) +
                        ", " + soup.facePlace(sides[1] / 4) + ", " + soup.facePlace(sides[2] / 4) +
                        (sides.size() > 3 ? " and more" : ""),
                    std::string("The surface is no manifold there: take out faces that are too many") +
                        (mayBeSolids ? "; --repair takes solids apart that touch"
                                     : ", such as a rib that stands on a skin"));
    }
}

void checkOrientation(const Soup& soup, const SoupEdges& edges, const std::vector<Side>& twins) {
    std::size_t wrong = 0;
    std::optional<Side> first;
    for (std::size_t k = 0; k < edges.count(); ++k) {
        const auto sides = edges.edge(k);
        if (sides.size() != 2 || sideFrom(soup, sides[0]) != sideFrom(soup, sides[1])) continue;
        if (!first) first = sides[0];
        ++wrong;
    }
    if (!first) return;
    const auto contradiction = findOrientation(soup, twins).contradiction;
    throw Error(edgePlace(soup, *first),
                soup.facePlace(*first / 4) + " and " + soup.facePlace(twins[*first] / 4) +
                    " are oriented inconsistently, as at " + countText(wrong, "edge") + " in all",
                contradiction ? "The surface is not orientable, it has one side only like a Moebius strip, "
                                "so this cannot be repaired: cut it open"
                              : "The option --repair orients them");
}

void checkFans(const Soup& soup, const std::vector<Side>& twins) {
    std::vector<bool> met(soup.points.size(), false);
    forEachFan(twins, [&](std::span<const Side> corners) {
        const std::size_t vertex = at(soup.corners[corners.front()]);
        if (met[vertex])
            throw Error(soup.pointPlace(vertex), "the faces around it fall into several fans",
                        "The surface is no manifold there. The option --repair splits the vertex");
        met[vertex] = true;
    });
}

} // namespace

std::array<std::int64_t, 4> sortedCorners(const Soup& soup, std::size_t face) {
    std::array<std::int64_t, 4> corners;
    std::ranges::copy(soup.face(face), corners.begin());
    std::ranges::sort(corners);
    return corners;
}

void validatePolygons(const Soup& soup) {
    checkSize(soup);
    checkSides(soup);
    checkIndices(soup);
    checkPoints(soup);
}

void validateElements(const Soup& soup) {
    validatePolygons(soup);
    checkQuads(soup);
}

std::vector<Side> validateSoup(const Soup& soup) {
    validateElements(soup);
    checkRepeatedVertices(soup);
    const SoupEdges edges = findEdges(soup);
    checkDuplicateFaces(soup, edges);
    checkCrowdedEdges(soup, edges);
    std::vector<Side> twins = twinSides(soup, edges);
    checkOrientation(soup, edges, twins);
    checkFans(soup, twins);
    return twins;
}

} // namespace qm
