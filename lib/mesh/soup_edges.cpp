#include "mesh/soup_edges.h"

#include <algorithm>

namespace qm {

SoupEdges findEdges(const Soup& soup) {
    // Bucket the sides by their lower vertex, then sort within the small buckets: linear in practice.
    const std::size_t sides = soup.corners.size();
    std::vector<std::size_t> bucketEnd(soup.points.size() + 1, 0);
    const auto lower = [&](Side side) {
        return static_cast<std::size_t>(std::min(sideFrom(soup, side), sideTo(soup, side)));
    };
    const auto higher = [&](Side side) { return std::max(sideFrom(soup, side), sideTo(soup, side)); };
    for (Side side = 0; side < sides; ++side)
        ++bucketEnd[lower(side) + 1];
    for (std::size_t k = 1; k < bucketEnd.size(); ++k)
        bucketEnd[k] += bucketEnd[k - 1];
    SoupEdges edges;
    edges.sides.resize(sides);
    std::vector<std::size_t> next(bucketEnd.begin(), bucketEnd.end() - 1);
    for (Side side = 0; side < sides; ++side)
        edges.sides[next[lower(side)]++] = side;
    for (std::size_t k = 0; k + 1 < bucketEnd.size(); ++k) {
        const auto begin = edges.sides.begin() + static_cast<std::ptrdiff_t>(bucketEnd[k]);
        const auto end = edges.sides.begin() + static_cast<std::ptrdiff_t>(bucketEnd[k + 1]);
        std::stable_sort(begin, end, [&](Side a, Side b) { return higher(a) < higher(b); });
        for (auto side = begin; side != end; ++side)
            if (side == begin || higher(*side) != higher(*(side - 1)))
                edges.begin.push_back(static_cast<std::size_t>(side - edges.sides.begin()));
    }
    edges.begin.push_back(sides);
    return edges;
}

} // namespace qm
