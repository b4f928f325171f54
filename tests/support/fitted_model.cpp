#include "support/fitted_model.h"

#include "bspline/splines/spline_curve.h"
#include "mesh/dihedral.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace qm::test {

FittedModel fitted(const Grid& grid, const std::vector<Rectangle>& rectangles, const FitOptions& options) {
    FittedModel model{makeMesh(grid), makeLayout(grid, rectangles), {}};
    const std::vector<double> angles = dihedralAngles(model.mesh);
    model.surfaces = fitSurfaces(model.mesh, model.layout, angles, options);
    return model;
}

Grid sheet() {
    return {10, 8, [](double i, double j) { return Point(i, j, std::sin(0.5 * i) + std::cos(0.4 * j)); }};
}

std::vector<Rectangle> tJoint() {
    return {{0, 0, 10, 3, 2}, {0, 3, 6, 8, 1}, {6, 3, 10, 8, 3}};
}

FittedModel torus(const std::vector<std::array<int, 4>>& rectangles) {
    constexpr int around = 16;
    constexpr int across = 12;
    FittedModel model;
    const auto number = [](int i, int j) { return VertexId((j % across) * around + i % around); };
    for (int j = 0; j < across; ++j)
        for (int i = 0; i < around; ++i) {
            const double big = 2 * std::numbers::pi * i / around;
            const double small = 2 * std::numbers::pi * j / across;
            const double radius = 5 + 2 * std::cos(small);
            model.mesh.add_vertex({radius * std::cos(big), radius * std::sin(big), 2 * std::sin(small)});
        }
    for (int j = 0; j < across; ++j)
        for (int i = 0; i < around; ++i)
            model.mesh.add_face({number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
    for (const auto& [i0, j0, i1, j1] : rectangles) {
        Segment segment;
        segment.size = {i1 - i0, j1 - j0};
        for (int j = j0; j < j1; ++j)
            for (int i = i0; i < i1; ++i)
                segment.faces.emplace_back((j % across) * around + i % around);
        for (int i = i0; i <= i1; ++i) {
            segment.sides[0].push_back(number(i, j0));
            segment.sides[2].push_back(number(i1 + i0 - i, j1));
        }
        for (int j = j0; j <= j1; ++j) {
            segment.sides[1].push_back(number(i1, j));
            segment.sides[3].push_back(number(i0, j1 + j0 - j));
        }
        for (std::size_t k = 0; k < 4; ++k)
            segment.corners[k] = segment.sides[k].front();
        model.layout.segments.push_back(segment);
    }
    const std::vector<double> angles(model.mesh.n_edges(), 0.1); // coarse but smooth
    model.surfaces = fitSurfaces(model.mesh, model.layout, angles, FitOptions());
    return model;
}

FittedModel glued(const Grid& grid, int turned) {
    const QuadMesh flat = makeMesh(grid);
    FittedModel model;
    std::map<std::array<long, 3>, VertexId> known;
    std::vector<VertexId> merged;
    for (const VertexId vertex : flat.vertices()) {
        const Point point = flat.point(vertex);
        const auto key = [&](unsigned k) { return std::lround(point[k] * 1e6); };
        const auto [at, isNew] = known.try_emplace({key(0), key(1), key(2)});
        if (isNew) at->second = model.mesh.add_vertex(point);
        merged.push_back(at->second);
    }
    for (const FaceId face : flat.faces()) {
        std::vector<VertexId> corners;
        for (const VertexId vertex : flat.fv_range(face))
            corners.push_back(merged[static_cast<std::size_t>(vertex.idx())]);
        model.mesh.add_face(corners);
    }
    model.layout = makeLayout(grid, {{0, 0, grid.columns, grid.rows, turned}});
    for (Segment& segment : model.layout.segments) {
        for (auto& side : segment.sides)
            for (VertexId& vertex : side)
                vertex = merged[static_cast<std::size_t>(vertex.idx())];
        for (std::size_t k = 0; k < 4; ++k)
            segment.corners[k] = segment.sides[k].front();
    }
    const std::vector<double> angles(model.mesh.n_edges(), 0.1); // coarse but smooth
    model.surfaces = fitSurfaces(model.mesh, model.layout, angles, FitOptions());
    return model;
}

Grid loop() {
    return {
        1, 10, [](double i, double j) {
            const double side = i - 0.5;
            const double t = std::clamp(j - 1, 0.0, 6.0) * std::numbers::pi / 4;
            const double up = std::array{0.0, 1.5, 2.5, 3.5}[static_cast<std::size_t>(std::max(j - 7, 0.0))];
            const double back = j == 0 ? -1.5 : 0;
            const double radius = 2 - side;
            return Point(back + radius * std::sin(t), -2 + radius * std::cos(t) + up, 0.1 * std::sin(2 * t));
        }};
}

Grid helix() {
    return {2, 14, [](double i, double j) {
                const double t = std::numbers::pi * j / 3;
                return Point(2 * std::cos(t), 2 * std::sin(t), i + j / 3);
            }};
}

Grid pocket() {
    return {10, 2, [](double i, double j) {
                const double k = std::min(i, 10 - i);
                const double side = i < 5 ? 1 : -1;
                if (k <= 3) return Point(side * j, k, 0.2 * j);
                if (k < 5) return Point(side * 0.7 * (1 + j), 3.7 + 0.3 * j, 0.2 * j);
                return Point(0, 4.4 + j, 0.2 * j);
            }};
}

FitOptions interpolating() {
    FitOptions options;
    options.fit = Fit::interpolate;
    return options;
}

FittedModel bentSheet(Bend bend) {
    const Grid grid{4, 2, [](double i, double j) { return Point(i, j, 0.1 * i * i); }};
    FittedModel model = fitted(grid, {{0, 0, 4, 2}}, FitOptions());
    Patch& patch = model.surfaces.patches[0];
    Patch refined = patch;
    refined.knots[0] = {0, 0, 0, 0, 1, 2, 2, 2, 3, 4, 4, 4, 4};
    refined.controlPoints.clear();
    for (auto row = patch.controlPoints.begin(); row != patch.controlPoints.end(); row += patch.count[0]) {
        SplineCurve line = withKnots({patch.knots[0], {row, row + patch.count[0]}}, refined.knots[0]);
        if (bend == Bend::sharp)
            for (std::size_t k = 5; k < line.points.size(); ++k)
                line.points[k][2] += line.points[k][0] - 2;
        refined.controlPoints.insert(refined.controlPoints.end(), line.points.begin(), line.points.end());
        refined.count[0] = static_cast<int>(line.points.size());
    }
    patch = refined;
    return model;
}

FittedModel cup() {
    const Grid grid{24, 6, [](double i, double j) {
                        const double angle = std::numbers::pi * i / 24;
                        const double radius = j < 3 ? 2 : 2 - 0.4 * (j - 3);
                        return Point(radius * std::cos(angle), radius * std::sin(angle), std::min(j, 3.0));
                    }};
    FitOptions exact;
    exact.tolerance = {0.01, true};
    return fitted(grid, {{0, 0, 24, 3}, {0, 3, 24, 6}}, exact);
}

} // namespace qm::test
