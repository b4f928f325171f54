#include "base/at.h"
#include "bspline/reference/lattice/lattice_normals.h"
#include "bspline/reference/scan/scan_projection.h"
#include "bspline/reference/scan/scan_reference.h"
#include "mesh/bounding_box.h"
#include "mesh/dihedral.h"
#include "shape/scan.h"
#include "shape/shape.h"
#include "support/limit_sample.h"
#include "support/true_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace qm {
namespace {

/// A coarse mesh of a sample part in which every quad is a segment, and its limit surface.
struct Part {
    std::string name;
    QuadMesh mesh;
    Layout layout;
    std::vector<ReferenceGrid> limit;
    double diagonal;

    Part(const std::string& part, int resolution, double rho = 0.6)
        : name(part), mesh(makeShape(part, {.resolution = resolution})), layout(test::segmentPerQuad(mesh)),
          diagonal(boundingBoxOf(makeScan(part, 2000).points).diagonal()) {
        std::vector<bool> creases;
        for (const double angle : dihedralAngles(mesh))
            creases.push_back(angle > rho);
        limit = test::limitSurface(mesh, layout, creases, 2, 1);
    }

    [[nodiscard]] FitTarget against(const Triangles& scan, unsigned jobs = 1) const {
        return scanReference(mesh, layout, limit, TriangleSurface(scan), jobs);
    }
    /// The points of the surface for which a scan is found, and their share of all.
    struct Projected {
        std::vector<Point> points;
        double share = 0;
    };
    [[nodiscard]] Projected projected(const Triangles& scan, double reach) const {
        const LatticeNormals lattice = latticeNormals(mesh, layout, limit, 1);
        const auto displacements =
            projectOntoScan(lattice, TriangleSurface(scan), {reach, reach}, 1).displacements;
        Projected result;
        for (std::size_t k = 0; k < displacements.size(); ++k)
            if (displacements[k]) result.points.push_back(point(lattice.points[k]));
        result.share = static_cast<double>(result.points.size()) / static_cast<double>(displacements.size());
        return result;
    }
    [[nodiscard]] double distance(const Point& point) const {
        return test::trueSurface(name)->nearest(point).distance;
    }

    /// Root mean square distance of weighted targets from the true surface.
    [[nodiscard]] double error(const FitTarget& reference) const {
        double sum = 0;
        double count = 0;
        for (std::size_t g = 0; g < reference.grids.size(); ++g)
            for (std::size_t k = 0; k < reference.weights[g].size(); ++k) {
                const double off = distance(reference.grids[g].points[k]);
                sum += reference.weights[g][k] * off * off;
                count += reference.weights[g][k];
            }
        return std::sqrt(sum / count);
    }
};

Triangles without(const Triangles& scan, const std::function<bool(const Point&)>& gone) {
    Triangles result{scan.points, {}};
    for (const auto& face : scan.faces)
        if (!gone(scan.points[at(face[0])])) result.faces.push_back(face);
    return result;
}

TEST(ScanReference, CoversCleanScansOfAllPartsAndLiesOnThem) {
    for (const char* name : {"sphere", "torus", "cylinder", "cube", "genus3", "block"}) {
        const Part part(name, 5);
        const FitTarget reference = part.against(makeScan(name, 60000));
        EXPECT_GT(reference.coverage, 0.98) << name;
        EXPECT_LT(part.error(reference), 2e-4 * part.diagonal) << name;
        EXPECT_GT(reference.maxDistance, 0);
    }
}

TEST(ScanReference, IsNearerToTheTruthThanTheLimitOfACoarseMesh) {
    const Part part("torus", 2, 1);
    FitTarget limit{part.limit, {}};
    for (const ReferenceGrid& grid : part.limit)
        limit.weights.emplace_back(grid.points.size(), 1.0);
    EXPECT_LT(part.error(part.against(makeScan("torus", 300'000))), part.error(limit) / 4);
}

TEST(ScanReference, BordersAreTheSameOnBothSidesAndOnAnyNumberOfThreads) {
    const Part part("block", 3);
    Triangles scan = makeScan("block", 20000);
    addNoise(scan, 5e-4 * part.diagonal, 1);
    const FitTarget one = part.against(scan);
    const FitTarget three = part.against(scan, 3);
    for (std::size_t g = 0; g < one.grids.size(); ++g) {
        EXPECT_EQ(one.grids[g].points, three.grids[g].points);
        EXPECT_EQ(one.weights[g], three.weights[g]);
        for (std::size_t other = 0; other < g; ++other)
            for (std::size_t k = 0; k < part.limit[g].points.size(); ++k)
                for (std::size_t n = 0; n < part.limit[other].points.size(); ++n)
                    if (part.limit[g].points[k] == part.limit[other].points[n]) {
                        EXPECT_EQ(one.grids[g].points[k], one.grids[other].points[n]);
                        EXPECT_EQ(one.weights[g][k], one.weights[other][n]);
                    }
    }
}

TEST(ScanReference, HolesAreFilledFromAround) {
    const Part part("sphere", 8);
    // The scan is larger than the mesh; so the targets must be, also where the scan has a hole.
    Triangles scan = makeScan("sphere", 60000);
    for (Point& point : scan.points)
        point *= 1.01;
    const auto gone = [](const Point& point) { return point[2] > 0.8; };
    const FitTarget reference = part.against(without(scan, gone));
    for (std::size_t g = 0; g < reference.grids.size(); ++g)
        for (std::size_t k = 0; k < reference.weights[g].size(); ++k) {
            const double height = part.limit[g].points[k][2];
            if (height > 0.83) {
                EXPECT_LT(reference.weights[g][k], 0.5);
                EXPECT_NEAR(reference.grids[g].points[k].norm(), 1.01, 0.01);
                EXPECT_GT(reference.grids[g].points[k].norm(), part.limit[g].points[k].norm());
            }
            if (height < 0.77) {
                EXPECT_GT(reference.weights[g][k], 0.5);
            }
        }
    EXPECT_NEAR(reference.coverage, 0.9, 0.05);
}

TEST(ScanReference, OutliersWeighNothing) {
    const Part part("sphere", 8);
    Triangles scan = makeScan("sphere", 60000);
    for (std::size_t k = 0; k < scan.points.size(); k += 500)
        scan.points[k] *= 1.1;
    const FitTarget reference = part.against(scan);
    EXPECT_GT(reference.coverage, 0.9);
    EXPECT_LT(part.error(reference), 2e-3);
}

TEST(ScanProjection, TakesNoOtherSideOfAThinWall) {
    // The scan of the plate's top alone is a scan of what lies below it, seen from there.
    const Part part("cube", 6);
    const auto top = [](const Point& point) { return point[2] < 0.999; };
    constexpr double oppositeFace = 5; // is nearer
    const auto found = part.projected(without(makeScan("cube", 20000), top), oppositeFace);
    EXPECT_GT(found.share, 0.1);
    for (const Point& point : found.points)
        EXPECT_GT(point[2], 0.5);
}

TEST(ScanReference, DoesNotMindHowTheScanIsOriented) {
    const Part part("torus", 3);
    const Triangles scan = makeScan("torus", 20000);
    Triangles inverted = scan;
    for (auto& face : inverted.faces)
        std::swap(face[0], face[1]);
    const FitTarget expected = part.against(scan);
    const FitTarget found = part.against(inverted);
    EXPECT_EQ(found.coverage, expected.coverage);
    EXPECT_NEAR(part.error(found), part.error(expected), 1e-9);
}

TEST(ScanReference, KeepsEdgesSharpThatTheScanHasRounded) {
    const Part part("cube", 6);
    Triangles scan = makeScan("cube", 60000);
    for (Point& point : scan.points) { // pulls in all points near two or three faces
        double near = 0;
        for (const double coordinate : point)
            near += std::max(0.0, 1 - std::min(coordinate, 1 - coordinate) / 0.02);
        if (near > 1.2) point += 0.01 * (Point(0.5, 0.5, 0.5) - point).normalized();
    }
    const FitTarget reference = part.against(scan);
    for (std::size_t g = 0; g < reference.grids.size(); ++g)
        for (std::size_t k = 0; k < reference.weights[g].size(); ++k) {
            int sides = 0;
            for (const double coordinate : part.limit[g].points[k])
                if (coordinate < 1e-9 || coordinate > 1 - 1e-9) ++sides;
            if (sides < 2) continue;
            EXPECT_GT(reference.weights[g][k], 0);
            EXPECT_LT((reference.grids[g].points[k] - part.limit[g].points[k]).norm(), 1e-6);
        }
}

TEST(ScanProjection, FindsNothingOutOfReach) {
    const Part part("sphere", 6);
    Triangles scan = makeScan("sphere", 20000);
    for (Point& point : scan.points)
        point *= 1.05;
    EXPECT_EQ(part.projected(scan, 0.02).share, 0);
    EXPECT_GT(part.projected(scan, 0.08).share, 0.99);
}

} // namespace
} // namespace qm
