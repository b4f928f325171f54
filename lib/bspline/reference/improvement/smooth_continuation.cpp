#include "bspline/reference/improvement/smooth_continuation.h"

#include "base/sort_unique.h"
#include "bspline/solver/sparse_factors.h"
#include "bspline/splines/eigen_point.h"

#include <Eigen/SparseCore>

#include <cstddef>

namespace qm {

bool isHub(const QuadMesh& mesh, VertexId vertex) {
    constexpr int maxValence = 32;
    int count = 0; // `valence` would go around all of them
    for ([[maybe_unused]] const VertexId beside : mesh.vv_range(vertex))
        if (++count > maxValence) return true;
    return false;
}

std::optional<std::vector<Point>> smoothContinuation(const QuadMesh& mesh, const MovingVertices& moving,
                                                     const std::function<bool(VertexId)>& counts,
                                                     unsigned jobs) {
    std::vector<VertexId> even = moving.all();
    for (const VertexId vertex : moving.all())
        for (const VertexId beside : mesh.vv_range(vertex))
            if (!moving.contains(beside) && counts(beside)) even.push_back(beside);
    sortUnique(even);
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixX3d constants = Eigen::MatrixX3d::Zero(eigenIndex(even.size()), 3);
    bool isHeld = false;
    for (int row = 0; const VertexId vertex : even) {
        const auto add = [&](VertexId of, double weight) {
            if (const auto column = moving.number(of)) {
                entries.emplace_back(row, *column, weight);
                return;
            }
            constants.row(row) -= weight * vector(mesh.point(of)).transpose();
            isHeld = true;
        };
        add(vertex, 1);
        const double share = 1.0 / mesh.valence(vertex);
        for (const VertexId beside : mesh.vv_range(vertex))
            add(beside, -share);
        ++row;
    }
    if (!isHeld) return std::nullopt;
    Eigen::SparseMatrix<double> matrix(constants.rows(), eigenIndex(moving.all().size()));
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> transposed = matrix.transpose();
    const Eigen::SparseMatrix<double> square = transposed * matrix;
    const SparseFactors factors(square.triangularView<Eigen::Lower>(), jobs);
    const Eigen::MatrixX3d solution = factors.solve(transposed * constants);
    if (!solution.allFinite()) return std::nullopt;
    std::vector<Point> points;
    for (Eigen::Index k = 0; k < solution.rows(); ++k)
        points.push_back(point(solution.row(k)));
    return points;
}

std::vector<Point> pointsOf(const QuadMesh& mesh, const std::vector<VertexId>& vertices) {
    std::vector<Point> points;
    points.reserve(vertices.size());
    for (const VertexId vertex : vertices)
        points.push_back(mesh.point(vertex));
    return points;
}

void setPoints(QuadMesh& mesh, const std::vector<VertexId>& vertices, const std::vector<Point>& points) {
    for (std::size_t k = 0; k < points.size(); ++k)
        mesh.set_point(vertices[k], points[k]);
}

} // namespace qm
