#include "bspline/agreed_normals.h"

#include "bspline/evaluate.h"

#include <algorithm>

namespace qm {

AgreedNormals::AgreedNormals(const BorderCurves& curves) : chains_(curves.chains()) {
    for (const BorderChain& chain : chains_.all()) {
        normals_.emplace_back(perEdge * chain.halfedges.size(), Pair{Point(0, 0, 0), Point(0, 0, 0)});
        auto& smooth = smooth_.emplace_back();
        for (const HalfedgeId halfedge : chain.halfedges)
            smooth.push_back(curves.isSmooth(halfedge));
    }
}

/// Calls visit(chain, way, place, number) for all places on a side: which of the chain's, which of the
/// side's.
template <class Visitor>
void AgreedNormals::visitSide(std::size_t patch, int side, const Visitor& visit) const {
    std::size_t number = 0;
    for (const SidePiece& piece : chains_.pieces(patch, side)) {
        const std::size_t size = normals_[piece.place.chain].size();
        const std::size_t first = perEdge * static_cast<std::size_t>(piece.place.position);
        const std::size_t last = first + perEdge * static_cast<std::size_t>(piece.length);
        for (std::size_t k = first; k < last; ++k)
            visit(piece.place.chain, static_cast<std::size_t>(piece.place.way),
                  piece.place.way == 0 ? k : size - 1 - k, number++);
    }
}

void AgreedNormals::update(std::size_t number, const Patch& patch) {
    for (int side = 0; side < 4; ++side) {
        auto own = normalsOnBorder(patch, side % 2 == 0 ? 0 : 1, side == 1 || side == 2 ? 1 : 0);
        if (side >= 2) std::reverse(own.begin(), own.end());
        visitSide(number, side, [&](std::size_t chain, std::size_t way, std::size_t place, std::size_t k) {
            normals_[chain][place][way] = own[k];
        });
    }
}

OnBorder<std::vector<Point>> AgreedNormals::of(std::size_t patch) const {
    constexpr double opposed = 0.5;
    return onBorder<std::vector<Point>>([&](int side, bool turned) {
        std::vector<Point> normals;
        visitSide(patch, side, [&](std::size_t chain, std::size_t, std::size_t place, std::size_t) {
            const Point sum = normals_[chain][place][0] + normals_[chain][place][1];
            const double length = sum.norm();
            const bool agree = smooth_[chain][place / perEdge] && length > opposed;
            normals.push_back(agree ? Point(sum / length) : Point(0, 0, 0));
        });
        if (turned) std::reverse(normals.begin(), normals.end());
        return normals;
    });
}

std::vector<double> AgreedNormals::kinks(std::size_t patch) const {
    std::vector<double> angles;
    for (int side = 0; side < 4; ++side)
        visitSide(patch, side, [&](std::size_t chain, std::size_t, std::size_t place, std::size_t) {
            if (smooth_[chain][place / perEdge])
                angles.push_back(angleInDegrees(normals_[chain][place][0], normals_[chain][place][1]));
        });
    return angles;
}

} // namespace qm
