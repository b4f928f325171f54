#include "features/features.h"

#include "base/at.h"
#include "mesh/bounding_box.h"
#include "mesh/mesh_lines.h"
#include "mesh/topology.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>

namespace qm {
namespace {

/// Finds the curves of one line.
class LineSearch {
public:
    /// \param diagonal  of the mesh's bounding box
    LineSearch(const QuadMesh& mesh, const std::vector<double>& angles, const FeatureOptions& options,
               double diagonal, const MeshLine& line)
        : mesh_(mesh), angles_(angles), options_(options), minLength_(options.minLength.length(diagonal)),
          minDistance_(options.minDistance.length(diagonal)), line_(line),
          count_(static_cast<int>(line.halfedges.size())) {
        for (const HalfedgeId halfedge : line.halfedges)
            lengthUpTo_.push_back(lengthUpTo_.back() + mesh.calc_edge_length(halfedge));
    }

    void addTo(std::vector<FeatureCurve>& curves) const {
        const int first = line_.closed ? firstBlunt() : 0;
        if (line_.closed && first == count_) { // sharp all round
            if (isLong(0, count_) && hasEnoughEdges(0, count_)) add(0, count_, curves);
            return;
        }
        for (int begin = first; begin < first + count_; ++begin) {
            if (!isSharp(begin)) continue;
            int end = begin + 1;
            while (end < first + count_ && isSharp(end))
                ++end;
            if (isLong(begin, end) && hasEnoughEdges(begin, end) && isFarFromSources(begin, end))
                add(begin, end, curves);
            begin = end;
        }
    }

private:
    /// \param k  on a closed line, up to twice their number
    [[nodiscard]] HalfedgeId halfedgeAt(int k) const {
        return line_.halfedges[at(k < count_ ? k : k - count_)];
    }

    [[nodiscard]] double angle(HalfedgeId halfedge) const { return angles_[at(mesh_.edge_handle(halfedge))]; }
    [[nodiscard]] bool isSharp(int k) const { return angle(halfedgeAt(k)) > options_.rho; }

    /// The position at which the walk round a closed line can begin without dividing a run; the line's length
    /// if there is none.
    [[nodiscard]] int firstBlunt() const {
        int k = 0;
        while (k < count_ && isSharp(k))
            ++k;
        return k;
    }

    [[nodiscard]] bool isLong(int begin, int end) const { return lengthOf(begin, end) >= minLength_; }

    [[nodiscard]] bool hasEnoughEdges(int begin, int end) const {
        if (end - begin >= options_.tau) return true;
        for (int k = begin; k < end; ++k)
            if (angle(halfedgeAt(k)) <= options_.shortRho) return false;
        return (line_.closed && end - begin == count_) ||
               (isHeld(mesh_.opposite_halfedge_handle(halfedgeAt(begin))) && isHeld(halfedgeAt(end - 1)));
    }

    /// Whether a curve that arrives there ends at the boundary, or at edges that are as sharp.
    [[nodiscard]] bool isHeld(HalfedgeId arriving) const {
        const VertexId vertex = mesh_.to_vertex_handle(arriving);
        if (mesh_.is_boundary(vertex)) return true;
        const HalfedgeId back = mesh_.opposite_halfedge_handle(arriving);
        return std::ranges::any_of(mesh_.voh_range(vertex), [&](HalfedgeId leaving) {
            return leaving != back && angle(leaving) > options_.shortRho;
        });
    }

    [[nodiscard]] bool isFarFromSources(int begin, int end) const {
        if (line_.closed) return true;
        const auto isFar = [this](VertexId lineEnd, int first, int last) {
            return isRegular(mesh_, lineEnd) ||
                   (last - first > options_.zeta && lengthOf(first, last) >= minDistance_);
        };
        return (isFar(mesh_.from_vertex_handle(line_.halfedges.front()), 0, begin) ||
                isCrossed(mesh_.opposite_halfedge_handle(halfedgeAt(begin)))) &&
               (isFar(mesh_.to_vertex_handle(line_.halfedges.back()), end, count_) ||
                isCrossed(halfedgeAt(end - 1)));
    }

    /// Whether a sharp line crosses where a curve arrives. Its track stops whatever comes from beyond, so
    /// that sources there are of no use to the curve.
    [[nodiscard]] bool isCrossed(HalfedgeId arriving) const {
        if (!continuesStraight(mesh_, mesh_.to_vertex_handle(arriving))) return false;
        const HalfedgeId back = mesh_.opposite_halfedge_handle(arriving);
        return std::ranges::all_of(
            std::array{mesh_.cw_rotated_halfedge_handle(back), mesh_.ccw_rotated_halfedge_handle(back)},
            [&](HalfedgeId across) { return angle(across) > options_.shortRho; });
    }

    /// The length of the edges between two positions; on a closed line, positions continue beyond its end.
    [[nodiscard]] double lengthOf(int begin, int end) const {
        const auto lengthUpTo = [this](int position) {
            const std::size_t count = line_.halfedges.size(), turns = at(position) / count;
            return static_cast<double>(turns) * lengthUpTo_.back() + lengthUpTo_[at(position) % count];
        };
        return lengthUpTo(end) - lengthUpTo(begin);
    }

    void add(int begin, int end, std::vector<FeatureCurve>& curves) const {
        FeatureCurve curve;
        for (int k = begin; k < end; ++k)
            curve.halfedges.push_back(halfedgeAt(k));
        if (roundness(mesh_, curve.halfedges) <= options_.maxRoundness) curves.push_back(std::move(curve));
    }

    const QuadMesh& mesh_;
    const std::vector<double>& angles_;
    const FeatureOptions& options_;
    double minLength_;
    double minDistance_;
    const MeshLine& line_;
    int count_;                         ///< of its edges
    std::vector<double> lengthUpTo_{0}; ///< from the line's beginning to every position
};

/// Sets the curve's seed to the admissible vertex nearest to its middle.
/// \return false if no vertex is admissible
bool placeSeed(const QuadMesh& mesh, FeatureCurve& curve, std::vector<bool>& taken) {
    const std::vector<VertexId> vertices = verticesAlong(mesh, curve.halfedges);
    const int middle = static_cast<int>(curve.halfedges.size()) / 2;
    std::vector<int> order(vertices.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int k) { return std::abs(k - middle); });
    for (const int k : order) {
        const VertexId vertex = vertices[at(k)];
        if (taken[at(vertex)] || !continuesStraight(mesh, vertex)) continue;
        taken[at(vertex)] = true;
        curve.seed = vertex;
        return true;
    }
    return false;
}

} // namespace

Features findFeatures(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                      const FeatureOptions& options) {
    const double diagonal = boundingBox(mesh).diagonal();
    std::vector<FeatureCurve> curves;
    forEachMeshLine(mesh, [&](const MeshLine& line) {
        LineSearch(mesh, dihedralAngles, options, diagonal, line).addTo(curves);
    });
    const auto edgeNumber = [&](HalfedgeId halfedge) { return mesh.edge_handle(halfedge).idx(); };
    std::ranges::sort(curves, {}, [&](const FeatureCurve& curve) {
        return edgeNumber(*std::ranges::min_element(curve.halfedges, {}, edgeNumber));
    });
    Features features;
    std::vector<bool> taken(mesh.n_vertices(), false);
    for (FeatureCurve& curve : curves)
        if (placeSeed(mesh, curve, taken)) features.curves.push_back(std::move(curve));
    return features;
}

std::vector<Seed> seeds(const QuadMesh& mesh, const Features& features) {
    std::vector<Seed> result;
    for (const FeatureCurve& curve : features.curves) {
        const auto leaving = std::ranges::find(curve.halfedges, curve.seed,
                                               [&](HalfedgeId h) { return mesh.from_vertex_handle(h); });
        result.push_back({leaving != curve.halfedges.end()
                              ? *leaving
                              : mesh.opposite_halfedge_handle(curve.halfedges.back())});
    }
    return result;
}

} // namespace qm
