#include "support/sample_document.h"

#include "bspline/fit.h"
#include "document/options/options_json.h"
#include "document/sections/base_complex_section.h"
#include "document/sections/cut_section.h"
#include "document/sections/features_section.h"
#include "document/sections/layout_section.h"
#include "document/sections/mesh_section.h"
#include "document/sections/surfaces_section.h"
#include "mesh/files/read_mesh.h"
#include "mesh/files/write_soup.h"
#include "mesh/soup/build_mesh.h"
#include "mesh/topology.h"

#include <fstream>
#include <map>
#include <stdexcept>

namespace qm::test {

namespace {

/// A curve with a seed: the longest straight line from some vertex over regular interior vertices.
Features oneCurve(const QuadMesh& mesh) {
    for (const HalfedgeId start : mesh.halfedges()) {
        FeatureCurve curve;
        curve.halfedges = {start};
        if (!continuesStraight(mesh, mesh.from_vertex_handle(start))) continue;
        if (!continuesStraight(mesh, mesh.to_vertex_handle(start))) continue;
        curve.halfedges.push_back(straightOn(mesh, start));
        curve.seed = mesh.to_vertex_handle(start);
        return {{curve}};
    }
    throw std::logic_error("the sample mesh has no line of two edges");
}

Cut twoHalves(const QuadMesh& mesh, const BaseComplex& complex) {
    Cut cut;
    for (const VertexId vertex : mesh.vertices())
        cut.labels.emplace_back(mesh.point(vertex)[0] < 1.2 ? 0 : 1);
    cut.subMeshes = measureSubMeshes(mesh, complex, cut.labels, 2);
    return cut;
}

void put(Document& document, Kind kind, const std::string& tool, Json options, Json section) {
    putSection(document, {kind, tool, std::move(options), std::move(section)});
}

/// A document without its section on the mesh file.
Document makeDocument(Kind kind, const QuadMesh& mesh) {
    const std::vector<double> angles = dihedralAngles(mesh);
    const BaseComplex baseComplex = buildBaseComplex(mesh);
    Document document = newDocument(kind);
    document.root["mesh"] = nullptr;
    put(document, Kind::basecomplex, "qm-basecomplex", Json::object(), baseComplexToJson(mesh, baseComplex));
    if (kind == Kind::basecomplex) return document;

    const Features features = oneCurve(mesh);
    put(document, Kind::features, "qm-features", optionsToJson(FeatureOptions{}),
        featuresToJson(mesh, features, {}));
    if (kind == Kind::features) return document;

    const BaseComplex complex = buildBaseComplex(mesh, seeds(mesh, features));
    const Cut cut = twoHalves(mesh, complex);
    put(document, Kind::cut, "qm-cut", optionsToJson(cut.options), cutToJson(cut));
    if (kind == Kind::cut) return document;

    const SubMeshes subMeshes = subMeshesOf(cut);
    const SearchedMesh searched{mesh, complex, angles, subMeshes, {}};
    EnumerationOptions options;
    options.best = 2;
    const Enumeration enumeration = enumerateGraphs(searched, options);
    put(document, Kind::enumeration, "qm-enum", optionsToJson(options),
        enumerationToJson(mesh, SeparatrixIndex(mesh, baseComplex), enumeration));
    if (kind == Kind::enumeration) return document;

    const std::vector<double> costs = edgeCosts(angles, enumeration.cost);
    const MergeResult merged = mergeGraphs(searched, enumeration, cut.options.chi, MergeOptions{});
    const Layout layout = buildLayout(mesh, merged.graph.tracks, angles, costs);
    Json section = layoutToJson(mesh, layout, angles, sharpAngle(document.root));
    section["merge"] = mergeFigures(merged);
    put(document, Kind::layout, "qm-merge", optionsToJson(MergeOptions{}), std::move(section));
    if (kind == Kind::layout) return document;

    const Surfaces surfaces = fitSurfaces(mesh, layout, angles, FitOptions{});
    put(document, Kind::surfaces, "qm-bspline", optionsToJson(FitOptions{}), surfacesToJson(surfaces));
    return document;
}

} // namespace

QuadMesh dividedCubes(const Cells& cells, int n) {
    const check::CheckedMesh cubes = polycube(cells, n);
    std::vector<Point> points;
    for (const auto& point : cubes.points)
        points.emplace_back(point[0], point[1], point[2]);
    return buildMesh(points, cubes.quads);
}

const QuadMesh& sampleMesh() {
    static const QuadMesh mesh = dividedCubes(bump(), 3);
    return mesh;
}

std::string TemporaryFolder::write(const std::string& name, const std::string& bytes) const {
    std::ofstream(file(name), std::ios::binary) << bytes;
    return file(name);
}

Document sampleDocument(const TemporaryFolder& folder, Kind kind, const QuadMesh& mesh) {
    const std::string bytes = writeObj(mesh);
    const QuadMesh read = readMesh(bytes, "mesh.obj").mesh;
    static std::map<Kind, Document> usual; // most tests use the same mesh, so its surfaces are fitted once
    const bool isUsual = &mesh == &sampleMesh();
    if (isUsual && !usual.contains(kind)) usual[kind] = makeDocument(kind, read);
    Document document = isUsual ? usual[kind] : makeDocument(kind, read);
    document.root["mesh"] = meshToJson(folder.write("mesh.obj", bytes), bytes, read);
    return document;
}

} // namespace qm::test
