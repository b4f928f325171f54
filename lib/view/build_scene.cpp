#include "view/build_scene.h"

#include "mesh/bounding_box.h"
#include "view/layers.h"

namespace qm {
namespace {

/// Middle and radius of a ball about the box of all vertices that a face uses.
std::pair<Point, double> ballAround(const QuadMesh& mesh) {
    const BoundingBox box = boundingBox(mesh);
    const double radius = box.diagonal() / 2;
    return {box.centre(), radius > 0 ? radius : 1};
}

void addFigures(Scene& scene, const Viewed& viewed) {
    const auto add = [&scene](const std::string& name, auto value) {
        scene.figures.emplace_back(name, static_cast<double>(value));
    };
    add("vertices", viewed.mesh.n_vertices());
    add("quads", viewed.mesh.n_faces());
    add("extraordinary vertices", viewed.baseComplex.extraordinaryVertices.size());
    add("ordinary junctions", viewed.baseComplex.ordinaryJunctions);
    if (!viewed.features.curves.empty()) add("feature curves", viewed.features.curves.size());
    if (viewed.cut != nullptr) add("sub-meshes", viewed.cut->subMeshes.size());
    if (viewed.layout != nullptr) {
        add("segments", viewed.layout->segments.size());
        add("G_T", viewed.layout->cost);
        if (viewed.layout->lowerBound) add("lower bound of G_T", *viewed.layout->lowerBound);
    }
    if (viewed.surfaces != nullptr) {
        const Deviation& deviation = viewed.surfaces->deviation;
        add("control points", controlPointCount(viewed.surfaces->patches));
        add("largest deviation, " + viewed.unit, deviation.max);
        if (viewed.tolerance) add("tolerance, " + viewed.unit, *viewed.tolerance);
        add("deviation, root mean square, " + viewed.unit, deviation.rms);
        if (const auto& scan = viewed.surfaces->scan) {
            add("farthest from the scan's triangles, " + viewed.unit, scan->max);
            add("noise of the scan, " + viewed.unit, scan->noise);
        }
        add("largest gap, " + viewed.unit, deviation.largestGap);
        add("largest normal angle across smooth borders, \u00b0", deviation.largestNormalAngle);
    }
}

/// What the last stage added, over what explains it.
std::vector<std::string> shownAtFirst(const Viewed& viewed) {
    constexpr std::size_t fewQuads = 20000;
    if (viewed.surfaces != nullptr) return {"deviation", "curves"};
    std::vector<std::string> names = {"extraordinary"};
    if (viewed.mesh.n_faces() <= fewQuads) names.emplace_back("edges");
    const auto show = [&names](auto... more) { (names.emplace_back(more), ...); };
    if (viewed.layout != nullptr)
        show("segments", "borders");
    else if (viewed.enumeration != nullptr)
        viewed.cut != nullptr ? show("submeshes", "graphs") : show("mesh", "graphs");
    else if (viewed.cut != nullptr)
        show("submeshes", "separatrices", "cuts");
    else
        show("mesh", "separatrices");
    if (!viewed.features.curves.empty() && viewed.layout == nullptr) show("features", "seeds");
    return names;
}

} // namespace

Scene buildScene(const Viewed& viewed, unsigned jobs) {
    const auto [centre, radius] = ballAround(viewed.mesh);
    Scene scene;
    scene.title = viewed.title;
    scene.kind = viewed.kind;
    scene.radius = radius;
    addFigures(scene, viewed);
    addMesh(scene, viewed, centre);
    addBaseComplex(scene, viewed);
    addFeatures(scene, viewed);
    if (viewed.cut != nullptr) addCut(scene, viewed.mesh, *viewed.cut);
    if (viewed.enumeration != nullptr) addGraphs(scene, viewed.mesh, *viewed.enumeration);
    if (viewed.layout != nullptr) addLayout(scene, viewed.mesh, *viewed.layout);
    if (viewed.surfaces != nullptr) addSurfaces(scene, viewed, centre, jobs);
    scene.shown = shownAtFirst(viewed);
    return scene;
}

} // namespace qm
