#include "remesh/surface_samples.h"

#include "base/at.h"
#include "mesh/quad_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace qm {
namespace {

double areaOf(const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    return ((b - a) % (c - a)).norm() / 2;
}

/// How many pieces a side is cut into so that the triangles of the pieces are small enough.
int piecesOfSide(double area, double allowed) {
    constexpr double maxPieces = 64;
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(area / allowed)), 1.0, maxPieces));
}

/// The middles of the n * n congruent triangles that a triangle is cut into.
template <class Function> void forEachPiece(const Triangle& corners, int n, Function&& function) {
    const auto at = [&](double i, double j) {
        return corners[0] + (i / n) * (corners[1] - corners[0]) + (j / n) * (corners[2] - corners[0]);
    };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i + j < n; ++i) {
            function(at(i + 1.0 / 3, j + 1.0 / 3));
            if (i + j + 1 < n) function(at(i + 2.0 / 3, j + 2.0 / 3));
        }
}

} // namespace

std::vector<ScanSample> samplesOfScan(const Triangles& scan, double area, std::size_t count) {
    std::vector<ScanSample> samples;
    for (const auto& face : scan.faces) {
        Triangle corners;
        std::ranges::transform(face, corners.begin(), [&](int k) { return scan.points[at(k)]; });
        const auto normal = triangleNormal(corners);
        if (!normal) continue;
        const double whole = areaOf(corners);
        const int n = piecesOfSide(whole, area);
        forEachPiece(corners, n, [&](const Point& position) {
            samples.push_back({position, *normal, whole / (n * n)});
        });
    }
    const std::size_t stride = samples.size() / std::max<std::size_t>(count, 1) + 1;
    if (stride == 1) return samples;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < samples.size(); k += stride) {
        samples[kept] = samples[k];
        samples[kept++].area *= static_cast<double>(stride);
    }
    samples.resize(kept);
    return samples;
}

Triangles halves(const QuadMesh& mesh) {
    Triangles result;
    for (const VertexId vertex : mesh.vertices())
        result.points.push_back(mesh.point(vertex));
    for (const FaceId face : mesh.faces()) {
        const auto corners = cornersOf(mesh, face);
        for (const std::size_t k : {1U, 2U})
            result.faces.push_back({corners[0].idx(), corners[k].idx(), corners[k + 1].idx()});
    }
    return result;
}

std::vector<QuadSample> samplesOfQuads(const QuadMesh& mesh) {
    constexpr std::array places = {1.0 / 6, 0.5, 5.0 / 6};
    std::vector<QuadSample> samples;
    samples.reserve(places.size() * places.size() * mesh.n_faces());
    for (const FaceId face : mesh.faces()) {
        const auto corners = cornersOf(mesh, face);
        const auto [first, second] = halvesOf(mesh, face);
        const double area = areaOf(first) + areaOf(second);
        QuadSample sample;
        std::ranges::transform(corners, sample.vertices.begin(), [](VertexId v) { return v.idx(); });
        for (const double v : places)
            for (const double u : places) {
                sample.weights = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
                sample.area = area / (places.size() * places.size());
                samples.push_back(sample);
            }
        for (const HalfedgeId side : mesh.fh_range(face)) {
            if (!mesh.is_boundary(mesh.edge_handle(side))) continue;
            const int from = mesh.from_vertex_handle(side).idx();
            const int to = mesh.to_vertex_handle(side).idx();
            for (const double t : places)
                samples.push_back(
                    {{from, to, from, from}, {1 - t, t, 0, 0}, area / (places.size() * places.size()), true});
        }
    }
    return samples;
}

} // namespace qm
