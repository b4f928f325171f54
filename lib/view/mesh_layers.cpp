#include "base/at.h"
#include "mesh/topology.h"
#include "view/layers.h"

#include <numbers>

namespace qm {
namespace {

void addEdges(Scene& scene, const QuadMesh& mesh, const std::vector<double>& dihedralAngles) {
    LineLayer edges = newLines("edges", "mesh edges", "edge", "");
    for (const EdgeId edge : mesh.edges()) {
        addItem(edges, endsOf(mesh, edge));
        addFigure(edges.items, "dihedral angle, degrees", dihedralAngles[at(edge)] * 180 / std::numbers::pi);
    }
    for (Column& column : edges.items.columns)
        column.rough = true;
    scene.lines.push_back(std::move(edges));
}

} // namespace

void addMesh(Scene& scene, const Viewed& viewed, const Point& centre) {
    const QuadMesh& mesh = viewed.mesh;
    for (const VertexId vertex : mesh.vertices())
        appendPosition(scene.mesh.positions, mesh.point(vertex), centre);
    for (const FaceId face : mesh.faces())
        for (const VertexId vertex : mesh.fv_range(face))
            scene.mesh.quads.push_back(static_cast<std::uint32_t>(vertex.idx()));
    scene.faces.push_back(newLayer<FaceLayer>("mesh", "mesh"));
    // Stripes on the mesh are called like those on the surfaces, unless both are there.
    scene.faces.push_back(viewed.surfaces == nullptr
                              ? newLayer<FaceLayer>("zebra", "zebra stripes")
                              : newLayer<FaceLayer>("mesh-zebra", "zebra stripes on the mesh"));
    scene.faces.back().paint = Paint::stripes;
    addEdges(scene, mesh, viewed.dihedralAngles);
}

void addBaseComplex(Scene& scene, const Viewed& viewed) {
    const QuadMesh& mesh = viewed.mesh;
    LineLayer lines = newLines("separatrices", "separatrices", "separatrix", "/baseComplex/separatrices/");
    for (const Separatrix& separatrix : viewed.baseComplex.separatrices) {
        addPath(lines, verticesAlong(mesh, separatrix.halfedges));
        addFigure(lines.items, "opposite",
                  separatrix.opposite ? static_cast<double>(separatrix.opposite->value()) : nothing);
        addFigure(lines.items, "crosses itself", separatrix.selfCrossing ? 1 : nothing);
    }
    scene.lines.push_back(std::move(lines));

    auto points = newLayer<PointLayer>("extraordinary", "extraordinary vertices", "extraordinary vertex",
                                       "/baseComplex/extraordinaryVertices/");
    for (const VertexId vertex : viewed.baseComplex.extraordinaryVertices) {
        addPoint(points, vertex);
        addFigure(points.items, "vertex", vertex.idx());
        addFigure(points.items, "edges", mesh.valence(vertex));
        addFigure(points.items, "on the boundary", mesh.is_boundary(vertex) ? 1 : nothing);
    }
    scene.points.push_back(std::move(points));
}

void addFeatures(Scene& scene, const Viewed& viewed) {
    if (viewed.features.curves.empty()) return;
    LineLayer lines = newLines("features", "feature curves", "feature curve", "/features/curves/");
    auto seeds = newLayer<PointLayer>("seeds", "feature seeds", "seed of feature curve", "/features/curves/");
    for (const FeatureCurve& curve : viewed.features.curves) {
        addPath(lines, verticesAlong(viewed.mesh, curve.halfedges));
        addPoint(seeds, curve.seed);
        addFigure(seeds.items, "vertex", curve.seed.idx());
    }
    scene.lines.push_back(std::move(lines));
    scene.points.push_back(std::move(seeds));
}

} // namespace qm
