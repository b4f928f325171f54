#include "base/at.h"
#include "base/disjoint_sets.h"
#include "mesh/solid_pairs.h"
#include "mesh/triangles/repair_triangles.h"
#include "mesh/triangles/triangle_edges.h"

#include <span>
#include <utility>
#include <vector>

namespace qm {
namespace {

constexpr Side nextSide(Side side) {
    return side % 3 == 2 ? side - 2 : side + 1;
}

class Sheets {
public:
    Sheets(Triangles& triangles, TriangleRepair& report)
        : triangles_(triangles), report_(report), twins_(3 * triangles.faces.size(), none) {}

    void run() {
        forEachEdge(triangles_, [&](std::span<const TriangleSide> edge) { pairSides(edge); });
        separatePoints();
        while (report_.crowdedEdges > 0 && divideSharedEdges()) {
        }
    }

private:
    static constexpr Side none = static_cast<Side>(-1);

    int& corner(Side side) { return triangles_.faces[side / 3][side % 3]; }

    void pair(Side a, Side b) {
        twins_[a] = b;
        twins_[b] = a;
    }

    // ---- pairs

    void pairSides(std::span<const TriangleSide> edge) {
        if (edge.size() == 2) {
            if (edge[0].ascends != edge[1].ascends) pair(edge[0].side, edge[1].side);
            return;
        }
        if (edge.size() < 2) return;
        ++report_.crowdedEdges;
        if (edge.size() == 3)
            pairFlattest(edge);
        else
            pairAroundSolids(edge);
    }

    /// The direction from an edge into a triangle; 0 if the triangle has no area.
    [[nodiscard]] Point inward(const TriangleSide& side) {
        const Point& low = triangles_.points[at(side.low)];
        Point axis = triangles_.points[at(side.high)] - low;
        axis.normalize_cond();
        Point across = triangles_.points[at(corner(nextSide(nextSide(side.side))))] - low;
        across -= axis * (axis | across);
        return across.normalize_cond();
    }

    void pairFlattest(std::span<const TriangleSide> edge) {
        double flattest = 2;
        std::pair<Side, Side> best{none, none};
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = a + 1; b < 3; ++b) {
                const double cosine = inward(edge[a]) | inward(edge[b]);
                if (edge[a].ascends == edge[b].ascends || !(cosine < flattest)) continue;
                flattest = cosine;
                best = {edge[a].side, edge[b].side};
            }
        if (best.first != none) pair(best.first, best.second);
    }

    void pairAroundSolids(std::span<const TriangleSide> edge) {
        std::vector<FaceAtEdge> faces;
        for (const TriangleSide& side : edge)
            faces.push_back({side.side, side.ascends, inward(side)});
        const auto& [low, high, ascends, side] = edge[0];
        const Point along = triangles_.points[at(high)] - triangles_.points[at(low)];
        for (const auto& [open, close] : pairsAroundSolids(along, faces))
            pair(open, close);
    }

    // ---- points

    void separatePoints() {
        DisjointSets corners(twins_.size());
        for (Side side = 0; side < twins_.size(); ++side)
            if (const Side twin = twins_[side]; twin != none && twin > side) {
                corners.join(side, nextSide(twin));
                corners.join(nextSide(side), twin);
            }
        constexpr int unseen = -1;
        std::vector<int> pointOf(twins_.size(), unseen); // of every set
        std::vector<int> sheets(triangles_.points.size(), 0);
        for (Side side = 0; side < twins_.size(); ++side) {
            int& point = pointOf[corners.find(side)];
            if (point == unseen) {
                point = corner(side);
                if (const int others = sheets[at(point)]++; others > 0) {
                    if (others == 1) ++report_.touchingPoints;
                    triangles_.points.emplace_back(Point(triangles_.points[at(point)]));
                    point = static_cast<int>(triangles_.points.size()) - 1;
                }
            }
            corner(side) = point;
        }
    }

    // ---- edges

    /// \return whether another round is needed: edges with a common triangle are divided one after the other
    bool divideSharedEdges() {
        std::vector<Side> shared;
        forEachEdge(triangles_, [&](std::span<const TriangleSide> edge) {
            if (edge.size() < 3) return;
            for (const TriangleSide& side : edge.subspan(1))
                if (twins_[side.side] != edge[0].side && (twins_[side.side] == none || side.ascends))
                    shared.push_back(side.side);
        });
        std::vector<bool> isTaken(triangles_.faces.size(), false);
        for (const Side side : shared) {
            const Side twin = twins_[side];
            if (isTaken[side / 3] || (twin != none && isTaken[twin / 3])) continue;
            isTaken[side / 3] = true;
            if (twin != none) isTaken[twin / 3] = true;
            divide(side);
        }
        return !shared.empty();
    }

    void divide(Side side) {
        const Side twin = twins_[side];
        const Point middle =
            (triangles_.points[at(corner(side))] + triangles_.points[at(corner(nextSide(side)))]) / 2;
        triangles_.points.push_back(middle);
        const Side far = divideTriangle(side);
        if (twin == none) return;
        const Side farOfTwin = divideTriangle(twin);
        pair(side, farOfTwin);
        pair(far, twin);
    }

    /// Divides a triangle by a line from the newest point, in the middle of a side, to the opposite corner.
    /// \return the second half of the side
    Side divideTriangle(Side side) {
        const auto middle = static_cast<int>(triangles_.points.size()) - 1;
        const Side next = nextSide(side);
        const int to = std::exchange(corner(next), middle);
        const auto added = static_cast<Side>(twins_.size());
        triangles_.faces.push_back({middle, to, corner(nextSide(next))});
        twins_.resize(twins_.size() + 3, none);
        if (twins_[next] != none) pair(added + 1, twins_[next]);
        pair(added + 2, next);
        return added;
    }

    Triangles& triangles_;
    TriangleRepair& report_;
    std::vector<Side> twins_; ///< the other side of a pair
};

} // namespace

void separateSheets(Triangles& triangles, TriangleRepair& report) {
    Sheets(triangles, report).run();
}

} // namespace qm
