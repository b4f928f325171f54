#include "mesh/triangles/repair_triangles.h"

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/positions.h"
#include "mesh/triangles/orient_triangles.h"
#include "mesh/triangles/separate_sheets.h"
#include "mesh/triangles/triangle_edges.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace qm {
namespace {

/// Triangles with the same points, in either orientation.
class Doubled {
public:
    explicit Doubled(const Triangles& triangles)
        : triangles_(triangles), kept_(triangles.faces.size(), true), isFlap_(triangles.faces.size(), false) {
    }

    /// \return for every triangle, whether it stays
    std::vector<bool> run() {
        findGroups();
        if (countIn(isFlap_, true) > 0) dropFlaps();
        return std::move(kept_);
    }

private:
    /// Drops all but one of each group, and marks those that are left where the two orientations are
    /// balanced.
    void findGroups() {
        std::vector<std::pair<std::array<int, 3>, std::size_t>> entries; // points, ascending, and triangle
        for (const auto& face : triangles_.faces) {
            entries.emplace_back(face, entries.size());
            std::ranges::sort(entries.back().first);
        }
        std::ranges::sort(entries);
        for (auto begin = entries.begin(); begin != entries.end();) {
            const auto end = std::find_if(begin, entries.end(),
                                          [&](const auto& entry) { return entry.first != begin->first; });
            const auto ascending =
                std::count_if(begin, end, [&](const auto& entry) { return ascends(entry.second); });
            const auto descending = (end - begin) - ascending;
            const auto stays = std::find_if(begin, end, [&](const auto& entry) {
                return ascends(entry.second) == (ascending >= descending);
            });
            for (auto entry = begin; entry != end; ++entry)
                kept_[entry->second] = entry == stays;
            isFlap_[stays->second] = ascending == descending;
            begin = end;
        }
    }

    /// Whether its points ascend from the lowest on.
    [[nodiscard]] bool ascends(std::size_t face) const {
        const auto& [a, b, c] = triangles_.faces[face];
        return (a < b && b < c) || (b < c && c < a) || (c < a && a < b);
    }

    /// Drops connected flaps if two other triangles meet at an edge of one.
    void dropFlaps() {
        DisjointSets flaps(kept_.size());
        std::vector<std::size_t> between;
        forEachEdge(triangles_, [&](std::span<const TriangleSide> edge) {
            std::size_t others = 0;
            std::optional<std::size_t> flap;
            for (const TriangleSide& side : edge) {
                const std::size_t face = side.side / 3;
                if (!kept_[face]) continue;
                if (!isFlap_[face]) {
                    ++others;
                    continue;
                }
                if (flap) flaps.join(*flap, face);
                flap = face;
            }
            if (flap && others == 2) between.push_back(*flap);
        });
        std::vector<bool> drops(kept_.size(), false);
        for (const std::size_t face : between)
            drops[flaps.find(face)] = true;
        for (std::size_t face = 0; face < kept_.size(); ++face)
            if (isFlap_[face] && drops[flaps.find(face)]) kept_[face] = false;
    }

    const Triangles& triangles_;
    std::vector<bool> kept_;
    std::vector<bool> isFlap_; ///< of those kept
};

std::size_t dropDoubled(Triangles& triangles) {
    const std::vector<bool> kept = Doubled(triangles).run();
    std::size_t count = 0;
    for (std::size_t face = 0; face < kept.size(); ++face)
        if (kept[face]) triangles.faces[count++] = triangles.faces[face];
    const std::size_t dropped = kept.size() - count;
    triangles.faces.resize(count);
    return dropped;
}

} // namespace

TriangleRepair repairTriangles(Triangles& triangles) {
    TriangleRepair report;
    report.doubledTriangles = dropDoubled(triangles);
    report.turnedTriangles = orientTriangles(triangles);
    const SeparatedSheets separated = separateSheets(triangles);
    report.crowdedEdges = separated.edges;
    report.touchingPoints = separated.points;
    return report;
}

} // namespace qm
