/// \file Measures a document's surfaces independently of the library, and prints one line of JSON.
/// usage: measure-surfaces DOCUMENT [MESH]
///
/// Surfaces are evaluated by the checker's recursion. The reference is the Catmull-Clark limit surface
/// through the vertices by plain uniform subdivision (`measure/subdivision.h`), with creases where the
/// document has them. Nothing is shared with lib/bspline. Lengths are shares of the bounding box's diagonal,
/// angles are in degrees. Places within one edge of a folded or flat quad count as `besideBad`.
#include "check/document/read_document.h"
#include "check/mesh/neighbourhoods.h"
#include "check/mesh/vectors.h"
#include "check/surfaces/distance.h"
#include "check/surfaces/patch_borders.h"
#include "check/surfaces/spline.h"
#include "check/tracks/check_segments.h"
#include "check/tracks/paths.h"
#include "document/document.h"
#include "document/sections/mesh_section.h"
#include "programs/measure/subdivision.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace measure {
namespace {

using namespace qm::check;
using measure::Place;

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

double degreesBetween(const Place& a, const Place& b) {
    return std::atan2(length(cross(a, b)), dot(a, b) + 0.0) * 180 / std::numbers::pi;
}

/// The largest and the root mean square of a set of values.
struct Spread {
    double largest = 0;
    double squares = 0;
    std::size_t count = 0;

    void add(double value) {
        largest = std::max(largest, value);
        squares += value * value;
        ++count;
    }
    [[nodiscard]] double rms() const {
        return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0;
    }
    [[nodiscard]] nlohmann::ordered_json json(double unit = 1) const {
        nlohmann::ordered_json result;
        result["max"] = largest / unit;
        result["rms"] = rms() / unit;
        return result;
    }
};

class Measurement {
public:
    Measurement(const CheckedMesh& mesh, const CheckedDocument& document)
        : mesh_(mesh), around_(mesh), toMesh_(mesh_, around_), layout_(*document.layout),
          part_(*document.surfaces), borders_(patchBorders(around_, layout_)), sharp_(borders_.size(), 0) {
        markCreases();
        findDiagonal();
        findBad();
        limit_ = limitThroughVertices(mesh_, around_, sharp_, layout_);
    }

    nlohmann::ordered_json run() {
        measureBorders();
        for (std::size_t p = 0; p < part_.patches.size(); ++p) {
            measureQuads(p);
            measureCorners(p);
            measureFlatness(p);
            points_ += part_.patches[p].controlPoints.size();
            interpolation_ += index(layout_.segments[p].size[0] + 3) * index(layout_.segments[p].size[1] + 3);
        }
        nlohmann::ordered_json result;
        result["badQuads"] = badQuads_;
        result["controlPoints"] = points_;
        result["pointsPerInterpolation"] = static_cast<double>(points_) / static_cast<double>(interpolation_);
        result["normalAngle"] = angle_.json();
        result["normalAngle"]["besideBad"] = badAngle_;
        result["gap"] = gap_ / diagonal_;
        result["reference"] = fromReference_.json(diagonal_);
        result["vertices"] = fromVertices_.json(diagonal_);
        result["facets"] = fromFacets_.json(diagonal_);
        result["normalsFromReference"] = normals_.json();
        result["normalsFromMesh"] = meshNormals_.json();
        result["folds"]["samples"] = folded_;
        result["folds"]["besideBad"] = badFolded_;
        result["weakCorners"] = weakCorners_;
        result["flatPatches"]["count"] = flatPatches_;
        result["flatPatches"]["tilt"] = flatTilt_;
        result["flatPatches"]["meshTilt"] = flatMeshTilt_;
        result["flatPatches"]["worse"] = flatWorse_;
        return result;
    }

private:
    void markCreases() {
        if (!part_.creases) throw std::runtime_error("the document does not list its creases");
        Report report;
        for (const std::vector<int>& vertices : *part_.creases) {
            const auto steps = readPath(around_, vertices, "/surfaces/creases", report);
            if (!steps) throw std::runtime_error("a crease is no path of edges");
            for (const int step : *steps)
                sharp_[index(around_.edge(step))] = 1;
        }
    }

    void findDiagonal() {
        Place low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
        Place high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
        for (const auto& quad : mesh_.quads)
            for (const int corner : quad)
                for (std::size_t k = 0; k < 3; ++k) {
                    low[k] = std::min(low[k], mesh_.points[index(corner)][k]);
                    high[k] = std::max(high[k], mesh_.points[index(corner)][k]);
                }
        diagonal_ = distance(low, high);
    }

    /// Finds bad quads, whose normal at some corner is reversed or missing, and the vertices within an edge
    /// of one.
    void findBad() {
        std::vector<char> touched(mesh_.points.size());
        for (const auto& quad : mesh_.quads) {
            const auto at = [&](std::size_t k) { return mesh_.points[index(quad[k % 4])]; };
            const Place normal = cross(minus(at(2), at(0)), minus(at(3), at(1)));
            bool bad = false;
            for (std::size_t k = 0; k < 4; ++k) {
                const Place next = minus(at(k + 1), at(k));
                const Place before = minus(at(k + 3), at(k));
                const double size = std::sqrt(dot(normal, normal) * dot(next, next) * dot(before, before));
                bad = bad || !(dot(cross(next, before), normal) > 1e-3 * size);
            }
            if (!bad) continue;
            ++badQuads_;
            for (const int corner : quad)
                touched[index(corner)] = 1;
        }
        bad_ = touched;
        for (const auto& quad : mesh_.quads)
            if (std::any_of(quad.begin(), quad.end(), [&](int v) { return touched[index(v)] != 0; }))
                for (const int corner : quad)
                    bad_[index(corner)] = 1;
    }

    [[nodiscard]] bool isBeside(int face) const {
        const auto& quad = mesh_.quads[index(face)];
        return std::any_of(quad.begin(), quad.end(), [&](int v) { return bad_[index(v)] != 0; });
    }

    void measureBorders() {
        constexpr int samples = 32;
        for (int step = 0; step < around_.steps(); ++step) {
            const auto edge = index(around_.edge(step));
            if (around_.from(step) > around_.to(step) || borders_[edge].size() != 2) continue;
            const bool beside = bad_[index(around_.from(step))] != 0 || bad_[index(around_.to(step))] != 0;
            for (int k = 0; k < samples; ++k) {
                const double along = (k + 0.5) / samples;
                std::array<SurfacePoint, 2> at;
                for (std::size_t side = 0; side < 2; ++side) {
                    const BorderPlace& place = borders_[edge][side];
                    const double there = side == 0 ? along : 1 - along;
                    at[side] =
                        evaluate(part_.patches[place.patch], std::lerp(place.begin[0], place.end[0], there),
                                 std::lerp(place.begin[1], place.end[1], there));
                }
                gap_ = std::max(gap_, distance(at[0].point, at[1].point));
                if (sharp_[edge] != 0) continue;
                const double angle =
                    degreesBetween(cross(at[0].alongU, at[0].alongV), cross(at[1].alongU, at[1].alongV));
                if (beside)
                    badAngle_ = std::max(badAngle_, angle);
                else
                    angle_.add(angle);
            }
        }
    }

    /// The lattice points of a quad in the order of its patch: row by row from the patch's own corner.
    [[nodiscard]] std::vector<Place> turnedLattice(int face, const Place& corner) const {
        std::vector<Place> lattice = limit_[index(face)];
        constexpr std::size_t width = perQuad + 1;
        for (std::size_t turns = 0;
             mesh_.points[index(mesh_.quads[index(face)][turns])] != corner && turns < 3; ++turns) {
            std::vector<Place> next(lattice.size());
            for (std::size_t j = 0; j < width; ++j)
                for (std::size_t i = 0; i < width; ++i)
                    next[j * width + i] = lattice[i * width + (width - 1 - j)];
            lattice = std::move(next);
        }
        return lattice;
    }

    void measureQuads(std::size_t p) {
        const auto& segment = layout_.segments[p];
        Report unused;
        const auto vertices = gridOf(mesh_, segment, "", unused);
        for (std::size_t f = 0; f < segment.faces.size(); ++f) {
            const int column = static_cast<int>(f) % segment.size[0];
            const int row = static_cast<int>(f) / segment.size[0];
            const int first = row * (segment.size[0] + 1) + column;
            const auto corner = [&](int offset) {
                return mesh_.points[index(vertices[index(first + offset)])];
            };
            const std::array<Place, 4> corners{corner(0), corner(1), corner(segment.size[0] + 2),
                                               corner(segment.size[0] + 1)};
            measureQuad(p, segment.faces[f], column, row, corners);
        }
    }

    void measureQuad(std::size_t p, int face, int column, int row, const std::array<Place, 4>& corners) {
        const auto& patch = part_.patches[p];
        const auto lattice = turnedLattice(face, corners[0]);
        constexpr std::size_t width = perQuad + 1;
        std::vector<double> us;
        std::vector<double> vs;
        for (std::size_t k = 0; k < width; ++k) {
            us.push_back(column + static_cast<double>(k) / perQuad);
            vs.push_back(row + static_cast<double>(k) / perQuad);
        }
        const auto points = evaluateLattice(patch, us, vs);
        const bool beside = isBeside(face);
        for (std::size_t j = 0; j < width; ++j)
            for (std::size_t i = 0; i < width; ++i) {
                const SurfacePoint& on = points[j * width + i];
                const Place& of = lattice[j * width + i];
                fromReference_.add(fromSurfaces(p, {us[i], vs[j]}, of, face, fromReference_.largest));
                const double fromFacet = distance(on.point, bilinear(corners, i, j));
                fromFacets_.add(fromFacet <= fromFacets_.largest
                                    ? fromFacet
                                    : toMesh_.from(on.point, face, {0.5, 0.5}, 0, last_));
                if (i + 1 == width || j + 1 == width) continue;
                const Place across = minus(lattice[(j + 1) * width + i + 1], of);
                const Place other = minus(lattice[(j + 1) * width + i], lattice[j * width + i + 1]);
                const SurfacePoint middle = evaluate(patch, us[i] + 0.5 / perQuad, vs[j] + 0.5 / perQuad);
                const double angle =
                    degreesBetween(cross(middle.alongU, middle.alongV), cross(across, other));
                normals_.add(angle);
                if (angle > 90) ++(beside ? badFolded_ : folded_);
            }
        for (std::size_t k = 0; k < 4; ++k) {
            const double u = column + (k == 1 || k == 2 ? 1 : 0);
            const double v = row + (k >= 2 ? 1 : 0);
            fromVertices_.add(fromSurfaces(p, {u, v}, corners[k], face, fromVertices_.largest));
        }
        const SurfacePoint centre = evaluate(patch, column + 0.5, row + 0.5);
        meshNormals_.add(degreesBetween(cross(centre.alongU, centre.alongV),
                                        cross(minus(corners[2], corners[0]), minus(corners[3], corners[1]))));
    }

    /// The bilinear interpolation of four corners at lattice point (i, j).
    [[nodiscard]] static Place bilinear(const std::array<Place, 4>& corners, std::size_t i, std::size_t j) {
        const double s = static_cast<double>(i) / perQuad;
        const double t = static_cast<double>(j) / perQuad;
        Place point{};
        for (std::size_t k = 0; k < 3; ++k)
            point[k] = (1 - t) * ((1 - s) * corners[0][k] + s * corners[1][k]) +
                       t * ((1 - s) * corners[3][k] + s * corners[2][k]);
        return point;
    }

    /// The distance from a point to its patch, or to a neighbouring patch if the former would be the largest
    /// so far.
    [[nodiscard]] double fromSurfaces(std::size_t p, const std::array<double, 2>& parameters,
                                      const Place& point, int face, double farthest) const {
        double nearest = distanceToPatch(part_.patches[p], parameters, point);
        if (nearest <= farthest) return nearest;
        for (const int vertex : mesh_.quads[index(face)])
            for (int k = 0; k < around_.valence(vertex); ++k) {
                const int step = around_.firstStep(vertex) + k;
                for (const BorderPlace& place : borders_[index(around_.edge(step))])
                    nearest = std::min(nearest, distanceToPatch(part_.patches[place.patch],
                                                                {0.5 * (place.begin[0] + place.end[0]),
                                                                 0.5 * (place.begin[1] + place.end[1])},
                                                                point));
            }
        return nearest;
    }

    /// Measures corners of patches below 15 or above 165 degrees where the mesh's own corner is in between.
    void measureCorners(std::size_t p) {
        const auto& segment = layout_.segments[p];
        const double a = segment.size[0];
        const double b = segment.size[1];
        const std::array<std::array<double, 2>, 4> corners{{{0, 0}, {a, 0}, {a, b}, {0, b}}};
        const auto weak = [](double angle) { return angle < 15 || angle > 165; };
        for (std::size_t k = 0; k < 4; ++k) {
            const auto& next = segment.sides[k];
            const auto& before = segment.sides[(k + 3) % 4];
            const Place& at = mesh_.points[index(next[0])];
            if (bad_[index(next[0])] != 0 ||
                weak(degreesBetween(minus(mesh_.points[index(next[1])], at),
                                    minus(mesh_.points[index(before[before.size() - 2])], at))))
                continue;
            const SurfacePoint on = evaluate(part_.patches[p], corners[k][0], corners[k][1]);
            const double angle = degreesBetween(on.alongU, on.alongV);
            if (weak(k % 2 == 0 ? angle : 180 - angle)) ++weakCorners_;
        }
    }

    /// Measures how far normals tilt in patches whose vertices lie within 0.015 % of the diagonal from a
    /// plane.
    void measureFlatness(std::size_t p) {
        const auto& segment = layout_.segments[p];
        Place normal{};
        Place centre{};
        Spread tiltOfMesh;
        Report unused;
        const auto vertices = gridOf(mesh_, segment, "", unused);
        std::vector<Place> normals;
        for (const int face : segment.faces) {
            const auto& quad = mesh_.quads[index(face)];
            const auto at = [&](std::size_t k) { return mesh_.points[index(quad[k])]; };
            normals.push_back(cross(minus(at(2), at(0)), minus(at(3), at(1))));
            for (std::size_t k = 0; k < 3; ++k)
                normal[k] += normals.back()[k];
        }
        for (const int vertex : vertices)
            for (std::size_t k = 0; k < 3; ++k)
                centre[k] += mesh_.points[index(vertex)][k] / static_cast<double>(vertices.size());
        const double length = std::sqrt(dot(normal, normal));
        for (const int vertex : vertices)
            if (!(std::abs(dot(minus(mesh_.points[index(vertex)], centre), normal)) <=
                  1.5e-4 * diagonal_ * length))
                return;
        ++flatPatches_;
        for (const Place& ofFace : normals)
            tiltOfMesh.add(degreesBetween(ofFace, normal));
        Spread tilt;
        for (int row = 0; row < segment.size[1]; ++row)
            for (int column = 0; column < segment.size[0]; ++column) {
                const SurfacePoint on = evaluate(part_.patches[p], column + 0.5, row + 0.5);
                tilt.add(degreesBetween(cross(on.alongU, on.alongV), normal));
            }
        flatTilt_ = std::max(flatTilt_, tilt.rms());
        flatMeshTilt_ = std::max(flatMeshTilt_, tiltOfMesh.rms());
        if (tilt.rms() > tiltOfMesh.rms() + 0.01) ++flatWorse_;
    }

    const CheckedMesh& mesh_;
    Neighbourhoods around_;
    DistanceToMesh toMesh_;
    LastFace last_;
    const LayoutPart& layout_;
    const SurfacesPart& part_;
    std::vector<std::vector<BorderPlace>> borders_;
    std::vector<char> sharp_; ///< of every edge
    std::vector<char> bad_;   ///< of every vertex: of a bad quad, or within one edge of one
    LimitLattices limit_;
    double diagonal_ = 1;
    double gap_ = 0;
    double badAngle_ = 0;
    double flatTilt_ = 0;
    double flatMeshTilt_ = 0;
    Spread angle_;
    Spread fromReference_;
    Spread fromVertices_;
    Spread fromFacets_;
    Spread normals_;
    Spread meshNormals_;
    std::size_t badQuads_ = 0;
    std::size_t points_ = 0;
    std::size_t interpolation_ = 0;
    std::size_t folded_ = 0;
    std::size_t badFolded_ = 0;
    std::size_t weakCorners_ = 0;
    std::size_t flatPatches_ = 0;
    std::size_t flatWorse_ = 0;
};

} // namespace
} // namespace measure

int main(int argc, char** argv) {
    if (argc != 2 && argc != 3) {
        std::cerr << "usage: measure-surfaces DOCUMENT [MESH]\n";
        return 2;
    }
    try {
        std::ifstream file(argv[1]);
        const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        const qm::Document parsed = qm::parseDocument(text, argv[1]);
        const auto document = qm::check::readDocument(parsed.root);
        if (!document.layout || !document.surfaces) throw std::runtime_error("the document has no surfaces");
        const auto mesh = qm::check::checkedMesh(
            qm::readMeshOf(qm::JsonPlace(parsed.root)["mesh"], parsed.path, argc > 2 ? argv[2] : "").mesh);
        std::cout << measure::Measurement(mesh, document).run() << '\n';
    } catch (const std::exception& error) {
        std::cerr << "measure-surfaces: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
