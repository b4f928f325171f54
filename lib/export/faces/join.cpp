#include "base/at.h"
#include "bspline/splines/clamped_patch.h"
#include "export/faces/face_patches.h"
#include "export/geometry/geometry.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

namespace qm {
namespace {

struct Face {
    Segment segment;
    Patch patch;
    std::vector<std::size_t> origins;
};

Face turned(Face face, int side) {
    for (int k = 0; k < side; ++k)
        face = {quarterTurned(face.segment), quarterTurned(face.patch), std::move(face.origins)};
    return face;
}

/// The second patch beside side 1 of the first; none if they are not one smooth surface there.
std::optional<Patch> joinedPatch(const Patch& one, const Patch& other, double tolerance) {
    if (one.degree[1] != other.degree[1] || one.knots[1] != other.knots[1]) return std::nullopt;
    Patch result = one;
    result.degree[0] = 3;
    result.controlPoints.clear();
    const auto left = rowCurves(one);
    const auto right = rowCurves(other);
    for (std::size_t j = 0; j < left.size(); ++j) {
        if ((left[j].points.back() - right[j].points.front()).norm() > tolerance) return std::nullopt;
        const SplineCurve row = joined(std::array{left[j], right[j]});
        result.controlPoints.insert(result.controlPoints.end(), row.points.begin(), row.points.end());
        result.knots[0] = row.knots;
        result.count[0] = static_cast<int>(row.points.size());
    }
    const double seam = one.knots[0].back();
    result = withoutNeedlessKnot(result, seam, tolerance);
    if (std::ranges::count(result.knots[0], seam) > 2) return std::nullopt;
    return result;
}

/// The second segment beside side 1 of the first.
Segment joinedSegment(const Segment& one, const Segment& other) {
    Segment result;
    const auto [a, b] = one.size;
    result.size = {a + other.size[0], b};
    result.sides = {one.sides[0], other.sides[1], other.sides[2], one.sides[3]};
    result.sides[0].insert(result.sides[0].end(), other.sides[0].begin() + 1, other.sides[0].end());
    result.sides[2].insert(result.sides[2].end(), one.sides[2].begin() + 1, one.sides[2].end());
    for (std::size_t k = 0; k < 4; ++k)
        result.corners[k] = result.sides[k].front();
    for (int j = 0; j < b; ++j) {
        const auto row = one.faces.begin() + static_cast<std::ptrdiff_t>(j) * a;
        result.faces.insert(result.faces.end(), row, row + a);
        const auto beside = other.faces.begin() + static_cast<std::ptrdiff_t>(j) * other.size[0];
        result.faces.insert(result.faces.end(), beside, beside + other.size[0]);
    }
    return result;
}

std::optional<Face> joinedFace(const Face& one, int side, const Face& other, int otherSide,
                               double tolerance) {
    const auto& line = one.segment.sides[at(side)];
    const auto& beside = other.segment.sides[at(otherSide)];
    if (!std::equal(line.begin(), line.end(), beside.rbegin(), beside.rend())) return std::nullopt;
    const Face left = turned(one, (side + 3) % 4);
    const Face right = turned(other, (otherSide + 1) % 4);
    Segment segment = joinedSegment(left.segment, right.segment);
    if (touchesItself(segment)) return std::nullopt;
    auto patch = joinedPatch(left.patch, right.patch, tolerance);
    if (!patch) return std::nullopt;
    Face result{std::move(segment), std::move(*patch), one.origins};
    result.origins.insert(result.origins.end(), other.origins.begin(), other.origins.end());
    std::ranges::sort(result.origins);
    return result;
}

/// Faces, and where a side begins with two certain vertices.
class Joiner {
public:
    Joiner(FacePatches faces, double tolerance) : tolerance_(tolerance) {
        for (std::size_t f = 0; f < faces.patches.size(); ++f) {
            faces_.emplace_back(Face{std::move(faces.layout.segments[f]), std::move(faces.patches[f]),
                                     std::move(faces.origins[f])});
            enter(f);
        }
    }

    FacePatches run() {
        for (std::size_t f = 0; f < faces_.size(); ++f)
            while (faces_[f] && joinOnce(f)) {
            }
        FacePatches result;
        for (std::optional<Face>& face : faces_)
            if (face) result.add(std::move(face->segment), std::move(face->patch), std::move(face->origins));
        return result;
    }

private:
    using Key = std::array<int, 2>;
    struct Side {
        std::size_t face = 0;
        int side = 0;
    };

    void enter(std::size_t f) {
        for (int side = 0; side < 4; ++side) {
            const auto& line = faces_[f]->segment.sides[at(side)];
            sides_[{line[0].idx(), line[1].idx()}] = {f, side};
        }
    }
    void leave(std::size_t f) {
        for (const auto& line : faces_[f]->segment.sides)
            sides_.erase({line[0].idx(), line[1].idx()});
    }

    bool joinOnce(std::size_t f) {
        for (int side = 0; side < 4; ++side) {
            const auto& line = faces_[f]->segment.sides[at(side)];
            const auto beside = sides_.find({line.back().idx(), line[line.size() - 2].idx()});
            if (beside == sides_.end() || beside->second.face == f) continue;
            const auto [other, otherSide] = beside->second;
            auto both = joinedFace(*faces_[f], side, *faces_[other], otherSide, tolerance_);
            if (!both) continue;
            leave(f);
            leave(other);
            faces_[f] = std::move(both);
            faces_[other].reset();
            enter(f);
            return true;
        }
        return false;
    }

    double tolerance_;
    std::vector<std::optional<Face>> faces_;
    std::map<Key, Side> sides_;
};

} // namespace

FacePatches joined(FacePatches faces, double tolerance) {
    return Joiner(std::move(faces), tolerance).run();
}

} // namespace qm
