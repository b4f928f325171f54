#include "remesh/draw_to_scan.h"

#include "bspline/reference/scan/triangle_surface.h"
#include "mesh/quad_geometry.h"
#include "remesh/scan_equations.h"
#include "remesh/surface_samples.h"
#include "remesh/unfold_quads.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <vector>

namespace qm {
namespace {

using Index = Eigen::Index;

/// Weights beside distances over a quad's area, from round to round.
struct Weights {
    double alike; ///< of differences between the movements of neighbours
    double even;  ///< of differences between a vertex and the middle of its neighbours
};

Weights weightsOf(double share) {
    constexpr Weights first{0.7, 3};
    constexpr Weights last{0.01, 0.003};
    return {first.alike * std::pow(last.alike / first.alike, share),
            first.even * std::pow(last.even / first.even, share)};
}

/// All that is to hold, one row each, of the movements of all vertices, three unknowns each.
class MovementSystem {
public:
    explicit MovementSystem(const QuadMesh& mesh) : mesh_(mesh) {}

    void add(const ScanEquation& equation) {
        const double factor = std::sqrt(equation.weight);
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t axis = 0; axis < 3; ++axis)
                put(equation.vertices[k], axis, factor * equation.weights[k] * equation.direction[axis]);
        right_.push_back(factor * equation.distance);
    }

    /// The difference between what `vertex` moves and what its neighbours do is to be `gap`.
    /// \param inPlace  by how much the vertex's own movement counts more, so that nothing floats
    void addDifference(VertexId vertex, const Point& gap, double factor, double inPlace) {
        const double share = factor / mesh_.valence(vertex);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            put(vertex.idx(), axis, factor * (1 + inPlace));
            for (const VertexId other : mesh_.vv_range(vertex))
                put(other.idx(), axis, -share);
            right_.push_back(factor * gap[axis]);
        }
    }

    [[nodiscard]] Eigen::VectorXd solve() const {
        constexpr double accuracy = 1e-3;
        constexpr int maxIterations = 100;
        using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
        const auto rows = static_cast<Index>(right_.size());
        Matrix matrix(rows, 3 * static_cast<Index>(mesh_.n_vertices()));
        matrix.setFromTriplets(entries_.begin(), entries_.end());
        Eigen::LeastSquaresConjugateGradient<Matrix> solver(matrix);
        solver.setTolerance(accuracy);
        solver.setMaxIterations(maxIterations);
        return solver.solve(Eigen::Map<const Eigen::VectorXd>(right_.data(), rows));
    }

private:
    void put(int vertex, std::size_t axis, double value) {
        if (value == 0) return;
        entries_.emplace_back(static_cast<Index>(right_.size()),
                              3 * static_cast<Index>(vertex) + static_cast<Index>(axis), value);
    }

    const QuadMesh& mesh_;
    std::vector<Eigen::Triplet<double>> entries_;
    std::vector<double> right_;
};

Eigen::VectorXd movements(const QuadMesh& mesh, const std::vector<ScanEquation>& equations,
                          const Weights& weights, double edge) {
    constexpr double inPlace = 0.1;
    MovementSystem system(mesh);
    for (const ScanEquation& equation : equations)
        system.add(equation);
    for (const VertexId vertex : mesh.vertices()) {
        if (mesh.is_isolated(vertex)) continue;
        system.addDifference(vertex, {0, 0, 0}, edge * std::sqrt(weights.alike), inPlace);
        if (mesh.is_boundary(vertex)) continue; // loops would shrink
        Point middle{0, 0, 0};
        for (const VertexId other : mesh.vv_range(vertex))
            middle += mesh.point(other) / mesh.valence(vertex);
        system.addDifference(vertex, middle - mesh.point(vertex), edge * std::sqrt(weights.even), 0);
    }
    return system.solve();
}

} // namespace

QuadMesh drawToScan(QuadMesh mesh, const Triangles& scan, unsigned jobs) {
    constexpr int rounds = 12;                // of nearest places, and of least squares
    constexpr std::size_t samplesOfQuad = 40; // of very fine scans
    constexpr double shareOfQuad = 1.0 / 6;   // the area of a sample, of coarse ones
    const double edge = meanEdgeLength(mesh);
    const double reach = 1.5 * edge;
    const TriangleSurface surface(scan);
    const auto samples = samplesOfScan(scan, shareOfQuad * edge * edge, samplesOfQuad * mesh.n_faces());
    for (int round = 1; round <= rounds; ++round) {
        const auto equations = scanEquations(mesh, surface, samples, reach, jobs);
        const Weights weights = weightsOf(static_cast<double>(round) / rounds);
        const Eigen::VectorXd moved = movements(mesh, equations, weights, edge);
        for (const VertexId vertex : mesh.vertices()) {
            const Index first = 3 * static_cast<Index>(vertex.idx());
            mesh.point(vertex) += Point(moved[first], moved[first + 1], moved[first + 2]);
        }
    }
    unfoldQuads(mesh, surface, reach);
    return mesh;
}

} // namespace qm
