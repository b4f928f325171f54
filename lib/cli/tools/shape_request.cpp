#include "cli/tools/shape_request.h"

#include "base/error.h"
#include "mesh/bounding_box.h"
#include "mesh/files/write_soup.h"
#include "shape/scan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qm {
namespace {

std::string padded(const std::string& text, std::size_t width) {
    return text + std::string(width - std::min(width, text.size()), ' ');
}

/// Whether STL can hold a point.
bool isSinglePrecision(const Point& point) {
    return std::ranges::all_of(
        point, [](double coordinate) { return std::abs(coordinate) <= std::numeric_limits<float>::max(); });
}

MeshFormat formatOf(const ShapeRequest& request, std::string_view outputPath) {
    if (request.format == NamedMeshFormat::ending) return formatOfName(outputPath).value_or(MeshFormat::obj);
    return formatOfName("." + std::string(choiceName(request.format))).value();
}

} // namespace

void declareNeeds(Tool& tool, const ShapeRequest& request) {
    tool.needs({"resolution", "around", "seed", "voxels", "scan", "noise", "format"}, "a mesh's name",
               [&request] { return !request.list; });
    const auto isRandom = [&request] {
        return std::ranges::any_of(shapeKinds(), [&request](const ShapeKind& kind) {
            return kind.random && kind.name == request.name;
        });
    };
    tool.needs({"voxels"}, "a random mesh", isRandom);
    tool.needs({"seed"}, "a random mesh or --noise",
               [&request, isRandom] { return isRandom() || request.noise.value > 0; });
    tool.needs({"noise"}, "--scan", [&request] { return request.scan > 0; });
}

void verify(const Tool& tool, const ShapeRequest& request) {
    if (request.name.empty() != request.list) throw UsageError("name one mesh, or give --list");
    if (request.shape.around > 0 && tool.given("resolution"))
        throw UsageError("--around and --resolution exclude one another");
    if (request.scan > 0 && (tool.given("resolution") || tool.given("around")))
        throw UsageError("--scan says how fine the scan is, without --resolution and --around");
    if (request.scan == 0 && formatOf(request, tool.outputPath()) == MeshFormat::stl)
        throw UsageError("STL holds triangles only: give --scan, or another format");
}

std::vector<std::string> namesOfShapes() {
    std::vector<std::string> names;
    for (const ShapeKind& kind : shapeKinds())
        names.emplace_back(kind.name);
    return names;
}

std::string listOfShapes() {
    std::string list = "NAME         RESOLUTION  QUADS\n";
    for (const ShapeKind& kind : shapeKinds())
        list += padded(kind.name, 13) + padded(std::to_string(kind.resolution), 12) +
                padded(std::to_string(makeShape(kind.name).n_faces()), 7) + kind.summary + '\n';
    return list;
}

Soup makeRequested(const ShapeRequest& request) {
    if (request.scan == 0) return soupOf(makeShape(request.name, request.shape));
    Triangles scan = makeScan(request.name, request.scan, request.shape);
    if (request.noise.value > 0)
        addNoise(scan, request.noise.length(boundingBoxOf(scan.points).diagonal()), request.shape.seed);
    if (!std::ranges::all_of(scan.points, isSinglePrecision))
        throw Error("--noise", "is more than coordinates of single precision can hold", "Ask for less");
    return soupOf(scan);
}

std::string writeRequested(const Soup& soup, const ShapeRequest& request, std::string_view outputPath) {
    return writeSoup(soup, formatOf(request, outputPath));
}

} // namespace qm
