#include "mesh/soup/repair.h"

#include "base/error.h"
#include "base/positions.h"
#include "mesh/soup/soup_repairs.h"
#include "mesh/soup/validate.h"

#include <algorithm>
#include <array>
#include <utility>

namespace qm {
namespace {

std::size_t dropDegenerate(Soup& soup) {
    std::vector<bool> kept(soup.faceCount());
    for (std::size_t k = 0; k < kept.size(); ++k) {
        const auto corners = sortedCorners(soup, k);
        kept[k] = std::ranges::adjacent_find(corners) == corners.end();
    }
    return keepFaces(soup, kept);
}

std::size_t dropDuplicates(Soup& soup) {
    std::vector<std::pair<std::array<std::int64_t, 4>, std::size_t>> faces(soup.faceCount());
    for (std::size_t k = 0; k < faces.size(); ++k)
        faces[k] = {sortedCorners(soup, k), k};
    std::ranges::sort(faces);
    std::vector<bool> kept(faces.size(), true);
    for (std::size_t k = 1; k < faces.size(); ++k)
        if (faces[k].first == faces[k - 1].first) kept[faces[k].second] = false;
    return keepFaces(soup, kept);
}

void dropUseless(Soup& soup, RepairReport& report) {
    report.degenerateFaces += dropDegenerate(soup);
    report.duplicateFaces += dropDuplicates(soup);
}

void collapse(Soup& soup, RepairReport& report) {
    const Collapses collapses = findCollapses(soup);
    report.degenerateFaces += keepFaces(soup, collapses.faceStays);
    report.weldedVertices += mergePoints(soup, collapses.target);
}

std::size_t orient(Soup& soup) {
    const Orientation orientation = findOrientation(soup, twinSides(soup, findEdges(soup)));
    if (orientation.contradiction)
        throw Error(soup.facePlace(*orientation.contradiction),
                    "it cannot be oriented as all its neighbours are: the surface has one side only, like a "
                    "Moebius strip",
                    "Cut it open");
    for (std::size_t k = 0; k < orientation.reversed.size(); ++k)
        if (orientation.reversed[k]) // keeps the first vertex first
            std::swap(soup.corners[4 * k + 1], soup.corners[4 * k + 3]);
    return countIn(orientation.reversed, true);
}

/// Whether all that the repair did was to weld touching fans, such as those split by an earlier repair, and
/// to split them again.
/// \param copies  number of vertices added by splitting
bool onlySplitsWelds(const Soup& original, const RepairReport& report, std::size_t copies) {
    if (copies == 0 || copies != report.weldedVertices) return false;
    if (report.degenerateFaces + report.duplicateFaces + report.flippedFaces > 0) return false;
    Soup untouched = original;
    return splitFans(untouched) == 0;
}

} // namespace

RepairReport repairSoup(Soup& soup) {
    const Soup original = soup;
    RepairReport report;
    dropUseless(soup, report);
    report.weldedVertices = mergePoints(soup, weldTargets(soup));
    dropUseless(soup, report); // welding may have made more of them
    collapse(soup, report);
    report.flippedFaces = orient(soup);
    const std::size_t pointsBefore = soup.points.size();
    report.splitVertices = splitFans(soup);
    if (onlySplitsWelds(original, report, soup.points.size() - pointsBefore)) {
        soup = original;
        return {};
    }
    if (soup.faceCount() == 0) throw Error("", "no face is left after repair", "Are they all degenerate?");
    return report;
}

} // namespace qm
