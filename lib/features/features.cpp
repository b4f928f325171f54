#include "features/features.h"

#include "base/at.h"
#include "mesh/bounding_box.h"
#include "mesh/mesh_lines.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace qm {
namespace {

/// Finds the curves of each line.
class Finder {
public:
    Finder(const QuadMesh& mesh, const std::vector<double>& angles, const FeatureOptions& options)
        : mesh_(mesh), angles_(angles), options_(options) {
        const double diagonal = boundingBox(mesh).diagonal();
        minLength_ = options.minLength.length(diagonal);
        minDistance_ = options.minDistance.length(diagonal);
    }

    void search(const MeshLine& line) {
        measure(line);
        const int length = static_cast<int>(line.halfedges.size());
        const int begin = line.closed ? firstBlunt(line) : 0;
        if (begin == length) { // a closed line that is sharp all round
            if (isLong(line, 0, length)) add(line, 0, length);
            return;
        }
        for (int k = begin; k < begin + length; ++k) {
            if (!sharp(line, k)) continue;
            int end = k + 1;
            while (end < begin + length && sharp(line, end))
                ++end;
            if (isLong(line, k, end) && farFromSources(line, k, end)) add(line, k, end);
            k = end;
        }
    }

    std::vector<FeatureCurve> take() {
        std::ranges::sort(curves_, {}, [this](const FeatureCurve& curve) { return lowestEdge(curve); });
        return std::move(curves_);
    }

private:
    [[nodiscard]] bool sharp(const MeshLine& line, int k) const {
        const HalfedgeId halfedge = line.halfedges[at(k) % line.halfedges.size()];
        return angles_[at(mesh_.edge_handle(halfedge))] > options_.rho;
    }

    /// The position at which the walk round a closed line can begin without dividing a run; the line's length
    /// if there is none.
    [[nodiscard]] int firstBlunt(const MeshLine& line) const {
        int k = 0;
        while (k < static_cast<int>(line.halfedges.size()) && sharp(line, k))
            ++k;
        return k;
    }

    [[nodiscard]] bool isLong(const MeshLine& line, int begin, int end) const {
        return end - begin >= options_.tau && lengthOf(line, begin, end) >= minLength_;
    }

    [[nodiscard]] bool farFromSources(const MeshLine& line, int begin, int end) const {
        if (line.closed) return true;
        const auto isFar = [this, &line](VertexId lineEnd, int first, int last) {
            return isRegular(mesh_, lineEnd) ||
                   (last - first > options_.zeta && lengthOf(line, first, last) >= minDistance_);
        };
        const int length = static_cast<int>(line.halfedges.size());
        return isFar(mesh_.from_vertex_handle(line.halfedges.front()), 0, begin) &&
               isFar(mesh_.to_vertex_handle(line.halfedges.back()), end, length);
    }

    /// The length of the edges between two positions on the line; on a closed line, positions continue beyond
    /// its end.
    [[nodiscard]] double lengthOf(const MeshLine& line, int begin, int end) const {
        const auto lengthUpTo = [&](int position) {
            const std::size_t k = at(position);
            const std::size_t count = line.halfedges.size();
            const std::size_t turns = k / count;
            return static_cast<double>(turns) * lengthUpTo_[count] + lengthUpTo_[k % count];
        };
        return lengthUpTo(end) - lengthUpTo(begin);
    }

    void measure(const MeshLine& line) {
        lengthUpTo_.assign(1, 0);
        for (const HalfedgeId halfedge : line.halfedges)
            lengthUpTo_.push_back(lengthUpTo_.back() + mesh_.calc_edge_length(halfedge));
    }

    void add(const MeshLine& line, int begin, int end) {
        FeatureCurve curve;
        for (int k = begin; k < end; ++k)
            curve.halfedges.push_back(line.halfedges[at(k) % line.halfedges.size()]);
        if (roundness(mesh_, curve.halfedges) <= options_.maxRoundness) curves_.push_back(std::move(curve));
    }

    [[nodiscard]] int lowestEdge(const FeatureCurve& curve) const {
        int lowest = std::numeric_limits<int>::max();
        for (const HalfedgeId halfedge : curve.halfedges)
            lowest = std::min(lowest, mesh_.edge_handle(halfedge).idx());
        return lowest;
    }

    const QuadMesh& mesh_;
    const std::vector<double>& angles_;
    const FeatureOptions& options_;
    double minLength_ = 0;
    double minDistance_ = 0;
    std::vector<double> lengthUpTo_; ///< of the present line, from its beginning to every position
    std::vector<FeatureCurve> curves_;
};

/// Sets the curve's seed to the admissible vertex nearest to its middle.
/// \return false if no vertex is admissible
bool placeSeed(const QuadMesh& mesh, FeatureCurve& curve, std::vector<bool>& taken) {
    const std::vector<VertexId> vertices = verticesAlong(mesh, curve.halfedges);
    const int middle = static_cast<int>(curve.halfedges.size()) / 2;
    std::vector<int> order(vertices.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        order[k] = static_cast<int>(k);
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
    Finder finder(mesh, dihedralAngles, options);
    forEachMeshLine(mesh, [&](const MeshLine& line) { finder.search(line); });
    Features features;
    std::vector<bool> taken(mesh.n_vertices(), false);
    for (FeatureCurve& curve : finder.take())
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
