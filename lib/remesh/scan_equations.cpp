#include "remesh/scan_equations.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/splines/evaluate.h"
#include "mesh/quad_geometry.h"

#include <cmath>
#include <cstddef>
#include <optional>

namespace qm {
namespace {

constexpr double minCosine = 0.4; ///< between the normals of places that belong together

/// Weights of a triangle's corners that give a point of it; none if it has no area.
std::optional<std::array<double, 3>> weightsOf(const Triangle& corners, const Point& at) {
    const Point normal = (corners[1] - corners[0]) % (corners[2] - corners[0]);
    const double square = normal.sqrnorm();
    if (!(square > 0)) return std::nullopt;
    std::array<double, 3> weights{};
    for (std::size_t k = 0; k < 3; ++k)
        weights[k] = (((corners[(k + 1) % 3] - at) % (corners[(k + 2) % 3] - at)) | normal) / square;
    return weights;
}

class Equations {
public:
    Equations(const QuadMesh& mesh, const TriangleSurface& scan, double reach)
        : mesh_(mesh), halves_(halves(mesh)), quads_(halves_), scan_(scan), reach_(reach) {}

    /// \return of no weight where the scan shows nothing
    [[nodiscard]] ScanEquation towardsScan(const QuadSample& sample) const {
        ScanEquation equation{sample.vertices, sample.weights};
        Point place{0, 0, 0};
        for (std::size_t k = 0; k < 4; ++k)
            place += sample.weights[k] * pointOf(sample.vertices[k]);
        const auto foot = scan_.nearest(place, reach_);
        if (!foot || foot->onBoundary != sample.onBoundary) return equation;
        const std::optional<Point> normal = triangleNormal(scan_.corners(foot->face));
        if (!normal) return equation;
        const Point own = (pointOf(sample.vertices[2]) - pointOf(sample.vertices[0])) %
                          (pointOf(sample.vertices[3]) - pointOf(sample.vertices[1]));
        if (!foot->onBoundary && scan_.cosineAt(*foot, unit(own)) <= minCosine) return equation;
        require(equation, foot->position - place, *normal, foot->onBoundary, sample.area);
        return equation;
    }

    [[nodiscard]] ScanEquation towardsSample(const ScanSample& sample) const {
        ScanEquation equation;
        const auto foot = quads_.nearest(sample.position, reach_);
        if (!foot) return equation;
        const auto corners = quads_.corners(foot->face);
        const std::optional<Point> own = triangleNormal(corners);
        const auto weights = weightsOf(corners, foot->position);
        const bool agree = own && (*own | sample.normal) > minCosine * own->norm() * sample.normal.norm();
        if (!agree || !weights) return equation;
        const auto& vertices = halves_.faces[foot->face];
        equation.vertices = {vertices[0], vertices[1], vertices[2], vertices[0]};
        equation.weights = {(*weights)[0], (*weights)[1], (*weights)[2], 0};
        require(equation, sample.position - foot->position, sample.normal, foot->onBoundary, sample.area);
        return equation;
    }

private:
    [[nodiscard]] const Point& pointOf(int vertex) const { return mesh_.point(VertexId(vertex)); }

    void require(ScanEquation& equation, const Point& gap, const Point& normal, bool straight,
                 double area) const {
        constexpr double beside = 0.7; // beyond a sharp edge, in the plane of one of its sides
        const double length = gap.norm();
        straight = straight || std::abs(gap | normal) < beside * length;
        equation.direction = straight && length > 0 ? gap / length : normal;
        equation.distance = gap | equation.direction;
        const double share = length / (reach_ / 3); // in halves of a mean edge
        equation.weight = area / ((1 + share * share) * (1 + share * share));
    }

    const QuadMesh& mesh_;
    Triangles halves_;
    TriangleSurface quads_;
    const TriangleSurface& scan_;
    double reach_;
};

} // namespace

std::vector<ScanEquation> scanEquations(const QuadMesh& mesh, const TriangleSurface& scan,
                                        const std::vector<ScanSample>& samples, double reach, unsigned jobs) {
    const std::vector<QuadSample> ofQuads = samplesOfQuads(mesh);
    const Equations equations(mesh, scan, reach);
    std::vector<ScanEquation> all(ofQuads.size() + samples.size());
    parallelForMany(all.size(), jobs, [&](std::size_t k) {
        all[k] = k < ofQuads.size() ? equations.towardsScan(ofQuads[k])
                                    : equations.towardsSample(samples[k - ofQuads.size()]);
    });
    std::erase_if(all, [](const ScanEquation& equation) { return !(equation.weight > 0); });
    return all;
}

} // namespace qm
