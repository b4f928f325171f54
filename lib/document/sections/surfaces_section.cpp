#include "document/sections/surfaces_section.h"

#include "base/at.h"
#include "bspline/splines/basis.h"
#include "bspline/splines/evaluate.h"
#include "document/sections/mesh_paths.h"
#include "mesh/topology.h"

#include <array>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <utility>

namespace qm {

namespace {

/// Visits the figures of a deviation with their keys; used for both writing and reading.
template <class DeviationType, class Visitor> void visitFigures(DeviationType& deviation, Visitor&& figure) {
    figure("max", deviation.max);
    figure("rms", deviation.rms);
    figure("percentile95", deviation.percentile95);
    figure("maxRelative", deviation.maxRelative);
    figure("rmsRelative", deviation.rmsRelative);
    figure("percentile95Relative", deviation.percentile95Relative);
    figure("maxFromFacets", deviation.maxFromFacets);
    figure("rmsFromFacets", deviation.rmsFromFacets);
    figure("maxFromVertices", deviation.maxFromVertices);
    figure("rmsFromVertices", deviation.rmsFromVertices);
    figure("largestGap", deviation.largestGap);
    figure("largestGapRelative", deviation.largestGapRelative);
    figure("largestNormalAngle", deviation.largestNormalAngle);
    figure("rmsNormalAngle", deviation.rmsNormalAngle);
    figure("percentile95NormalAngle", deviation.percentile95NormalAngle);
    figure("largestInnerNormalAngle", deviation.largestInnerNormalAngle);
    figure("largestNormalDeviation", deviation.largestNormalDeviation);
    figure("rmsNormalDeviation", deviation.rmsNormalDeviation);
    figure("bendingRatio", deviation.bendingRatio);
    figure("folds", deviation.folds);
}

Json deviationToJson(const Deviation& deviation) {
    Json json = Json::object();
    visitFigures(deviation, [&json](const char* key, auto value) { json[key] = value; });
    return json;
}

/// The same for the figures of a scan.
template <class Figures, class Visitor> void visitScan(Figures& scan, Visitor&& figure) {
    figure("coverage", scan.coverage);
    figure("noise", scan.noise);
    figure("max", scan.max);
    figure("rms", scan.rms);
    figure("percentile95", scan.percentile95);
}

Json placeToJson(const std::vector<Patch>& patches, const LayoutPlace& place) {
    return placeToJson(place, pointAt(patches, place));
}

Json scanToJson(const Surfaces& surfaces, const ScanFile& file) {
    Json json = {{"path", file.path}, {"sha256", file.sha256}};
    json.update(figuresToJson(*surfaces.scan));
    json["farthest"] = placeToJson(surfaces.patches, surfaces.scan->farthest);
    return json;
}

Json pointsToJson(const Patch& patch) {
    Json::array_t rows;
    auto point = patch.controlPoints.begin();
    for (int j = 0; j < patch.count[1]; ++j) {
        Json::array_t row;
        row.reserve(at(patch.count[0]));
        for (int i = 0; i < patch.count[0]; ++i, ++point)
            row.push_back(Json::array({(*point)[0], (*point)[1], (*point)[2]}));
        rows.emplace_back(std::move(row));
    }
    return rows;
}

} // namespace

Json figuresToJson(const ScanFigures& scan) {
    Json json = Json::object();
    visitScan(scan, [&json](const char* key, double value) { json[key] = value; });
    return json;
}

Json placeToJson(const LayoutPlace& place, const Point& point) {
    return {{"patch", place.patch}, {"at", place.at}, {"point", {point[0], point[1], point[2]}}};
}

Json surfacesToJson(const Surfaces& surfaces, const ScanFile& scan) {
    Json::array_t patches;
    for (std::size_t i = 0; i < surfaces.patches.size(); ++i) {
        const Patch& patch = surfaces.patches[i];
        patches.push_back({{"segment", patch.segment.value()},
                           {"degree", patch.degree},
                           {"knots", patch.knots},
                           {"controlPoints", pointsToJson(patch)}});
        if (i < surfaces.ofPatch.size()) patches.back()["deviation"] = deviationToJson(surfaces.ofPatch[i]);
    }
    Json section{{"patches", std::move(patches)}, {"deviation", deviationToJson(surfaces.deviation)}};
    if (surfaces.creases) {
        Json& creases = section["creases"] = Json::array();
        for (const std::vector<VertexId>& path : *surfaces.creases)
            creases.push_back({{"vertices", numbersOf(path)}});
    }
    if (surfaces.farthest.patch < surfaces.patches.size())
        section["farthest"] = placeToJson(surfaces.patches, surfaces.farthest);
    for (const LayoutPlace& place : surfaces.folds)
        section["foldPlaces"].push_back(placeToJson(surfaces.patches, place));
    if (surfaces.scan) section["scan"] = scanToJson(surfaces, scan);
    return section;
}

namespace {

Deviation readDeviation(const JsonPlace& place) {
    Deviation deviation;
    visitFigures(deviation, [&place]<class Value>(const char* key, Value& value) {
        const auto figure = place.find(key);
        if (!figure) return;
        if constexpr (std::is_same_v<Value, double>)
            value = figure->number();
        else
            value = static_cast<Value>(figure->whole());
    });
    return deviation;
}

/// \param count  number of control points in this direction
/// \param size   of the segment, in edges
std::vector<double> readKnots(const JsonPlace& place, int degree, int count, int size) {
    const std::size_t due = at(count) + at(degree) + 1;
    if (place.size() != due)
        place.fail("has " + std::to_string(place.size()) + " knots; control points and degree need " +
                   std::to_string(due));
    std::vector<double> knots;
    knots.reserve(due);
    for (std::size_t i = 0; i < due; ++i) {
        knots.push_back(place[i].number());
        if (i > 0 && knots[i] < knots[i - 1]) place.failAt(i, "is less than the knot before it");
    }
    constexpr double slack = 1e-9;
    if (std::abs(knots[at(degree)]) > slack || std::abs(knots[at(count)] - size) > slack * size)
        place.fail("the surface does not run from 0 to " + std::to_string(size) + ", as its segment does");
    for (double& knot : knots) // so that the domain ends exactly where the segment does
        if (std::abs(knot) <= slack)
            knot = 0;
        else if (std::abs(knot - size) <= slack * size)
            knot = size;
    return knots;
}

void readPoints(const JsonPlace& rows, Patch& patch) {
    patch.count[0] = static_cast<int>(rows.size() == 0 ? 0 : rows[0].size());
    patch.count[1] = static_cast<int>(rows.size());
    for (std::size_t j = 0; j < rows.size(); ++j) {
        const JsonPlace row = rows[j];
        if (row.size() != rows[0].size()) row.fail("is not as long as the first row");
        for (std::size_t i = 0; i < row.size(); ++i) {
            const JsonPlace point = row[i];
            if (point.size() != 3) point.fail("a point has three coordinates");
            patch.controlPoints.emplace_back(point[0].number(), point[1].number(), point[2].number());
        }
    }
}

Patch readPatch(const JsonPlace& place, std::size_t index, const std::array<int, 2>& size) {
    Patch patch;
    patch.segment = SegmentId(index);
    if (std::cmp_not_equal(place["segment"].whole(), index))
        place["segment"].fail("patches stand in the order of the segments; segment " + std::to_string(index) +
                              " belongs here");
    readPoints(place["controlPoints"], patch);
    if (place["degree"].size() != 2 || place["knots"].size() != 2)
        place.fail("degree and knots have two entries each");
    for (std::size_t k = 0; k < 2; ++k) {
        patch.degree[k] = static_cast<int>(place["degree"][k].whole(1, maxDegree));
        if (patch.count[k] <= patch.degree[k])
            place["controlPoints"].fail("has too few control points for the degree");
        patch.knots[k] = readKnots(place["knots"][k], patch.degree[k], patch.count[k], size[k]);
    }
    return patch;
}

std::vector<std::vector<VertexId>> readCreases(const QuadMesh& mesh, const JsonPlace& list) {
    std::vector<std::vector<VertexId>> creases;
    for (const JsonPlace& crease : list.elements())
        creases.push_back(verticesAlong(mesh, pathAt(mesh, crease["vertices"])));
    return creases;
}

LayoutPlace readPlace(const std::vector<std::array<int, 2>>& sizes, const JsonPlace& place) {
    LayoutPlace result{at(place["patch"].whole(0, std::ssize(sizes) - 1)), {}};
    for (std::size_t k = 0; k < 2; ++k) {
        result.at[k] = place["at"][k].number();
        if (result.at[k] < 0 || result.at[k] > sizes[result.patch][k])
            place["at"].failAt(k, "lies outside of the patch");
    }
    return result;
}

} // namespace

Surfaces readSurfaces(const QuadMesh& mesh, const std::vector<std::array<int, 2>>& sizes,
                      const JsonPlace& section) {
    Surfaces surfaces;
    const JsonPlace patches = section["patches"];
    if (patches.size() != sizes.size())
        patches.fail("has " + std::to_string(patches.size()) + " entries, the layout has " +
                     std::to_string(sizes.size()) + " segments");
    for (std::size_t i = 0; i < patches.size(); ++i) {
        surfaces.patches.push_back(readPatch(patches[i], i, sizes[i]));
        if (const auto deviation = patches[i].find("deviation"))
            surfaces.ofPatch.push_back(readDeviation(*deviation));
    }
    if (surfaces.ofPatch.size() != surfaces.patches.size()) surfaces.ofPatch.clear();
    if (const auto creases = section.find("creases")) surfaces.creases = readCreases(mesh, *creases);
    surfaces.deviation = readDeviation(section["deviation"]);
    if (const auto farthest = section.find("farthest")) surfaces.farthest = readPlace(sizes, *farthest);
    if (const auto places = section.find("foldPlaces"))
        for (const JsonPlace& place : places->elements())
            surfaces.folds.push_back(readPlace(sizes, place));
    if (const auto scan = section.find("scan")) {
        surfaces.scan.emplace();
        visitScan(*surfaces.scan, [&](const char* key, double& value) {
            if (const auto figure = scan->find(key)) value = figure->number();
        });
        if (const auto farthest = scan->find("farthest"))
            surfaces.scan->farthest = readPlace(sizes, *farthest);
    }
    return surfaces;
}

} // namespace qm
