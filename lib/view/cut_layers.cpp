#include "base/at.h"
#include "mesh/topology.h"
#include "view/layers.h"
#include "view/palette.h"

#include <algorithm>
#include <optional>

namespace qm {
namespace {

/// The sub-mesh of every quad whose vertices agree; faces in between belong to none.
std::vector<std::uint32_t> labelsOfQuads(const Shell& shell, const std::vector<SubMeshId>& labels) {
    std::vector<std::uint32_t> result;
    for (auto corner = shell.quads.begin(); corner != shell.quads.end(); corner += 4) {
        const SubMeshId label = labels[*corner];
        const bool same = std::all_of(corner, corner + 4, [&](auto v) { return labels[v] == label; });
        result.push_back(same ? static_cast<std::uint32_t>(label.value()) : noItem);
    }
    return result;
}

void addTerminal(PointLayer& layer, const std::optional<VertexId>& vertex, SubMeshId subMesh, bool isSource) {
    if (!vertex) return;
    addPoint(layer, *vertex);
    addFigure(layer.items, "sub-mesh", subMesh.value());
    addFigure(layer.items, "source", isSource ? 1 : nothing);
    addFigure(layer.items, "sink", isSource ? nothing : 1);
}

} // namespace

void addCut(Scene& scene, const QuadMesh& mesh, const Cut& cut) {
    for (const SubMeshId label : cut.labels)
        scene.subMeshOfVertex.push_back(label.value());
    auto faces = newLayer<FaceLayer>("submeshes", "sub-meshes", "sub-mesh", "/cut/subMeshes/");
    faces.paint = Paint::items;
    faces.groups = labelsOfQuads(scene.mesh, cut.labels);
    faces.items.count = cut.subMeshes.size();
    auto terminals =
        newLayer<PointLayer>("terminals", "terminals of the cuts", "terminal", "/cut/subMeshes/{sub-mesh}");
    for (const SubMeshId id : cut.subMeshes.ids()) {
        const SubMesh& subMesh = cut.subMeshes[id];
        addFigure(faces.items, "quasi-complexity", subMesh.quasiComplexity);
        addFigure(faces.items, "ordinary junctions", subMesh.ordinaryJunctions);
        addTerminal(terminals, subMesh.source, id, true);
        addTerminal(terminals, subMesh.sink, id, false);
    }

    LineLayer lines = newLines("cuts", "edges that are cut", "cut edge", "");
    std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours;
    for (const EdgeId edge : mesh.edges()) {
        const auto ends = endsOf(mesh, edge);
        const auto label = [&](std::size_t end) {
            return static_cast<std::uint32_t>(cut.labels[at(ends[end])].value());
        };
        if (label(0) == label(1)) continue;
        neighbours.emplace_back(label(0), label(1));
        addItem(lines, ends);
        addFigure(lines.items, "between sub-mesh", label(0));
        addFigure(lines.items, "and sub-mesh", label(1));
    }
    faces.colours = colourNumbers(cut.subMeshes.size(), neighbours);
    scene.faces.push_back(std::move(faces));
    scene.lines.push_back(std::move(lines));
    if (terminals.items.count > 0) scene.points.push_back(std::move(terminals));
}

void addGraphs(Scene& scene, const QuadMesh& mesh, const Enumeration& enumeration) {
    LineLayer lines = newLines("graphs", "best graph of every sub-mesh", "track",
                               "/enumeration/subMeshes/{sub-mesh}/graphs/0/tracks/{track}");
    for (const SubMeshId subMesh : enumeration.subMeshes.ids()) {
        if (enumeration.subMeshes[subMesh].graphs.empty()) continue;
        const auto& tracks = enumeration.subMeshes[subMesh].graphs.front().tracks;
        for (std::size_t i = 0; i < tracks.size(); ++i) {
            addPath(lines, verticesAlong(mesh, tracks[i].halfedges));
            addFigure(lines.items, "cost", tracks[i].cost);
            addFigure(lines.items, "sub-mesh", subMesh.value());
            addFigure(lines.items, "track", i);
        }
    }
    scene.lines.push_back(std::move(lines));
}

} // namespace qm
