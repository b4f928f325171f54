#include "mesh/triangles/repair_triangles.h"

#include "base/disjoint_sets.h"
#include "base/groups.h"
#include "base/keep_marked.h"
#include "base/positions.h"
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
        using Entry = std::pair<std::array<int, 3>, std::size_t>; // points, ascending, and triangle
        std::vector<Entry> entries;
        for (const auto& face : triangles_.faces) {
            entries.emplace_back(face, entries.size());
            std::ranges::sort(entries.back().first);
        }
        std::ranges::sort(entries);
        forEachGroup(entries, &Entry::first, [&](std::span<const Entry> group) {
            const auto isAscending = [&](const Entry& entry) { return ascends(entry.second); };
            const std::size_t ascending = countWhere(group, isAscending),
                              descending = group.size() - ascending;
            const std::size_t stays = std::ranges::find(group, ascending >= descending, isAscending)->second;
            for (const Entry& entry : group)
                kept_[entry.second] = entry.second == stays;
            isFlap_[stays] = ascending == descending;
        });
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
    (void)keepMarked(triangles.faces, kept);
    return countIn(kept, false);
}

} // namespace

TriangleRepair repairTriangles(Triangles& triangles) {
    TriangleRepair report;
    report.doubledTriangles = dropDoubled(triangles);
    report.turnedTriangles = orientTriangles(triangles);
    separateSheets(triangles, report);
    return report;
}

} // namespace qm
