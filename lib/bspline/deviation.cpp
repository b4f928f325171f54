#include "bspline/deviation.h"

#include "base/parallel.h"
#include "bspline/borders.h"
#include "bspline/evaluate.h"
#include "bspline/interpolate.h"
#include "bspline/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qm {
namespace {

/// Where on every border edge gaps are measured. Kinks are measured between the edge's ends only: at a vertex
/// a patch may have more than one normal.
constexpr std::array<double, 6> borderSamples = {0, 0.05, 0.35, 0.65, 0.95, 1};

/// What was measured on one patch.
struct Samples {
    std::vector<double> distances;
    std::vector<double> kinks;
    double gap = 0;
    double normalDeviation = 0;
    std::vector<DeviatingPlace> places;
};

double rootMeanSquare(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        sum += value * value;
    return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

double largest(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

/// The smallest value that at least 95 of 100 do not exceed.
double percentile95(std::vector<double> values) {
    if (values.empty()) return 0;
    const std::size_t rank = (values.size() * 19 + 19) / 20 - 1;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
    return values[rank];
}

Deviation summary(const Samples& samples, double diagonal) {
    Deviation result;
    result.max = largest(samples.distances);
    result.rms = rootMeanSquare(samples.distances);
    result.percentile95 = percentile95(samples.distances);
    result.largestGap = samples.gap;
    if (diagonal > 0) {
        result.maxRelative = result.max / diagonal;
        result.rmsRelative = result.rms / diagonal;
        result.percentile95Relative = result.percentile95 / diagonal;
        result.largestGapRelative = result.largestGap / diagonal;
    }
    result.largestKink = largest(samples.kinks);
    result.rmsKink = rootMeanSquare(samples.kinks);
    result.largestNormalDeviation = samples.normalDeviation;
    return result;
}

std::vector<double> latticeParameters(int edges, int steps) {
    std::vector<double> parameters;
    for (int k = 0; k <= edges * steps; ++k)
        parameters.push_back(static_cast<double>(k) / steps);
    return parameters;
}

/// The angle between the quads on both sides of an edge, at a share of it: bilinear quads turn along an edge,
/// and fold at a corner that is concave.
double kinkOfQuads(const QuadMesh& mesh, HalfedgeId halfedge, double along) {
    const auto normal = [&](HalfedgeId h, double share) {
        const Point& start = mesh.point(mesh.from_vertex_handle(h));
        const Point& end = mesh.point(mesh.to_vertex_handle(h));
        const Point atStart = mesh.point(mesh.from_vertex_handle(mesh.prev_halfedge_handle(h))) - start;
        const Point atEnd = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h))) - end;
        return unitNormal(end - start, (1 - share) * atStart + share * atEnd);
    };
    return angleInDegrees(normal(halfedge, along),
                          normal(mesh.opposite_halfedge_handle(halfedge), 1 - along));
}

/// A segment's vertices as a piecewise bilinear surface over the patch's parameters.
class QuadGrid {
public:
    QuadGrid(std::vector<Point> points, std::array<int, 2> size) : points_(std::move(points)), size_(size) {}

    [[nodiscard]] Point at(double u, double v) const {
        const int i = std::clamp(static_cast<int>(u), 0, size_[0] - 1);
        const int j = std::clamp(static_cast<int>(v), 0, size_[1] - 1);
        return bilinear(corners(i, j), u - i, v - j);
    }

    [[nodiscard]] Point normalAtCentre(int i, int j) const {
        const QuadCorners c = corners(i, j);
        return unitNormal(c[1] + c[2] - c[0] - c[3], c[2] + c[3] - c[0] - c[1]);
    }

private:
    [[nodiscard]] QuadCorners corners(int i, int j) const {
        const auto step = static_cast<std::size_t>(size_[0]) + 1;
        const std::size_t first = static_cast<std::size_t>(j) * step + static_cast<std::size_t>(i);
        return {points_[first], points_[first + 1], points_[first + step + 1], points_[first + step]};
    }

    std::vector<Point> points_;
    std::array<int, 2> size_;
};

/// Least distance that Gauss and Newton's iteration finds from the surface's point at (u, v), whose
/// distance is known, on.
double distanceToPatch(const Patch& patch, const Point& point, double u, double v, SurfacePoint on) {
    const auto range = domain(patch);
    double best = (on.position - point).norm();
    for (int k = 0; k < 10; ++k) {
        const Point away = on.position - point;
        const double uu = on.du.sqrnorm();
        const double vv = on.dv.sqrnorm();
        const double uv = on.du | on.dv;
        const double gu = away | on.du;
        const double gv = away | on.dv;
        const double determinant = uu * vv - uv * uv;
        if (!(determinant > 1e-12 * uu * vv)) break;
        const double stepU = std::clamp(u + (uv * gv - vv * gu) / determinant, range[0][0], range[0][1]) - u;
        const double stepV = std::clamp(v + (uv * gu - uu * gv) / determinant, range[1][0], range[1][1]) - v;
        if (std::abs(stepU) + std::abs(stepV) < 1e-6) break;
        double distance = best;
        SurfacePoint next = on;
        double share = 1;
        for (int halving = 0; halving < 5; ++halving, share /= 2) {
            next = evaluate(patch, u + share * stepU, v + share * stepV);
            distance = (next.position - point).norm();
            if (distance < best) break;
        }
        const bool settled = distance > 0.999 * best;
        best = std::min(best, distance);
        if (settled) break;
        u += share * stepU;
        v += share * stepV;
        on = next;
    }
    return best;
}

void measurePatch(const Patch& patch, const Segment& segment, const QuadGrid& quads, const MeshDistance& mesh,
                  const DeviationOptions& options, double negligible, Samples& samples) {
    const auto us = latticeParameters(segment.size[0], options.samplesPerEdge);
    const auto vs = latticeParameters(segment.size[1], options.samplesPerEdge);
    const auto points = evaluateLattice(patch, us, vs);
    samples.distances.reserve(2 * points.size());
    std::size_t k = 0;
    for (const double v : vs)
        for (const double u : us) {
            const SurfacePoint& on = points[k++];
            const Point of = quads.at(u, v);
            const double bound = (on.position - of).norm();
            if (bound <= negligible) {
                samples.distances.insert(samples.distances.end(), 2, bound);
                continue;
            }
            const double there = mesh(on.position, bound);
            const double back = distanceToPatch(patch, of, u, v, on);
            samples.distances.insert(samples.distances.end(), {there, back});
            if (!(std::max(there, back) <= options.farthest))
                samples.places.push_back({{u, v}, std::max(there, back)});
        }
}

void measureNormals(const Patch& patch, const Segment& segment, const QuadGrid& quads, double mostBent,
                    Samples& samples) {
    const auto centres = [](int edges) {
        std::vector<double> parameters(static_cast<std::size_t>(edges), 0.5);
        for (int k = 0; k < edges; ++k)
            parameters[static_cast<std::size_t>(k)] += k;
        return parameters;
    };
    const auto points = evaluateLattice(patch, centres(segment.size[0]), centres(segment.size[1]));
    std::size_t k = 0;
    for (int j = 0; j < segment.size[1]; ++j)
        for (int i = 0; i < segment.size[0]; ++i, ++k) {
            const double angle =
                angleInDegrees(unitNormal(points[k].du, points[k].dv), quads.normalAtCentre(i, j));
            samples.normalDeviation = std::max(samples.normalDeviation, angle);
            if (angle > mostBent) samples.places.push_back({{i + 0.5, j + 0.5}, 0});
        }
}

/// Gap and kinks along one edge of the layout.
struct Meeting {
    double gap = 0;
    std::vector<double> kinks;
    std::vector<double> bent; ///< shares of the edge at which a kink is too large
};

Meeting measureMeeting(const QuadMesh& mesh, const BorderEdge& border, const Layout& layout,
                       const std::vector<Patch>& patches, bool smooth, double mostKinked) {
    Meeting meeting;
    if (border.places.size() != 2) return meeting;
    for (const double along : borderSamples) {
        std::array<SurfacePoint, 2> points;
        for (std::size_t p = 0; p < 2; ++p) {
            const BorderPlace& place = border.places[p];
            const auto [u, v] = parametersOnSide(layout.segments[place.patch].size, place.side,
                                                 place.position + (p == 0 ? along : 1 - along));
            points[p] = evaluate(patches[place.patch], u, v);
        }
        meeting.gap = std::max(meeting.gap, (points[0].position - points[1].position).norm());
        if (!smooth || along == 0 || along == 1) continue;
        meeting.kinks.push_back(
            angleInDegrees(unitNormal(points[0].du, points[0].dv), unitNormal(points[1].du, points[1].dv)));
        if (meeting.kinks.back() > mostKinked && kinkOfQuads(mesh, border.halfedge, along) < mostKinked)
            meeting.bent.push_back(along);
    }
    return meeting;
}

void addMeeting(const Meeting& meeting, Samples& samples) {
    samples.gap = std::max(samples.gap, meeting.gap);
    samples.kinks.insert(samples.kinks.end(), meeting.kinks.begin(), meeting.kinks.end());
}

/// Moves the distances out of `samples`, adds the rest to `all`.
void gather(Samples& samples, Samples& all) {
    all.distances.insert(all.distances.end(), samples.distances.begin(), samples.distances.end());
    all.gap = std::max(all.gap, samples.gap);
    all.normalDeviation = std::max(all.normalDeviation, samples.normalDeviation);
    samples = {};
}

} // namespace

double boundingBoxDiagonal(const QuadMesh& mesh) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Point low(infinity, infinity, infinity);
    Point high = -low;
    for (const FaceId face : mesh.faces())
        for (const VertexId vertex : mesh.fv_range(face)) {
            low.minimize(mesh.point(vertex));
            high.maximize(mesh.point(vertex));
        }
    return mesh.n_faces() == 0 ? 0 : (high - low).norm();
}

MeasuredDeviation measureDeviation(const QuadMesh& mesh, const Layout& layout,
                                   const std::vector<double>& dihedralAngles,
                                   const std::vector<Patch>& patches, const DeviationOptions& options,
                                   const Control& control) {
    const double diagonal = boundingBoxDiagonal(mesh);
    const MeshDistance distance(mesh);
    const auto counts = [&](std::size_t patch) { return options.only.empty() || options.only[patch]; };
    std::vector<Samples> ofPatch(patches.size());
    parallelFor(patches.size(), control.jobs, [&](std::size_t k) {
        if (!counts(k)) return;
        const Segment& segment = layout.segments[k];
        const QuadGrid quads(pointGrid(mesh, segment), segment.size);
        measurePatch(patches[k], segment, quads, distance, options, 1e-14 * diagonal, ofPatch[k]);
        measureNormals(patches[k], segment, quads, options.mostBent, ofPatch[k]);
    });

    const auto borders = borderEdges(mesh, layout);
    std::vector<Meeting> meetings(borders.size());
    parallelFor(borders.size(), control.jobs, [&](std::size_t k) {
        if (std::ranges::none_of(borders[k].places, counts, &BorderPlace::patch)) return;
        const auto edge = static_cast<std::size_t>(mesh.edge_handle(borders[k].halfedge).idx());
        meetings[k] = measureMeeting(mesh, borders[k], layout, patches, dihedralAngles[edge] <= options.rho,
                                     options.mostKinked);
    });

    MeasuredDeviation result;
    Samples all;
    for (std::size_t k = 0; k < borders.size(); ++k) {
        addMeeting(meetings[k], all);
        for (std::size_t p = 0; p < borders[k].places.size(); ++p) {
            const BorderPlace& place = borders[k].places[p];
            addMeeting(meetings[k], ofPatch[place.patch]);
            for (const double along : meetings[k].bent)
                ofPatch[place.patch].places.push_back(
                    {parametersOnSide(layout.segments[place.patch].size, place.side,
                                      place.position + (p == 0 ? along : 1 - along)),
                     0});
        }
    }
    for (Samples& samples : ofPatch) {
        result.ofPatch.push_back(summary(samples, diagonal));
        result.places.push_back(std::move(samples.places));
        gather(samples, all);
    }
    result.ofAll = summary(all, diagonal);
    return result;
}

} // namespace qm
