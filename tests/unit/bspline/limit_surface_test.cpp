#include "base/at.h"
#include "bspline/network/vertex_rules.h"
#include "bspline/reference/lattice/bilinear_quad.h"
#include "bspline/reference/lattice/mesh_lattice.h"
#include "bspline/reference/lattice/sound_faces.h"
#include "bspline/reference/lattice/vertex_stencil.h"
#include "bspline/reference/limit/control_mesh.h"
#include "bspline/splines/evaluate.h"
#include "mesh/dihedral.h"
#include "shape/shape.h"
#include "support/grid_layout.h"
#include "support/limit_sample.h"
#include "support/polycube.h"
#include "support/quad_layout.h"
#include "support/random_graph.h"
#include "support/rounded_box.h"
#include "support/star_mesh.h"
#include "support/steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <string>

namespace qm {
namespace {

using Kind = VertexRule::Kind;
using test::bentFan;
using test::creasesAndBoundary;
using test::Grid;
using test::limitSurface;
using test::noCreases;
using test::segmentPerQuad;

std::vector<bool> sharperThan(const QuadMesh& mesh, double angle) {
    std::vector<bool> creases;
    for (const double theta : dihedralAngles(mesh))
        creases.push_back(theta > angle);
    return creases;
}

/// The largest distance of lattice points from a surface.
double largestError(const std::vector<ReferenceGrid>& grids,
                    const std::function<double(const Point&)>& distance) {
    double largest = 0;
    for (const ReferenceGrid& grid : grids)
        for (const Point& point : grid.points)
            largest = std::max(largest, std::abs(distance(point)));
    return largest;
}

double limitError(const std::string& shape, int resolution,
                  const std::function<double(const Point&)>& distance) {
    ShapeOptions options;
    options.resolution = resolution;
    const QuadMesh mesh = makeShape(shape, options);
    return largestError(limitSurface(mesh, segmentPerQuad(mesh), noCreases(mesh), 4, 1), distance);
}

// ------------------------------------------------------------------------------- shape

TEST(LimitSurface, ApproachesTheSphereOfASphericalMesh) {
    const auto distance = [](const Point& point) { return point.norm() - 1; };
    const double coarse = limitError("sphere", 6, distance);
    const double fine = limitError("sphere", 12, distance);
    EXPECT_LT(coarse, 5e-4);
    EXPECT_LT(fine, coarse / 3);
}

TEST(LimitSurface, ApproachesATorusWithTheFourthPowerOfTheEdge) {
    const auto torus = [](int n) {
        QuadMesh mesh = test::quadMesh(test::torus(2 * n, n));
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < 2 * n; ++i) {
                const double u = std::numbers::pi * i / n;
                const double v = 2 * std::numbers::pi * j / n;
                mesh.set_point(VertexId(j * 2 * n + i), {(3 + std::cos(v)) * std::cos(u),
                                                         (3 + std::cos(v)) * std::sin(u), std::sin(v)});
            }
        return mesh;
    };
    const auto distance = [](const Point& p) { return std::hypot(std::hypot(p[0], p[1]) - 3, p[2]) - 1; };
    const auto error = [&](int n) {
        const QuadMesh mesh = torus(n);
        return largestError(limitSurface(mesh, segmentPerQuad(mesh), noCreases(mesh), 4, 1), distance);
    };
    EXPECT_LT(error(16), 1e-3);
    EXPECT_LT(error(32), error(16) / 14);
}

TEST(MeshLattice, IsTheBicubicSplineOfItsControlMeshWhereThatIsRegular) {
    const Grid sheet{9, 8, [](double i, double j) {
                         return Point(i + 0.2 * std::sin(j), j, std::sin(0.7 * i) * std::cos(0.4 * j));
                     }};
    const QuadMesh mesh = test::makeMesh(sheet);
    const Layout layout = test::makeLayout(sheet, {{0, 0, 9, 8, 0}});
    const auto sharp = creasesAndBoundary(mesh, noCreases(mesh));
    const auto rules = vertexRules(mesh, layout, sharp);
    const ControlMesh control = interpolatingControlMesh(mesh, rules);
    Patch patch;
    patch.count = {10, 9};
    patch.controlPoints = control.points;
    for (std::size_t side = 0; side < 2; ++side)
        for (int k = 0; k < patch.count[side] + 4; ++k)
            patch.knots[side].push_back(k - 2); // control point k lies above k
    for (const int steps : {2, 4, 8}) {
        MeshLattice lattice(mesh, control.points);
        while (lattice.squares() < steps)
            lattice = lattice.subdivided({rules, sharp}, 1);
        lattice = lattice.limit({rules, sharp}, 1);
        ReferenceGrid grid{layout.segments.front().size, steps};
        for (const std::size_t number : lattice.numbers().ofSegment(layout.segments.front()))
            grid.points.push_back(lattice.point(number));
        for (int j = steps; j <= 7 * steps; ++j)
            for (int i = steps; i <= 8 * steps; ++i) {
                const double u = static_cast<double>(i) / steps;
                const double v = static_cast<double>(j) / steps;
                EXPECT_LT((grid.evaluate(u, v).position - evaluate(patch, u, v).position).norm(), 1e-11)
                    << u << ' ' << v;
            }
    }
}

/// A sheet in which narrow columns follow wide ones, where a spline through all vertices would turn back.
/// \param bend  angle between successive rows of quads
Grid unevenSheet(double bend) {
    const std::vector<double> columns{0, 1, 2, 2.02, 2.04, 3, 4};
    std::vector<Point> rows{Point(0, 0, 0)};
    for (int row = 0; row < 4; ++row)
        rows.push_back(rows.back() + Point(0, std::cos(bend * row), std::sin(bend * row)));
    return {6, 4, [=](double i, double j) {
                return Point(columns[static_cast<std::size_t>(i)], 0, 0) + rows[static_cast<std::size_t>(j)];
            }};
}

TEST(LimitSurface, DoesNotFoldOverQuadsOfUnevenWidth) {
    for (const double bend : {0.0, 0.2, 0.6}) {
        const Grid grid = unevenSheet(bend);
        const QuadMesh mesh = test::makeMesh(grid);
        const Layout layout = test::makeLayout(grid, {{0, 0, 6, 4}});
        const ReferenceGrid reference = limitSurface(mesh, layout, noCreases(mesh), 4, 1).front();
        const std::size_t width = 6 * 4 + 1;
        for (std::size_t row = 0; row <= 16; ++row)
            for (std::size_t k = 1; k < width; ++k)
                EXPECT_GT(reference.points[row * width + k][0], reference.points[row * width + k - 1][0])
                    << "bend " << bend << ", point " << k << " of row " << row;
    }
}

struct StarEdge {
    double length;
    double angle; ///< degrees
};

/// Parallelograms around a vertex, which are the first faces, inside a ring of quads.
/// \param edges  from the middle vertex, counter-clockwise
/// \param slope  of the edges, which go up and down by turns
QuadMesh starMesh(const std::vector<StarEdge>& edges, double slope = 0) {
    const auto end = [&](std::size_t k) {
        const auto& [length, degrees] = edges[k % edges.size()];
        const double angle = degrees * std::numbers::pi / 180;
        return length * Point(std::cos(angle), std::sin(angle), k % edges.size() % 2 == 0 ? slope : -slope);
    };
    QuadMesh mesh;
    const VertexId middle = mesh.add_vertex(Point(0, 0, 0));
    std::vector<VertexId> ring;
    std::vector<VertexId> outer;
    for (std::size_t k = 0; k < edges.size(); ++k) {
        ring.push_back(mesh.add_vertex(end(k)));
        ring.push_back(mesh.add_vertex(end(k) + end(k + 1)));
    }
    for (const VertexId vertex : ring)
        outer.push_back(mesh.add_vertex(1.6 * mesh.point(vertex)));
    for (std::size_t k = 0; k < ring.size(); k += 2)
        mesh.add_face({middle, ring[k], ring[k + 1], ring[(k + 2) % ring.size()]});
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::size_t next = (k + 1) % ring.size();
        mesh.add_face({ring[k], outer[k], outer[next], ring[next]});
    }
    return mesh;
}

/// Edges of very different lengths, where the surface once turned over between the lattice's points: at
/// corners of up to 141 degrees, and then along edges.
std::vector<std::vector<StarEdge>> unevenStars() {
    return {{{0.26, 0}, {1.12, 42}, {0.46, 183}, {0.24, 244}, {0.75, 315}},
            {{1.19, 0}, {0.27, 54}, {0.36, 127}, {1.16, 234}, {0.31, 321}},
            {{1.04, 0}, {0.21, 60}, {0.84, 178}, {0.75, 276}, {0.32, 316}},
            {{0.99, 0}, {0.62, 76}, {0.24, 169}, {0.79, 259}, {0.21, 310}},
            {{0.27, 0}, {0.3, 62}, {0.51, 113}, {1.19, 200}, {0.32, 245}, {1.12, 288}},
            {{1.16, 0}, {0.2, 72}, {0.19, 114}, {0.19, 171}, {1.14, 235}, {0.2, 292}},
            {{0.24, 0}, {0.32, 75}, {1.11, 128}, {0.31, 181}, {1.04, 243}, {1.01, 284}},
            {{0.6, 0}, {0.31, 52}, {1.1, 136}, {0.25, 184}, {1.18, 225}, {0.78, 274}}};
}

void expectUpright(const ReferenceGrid& grid, const std::string& where) {
    const BilinearQuad quad({grid.vertex(0, 0), grid.vertex(1, 0), grid.vertex(1, 1), grid.vertex(0, 1)});
    constexpr int samples = 32;
    for (int j = 0; j <= samples; ++j)
        for (int i = 0; i <= samples; ++i) {
            const double u = 1.0 * i / samples, v = 1.0 * j / samples;
            const SurfacePoint point = grid.evaluate(u, v);
            const SurfacePoint below = quad.evaluate(u, v);
            EXPECT_GT((point.du % point.dv) | (below.du % below.dv), 0) << where << " at " << u << ' ' << v;
        }
}

TEST(LimitSurface, DoesNotFoldOverPlaneQuadsOfVeryDifferentShape) {
    for (const auto& edges : unevenStars()) {
        const QuadMesh mesh = starMesh(edges);
        const auto grids = limitSurface(mesh, segmentPerQuad(mesh), noCreases(mesh), 4, 1);
        for (std::size_t face = 0; face < edges.size(); ++face)
            expectUpright(grids[face], "face " + std::to_string(face));
    }
}

TEST(LimitSurface, DoesNotFoldOverTwistedQuadsOfVeryDifferentShape) {
    for (const auto& edges : unevenStars())
        for (const double slope : {0.2, 0.4, 0.6}) {
            const QuadMesh mesh = starMesh(edges, slope);
            const std::vector<bool> isUpright = uprightFaces(mesh, noCreases(mesh), 1);
            const auto grids = limitSurface(mesh, segmentPerQuad(mesh), noCreases(mesh), 4, 1);
            for (std::size_t face = 0; face < mesh.n_faces(); ++face)
                if (isUpright[face])
                    expectUpright(grids[face],
                                  "face " + std::to_string(face) + ", slope " + std::to_string(slope));
        }
}

TEST(LimitSurface, BendsWhereItWouldHaveFolded) {
    // Redrawn quads follow the others around the bend: their middle is as far from the facet as that of an
    // arc.
    constexpr double bend = 0.2;
    const Grid grid = unevenSheet(bend);
    const QuadMesh mesh = test::makeMesh(grid);
    const ReferenceGrid reference =
        limitSurface(mesh, test::makeLayout(grid, {{0, 0, 6, 4}}), noCreases(mesh), 4, 1).front();
    const double rise = std::tan(bend / 4) / 2; // of an arc over a chord of length 1
    const std::size_t width = 6 * 4 + 1;
    for (const std::size_t column : {1U * 4, 2U * 4, 3U * 4, 4U * 4}) {
        const auto point = [&](std::size_t row) { return reference.points[row * width + column]; };
        const double found = (point(6) - (point(4) + point(8)) / 2).norm();
        EXPECT_NEAR(found, rise, 0.3 * rise) << "column " << column;
    }
}

TEST(LimitSurface, KeepsThePlanesAndEdgesOfACube) {
    const QuadMesh mesh = makeShape("cube", {5});
    const auto grids = limitSurface(mesh, segmentPerQuad(mesh), sharperThan(mesh, 0.5), 4, 1);
    const Point corner = mesh.point(VertexId(0));
    double low = corner[0];
    double high = corner[0];
    for (const VertexId vertex : mesh.vertices())
        for (int axis = 0; axis < 3; ++axis) {
            low = std::min(low, mesh.point(vertex)[at(axis)]);
            high = std::max(high, mesh.point(vertex)[at(axis)]);
        }
    for (const ReferenceGrid& grid : grids)
        for (const Point& point : grid.points) {
            double off = 1;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                off = std::min({off, std::abs(point[axis] - low), std::abs(point[axis] - high)});
                EXPECT_GT(point[axis], low - 1e-12);
                EXPECT_LT(point[axis], high + 1e-12);
            }
            EXPECT_LT(off, 1e-12);
        }
}

TEST(LimitSurface, PassesThroughTheVerticesWhateverTheirValence) {
    for (int n = 3; n <= 40; ++n) {
        const QuadMesh mesh = bentFan(n);
        const auto rules = vertexRules(mesh, segmentPerQuad(mesh), creasesAndBoundary(mesh, noCreases(mesh)));
        const ControlMesh control = interpolatingControlMesh(mesh, rules);
        EXPECT_EQ(std::ranges::count(control.interpolates, false), 0) << n;
        for (const VertexId vertex : mesh.vertices()) {
            const VertexStencil stencil = limitStencil(mesh, vertex, rules[at(vertex)]);
            Point limit = stencil.own * control.points[at(vertex)];
            for (const auto& [spoke, diagonal, weight] : stencil.around) {
                const HalfedgeId onward = diagonal ? mesh.next_halfedge_handle(spoke) : spoke;
                limit += weight * control.points[at(mesh.to_vertex_handle(onward))];
            }
            EXPECT_LT((limit - mesh.point(vertex)).norm(), 1e-10) << n << ' ' << vertex.idx();
        }
    }
}

TEST(LimitSurface, IsTheSameToTheLastBitOnBothSidesOfABorderAndOnAnyNumberOfThreads) {
    std::mt19937 random(3);
    int meshes = 0;
    for (int round = 0; round < 60; ++round) {
        const auto mesh = test::randomMesh(random);
        if (!mesh) continue;
        ++meshes;
        std::vector<bool> creases = noCreases(*mesh);
        for (auto&& crease : creases)
            crease = random() % 4 == 0;
        const Layout layout = segmentPerQuad(*mesh);
        const auto grids = limitSurface(*mesh, layout, creases, 4, 1);
        const auto again = limitSurface(*mesh, layout, creases, 4, 3);
        std::map<int, std::vector<Point>> onEdge;
        for (std::size_t face = 0; face < grids.size(); ++face) {
            ASSERT_EQ(grids[face].points, again[face].points);
            HalfedgeId h = mesh->halfedge_handle(FaceId(static_cast<int>(face)));
            for (std::size_t side = 0; side < 4; ++side, h = mesh->next_halfedge_handle(h)) {
                std::vector<Point> points;
                for (std::size_t n = 0; n <= 4; ++n) {
                    const std::size_t i = std::array{n, std::size_t{4}, 4 - n, std::size_t{0}}[side];
                    const std::size_t j = std::array{std::size_t{0}, n, std::size_t{4}, 4 - n}[side];
                    points.push_back(grids[face].points[5 * j + i]);
                }
                const EdgeId edge = mesh->edge_handle(h);
                if (h != mesh->halfedge_handle(edge, 0)) std::ranges::reverse(points);
                const auto known = onEdge.try_emplace(edge.idx(), points).first;
                EXPECT_EQ(known->second, points);
                for (const Point& point : points)
                    EXPECT_TRUE(std::isfinite(point.sqrnorm()));
            }
        }
    }
    EXPECT_GT(meshes, 20);
}

TEST(LimitSurface, SegmentsMayBeTurnedInAnyWay) {
    const Grid sheet{6, 4, [](double i, double j) { return Point(i, j + 0.1 * i * i, std::sin(i + 2 * j)); }};
    const QuadMesh mesh = test::makeMesh(sheet);
    const Layout straight = test::makeLayout(sheet, {{0, 0, 6, 4, 0}});
    const ReferenceGrid grid = limitSurface(mesh, straight, noCreases(mesh), 2, 1).front();
    for (int turned = 1; turned < 4; ++turned) {
        const Layout layout = test::makeLayout(sheet, {{0, 0, 6, 4, turned}});
        const ReferenceGrid other = limitSurface(mesh, layout, noCreases(mesh), 2, 1).front();
        for (const double v : test::steps(0, 4, 0.5))
            for (const double u : test::steps(0, 6, 0.5)) {
                const auto place = std::array{std::array{v, 6 - u}, std::array{6 - u, 4 - v},
                                              std::array{4 - v, u}}[at(turned - 1)];
                EXPECT_LT((other.evaluate(place[0], place[1]).position - grid.evaluate(u, v).position).norm(),
                          1e-12)
                    << turned;
            }
    }
}

/// The largest distance of the surface over the sides of a box from their planes.
double largestDistanceFromSides(const QuadMesh& box) {
    constexpr std::array<double, 3> half{30, 20, 10};
    const std::vector<ReferenceGrid> grids = limitSurface(box, segmentPerQuad(box), noCreases(box), 4, 1);
    double largest = 0;
    for (const ReferenceGrid& grid : grids)
        for (const std::size_t axis : {0U, 1U, 2U}) {
            const auto distance = [&](const Point& point) {
                return std::abs(std::abs(point[axis]) - half[axis]);
            };
            bool isSide = true;
            for (const int j : {0, 1})
                for (const int i : {0, 1})
                    isSide = isSide && distance(grid.vertex(i, j)) < 1e-9;
            for (const Point& point : grid.points)
                if (isSide) largest = std::max(largest, distance(point));
        }
    return largest;
}

TEST(LimitSurface, StaysPlaneWhereNarrowQuadsBesidePlanePartsAreRedrawn) {
    for (const int fillet : {4, 6})
        for (const int flat : {1, 2, 4})
            EXPECT_LT(largestDistanceFromSides(test::RoundedBox(fillet, flat).mesh()), 1e-9)
                << fillet << " " << flat;
}

TEST(LimitSurface, StartsFromTheVerticesWhereNoControlMeshInterpolates) {
    // Eight vertices of three edges each make the system singular, and this cube is warped such that it has
    // no solution.
    QuadMesh mesh = makeShape("cube", {1});
    mesh.set_point(VertexId(0), mesh.point(VertexId(0)) * 1.1 + Point(0.01, 0.1, 0));
    const auto rules = vertexRules(mesh, segmentPerQuad(mesh), noCreases(mesh));
    const ControlMesh control = interpolatingControlMesh(mesh, rules);
    EXPECT_EQ(std::ranges::count(control.interpolates, true), 0);
    EXPECT_EQ(control.points[0], mesh.point(VertexId(0)));
    const Layout layout = segmentPerQuad(mesh);
    const auto grids = limitSurface(mesh, layout, noCreases(mesh), 4, 1);
    EXPECT_LT(largestError(grids, [](const Point& p) { return p.norm(); }), 2);
    Point inside(0, 0, 0);
    for (const VertexId vertex : mesh.vertices())
        inside += 1.0 / 8 * mesh.point(vertex);
    // The limit of these control points is half as large as the cube, but is drawn through the vertices, and
    // bulges in between.
    for (std::size_t k = 0; k < grids.size(); ++k) {
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const double u = corner == 1 || corner == 2 ? 1 : 0, v = corner >= 2 ? 1 : 0;
            EXPECT_EQ(grids[k].evaluate(u, v).position, mesh.point(layout.segments[k].corners[corner]));
        }
        Point centre(0, 0, 0);
        for (const VertexId corner : layout.segments[k].corners)
            centre += 0.25 * mesh.point(corner);
        EXPECT_GT((grids[k].evaluate(0.5, 0.5).position - inside).norm(), 0.9 * (centre - inside).norm());
    }
}

TEST(LimitSurface, OneHopelessComponentSpoilsNoOther) {
    QuadMesh mesh = makeShape("cube", {1});
    mesh.set_point(VertexId(0), mesh.point(VertexId(0)) * 1.1 + Point(0.01, 0.1, 0));
    const QuadMesh sphere = makeShape("sphere", {4});
    mesh.add_vertex({9, 9, 9}); // an isolated vertex
    const int first = static_cast<int>(mesh.n_vertices());
    for (const VertexId vertex : sphere.vertices())
        mesh.add_vertex(sphere.point(vertex) + Point(5, 0, 0));
    for (const FaceId face : sphere.faces()) {
        std::vector<VertexId> corners;
        for (const VertexId vertex : sphere.fv_range(face))
            corners.emplace_back(first + vertex.idx());
        mesh.add_face(corners);
    }
    const auto rules = vertexRules(mesh, segmentPerQuad(mesh), noCreases(mesh));
    EXPECT_EQ(rules[8].kind, Kind::corner);
    const ControlMesh control = interpolatingControlMesh(mesh, rules);
    for (std::size_t k = 0; k < control.interpolates.size(); ++k)
        EXPECT_EQ(control.interpolates[k], k >= 8) << k;
}

TEST(LimitSurface, TakesQuadsWithoutArea) {
    const Grid flat{4, 4, [](double i, double) { return Point(std::floor(i / 2), 0, 0); }};
    const QuadMesh mesh = test::makeMesh(flat);
    const Layout layout = test::makeLayout(flat, {{0, 0, 4, 4, 0}});
    const auto grids = limitSurface(mesh, layout, noCreases(mesh), 4, 1);
    for (const Point& point : grids.front().points)
        EXPECT_TRUE(std::isfinite(point.sqrnorm()));
}

// ------------------------------------------------------------------------------- stencils

TEST(VertexStencil, TheLimitIsWhereManySubdivisionsEnd) {
    // Subdivides one ring around vertex 0 by hand, with and without a crease along the first spoke.
    for (const bool dart : {false, true})
        for (const int n : {3, 4, 5, 8, 20}) {
            const QuadMesh mesh = bentFan(n);
            const HalfedgeId spoke = mesh.find_halfedge(VertexId(0), VertexId(1));
            const VertexRule rule = dart ? VertexRule{Kind::dart, {spoke, spoke}} : VertexRule{};
            const auto count = static_cast<std::size_t>(n);
            std::vector<Point> edge;
            std::vector<Point> diagonal;
            for (std::size_t k = 0; k < count; ++k) {
                edge.push_back(mesh.point(VertexId(static_cast<int>(2 * k + 1))));
                diagonal.push_back(mesh.point(VertexId(static_cast<int>(2 * k + 2))));
            }
            Point centre = mesh.point(VertexId(0));

            const auto mean = [&](const VertexStencil& stencil) {
                Point sum = stencil.own * centre;
                for (const auto& [leaving, isDiagonal, weight] : stencil.around) {
                    const auto k = static_cast<std::size_t>(mesh.to_vertex_handle(leaving).idx() / 2);
                    sum += weight * (isDiagonal ? diagonal : edge)[k];
                }
                return sum;
            };
            const Point expected = mean(limitStencil(mesh, VertexId(0), rule));
            const VertexStencil stencil = subdivisionStencil(mesh, VertexId(0), rule);
            for (int step = 0; step < 60; ++step) {
                std::vector<Point> faces;
                for (std::size_t k = 0; k < count; ++k)
                    faces.push_back((centre + edge[k] + edge[(k + 1) % count] + diagonal[k]) / 4);
                std::vector<Point> edges;
                for (std::size_t k = 0; k < count; ++k)
                    edges.push_back(dart && k == 0
                                        ? (centre + edge[k]) / 2
                                        : (centre + edge[k] + faces[k] + faces[(k + count - 1) % count]) / 4);
                centre = mean(stencil);
                edge = edges;
                diagonal = faces;
            }
            EXPECT_LT((centre - expected).norm(), 1e-12) << n << (dart ? " dart" : "");
        }
}

// ------------------------------------------------------------------------------- grid

TEST(ReferenceGrid, IsAPolynomialInEveryQuad) {
    for (const int steps : {2, 4}) {
        const auto surface = [steps](double u, double v) {
            return Point(u - v * v, v + u * u, std::pow(u, steps) * v - std::pow(v, steps));
        };
        ReferenceGrid grid{{3, 2}, steps};
        for (int j = 0; j <= 2 * steps; ++j)
            for (int i = 0; i <= 3 * steps; ++i)
                grid.points.push_back(
                    surface(static_cast<double>(i) / steps, static_cast<double>(j) / steps));
        for (const double v : test::steps(-0.3, 2.4, 0.17))
            for (const double u : test::steps(-0.3, 3.4, 0.19)) {
                const SurfacePoint point = grid.evaluate(u, v);
                EXPECT_LT((point.position - surface(u, v)).norm(), 1e-11);
                const Point du(1, 2 * u, steps * std::pow(u, steps - 1) * v);
                const Point dv(-2 * v, 1, std::pow(u, steps) - steps * std::pow(v, steps - 1));
                EXPECT_LT((point.du - du).norm(), 1e-9) << u << ' ' << v;
                EXPECT_LT((point.dv - dv).norm(), 1e-9) << u << ' ' << v;
            }
    }
}

TEST(ControlMesh, WhatIsNoNumberLeavesItsWholeComponentUnsolved) {
    constexpr int length = 60;
    QuadMesh mesh;
    std::array<std::array<VertexId, 3>, length + 1> columns;
    const auto add = [&](int i) {
        for (int j = 0; j < 3; ++j)
            columns[at(i)][at(j)] = mesh.add_vertex({1.0 * i, 1.0 * j, 0});
    };
    // Every sweep ends at the far end, long before what is no number has come there.
    for (int i = length - 1; i >= 0; --i)
        add(i);
    add(length);
    for (std::size_t i = 0; i < length; ++i)
        for (std::size_t j = 0; j < 2; ++j)
            mesh.add_face({columns[i][j], columns[i + 1][j], columns[i + 1][j + 1], columns[i][j + 1]});
    mesh.point(columns[1][1])[2] = std::numeric_limits<double>::quiet_NaN();
    const auto rules = vertexRules(mesh, segmentPerQuad(mesh), creasesAndBoundary(mesh, noCreases(mesh)));
    const ControlMesh control = interpolatingControlMesh(mesh, rules);
    EXPECT_EQ(std::ranges::count(control.interpolates, true), 0);
    EXPECT_EQ(control.points[at(columns[length][1])], mesh.point(columns[length][1]));
}

} // namespace
} // namespace qm
