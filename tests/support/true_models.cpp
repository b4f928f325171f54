#include "support/true_models.h"

#include "base/at.h"
#include "check/mesh/angles.h"
#include "support/polycube.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace qm::test {

using namespace check;

namespace {

/// Labels of the left and the right half of a mesh.
std::vector<int> halves(const CheckedMesh& mesh, double x) {
    std::vector<int> labels;
    for (const auto& point : mesh.points)
        labels.push_back(point[0] > x);
    return labels;
}

/// A model whose surfaces claim to have no errors, and promise nothing else.
Model stating(Model model) {
    SurfacesPart& surfaces = *model.document.surfaces;
    const SurfacesPart::Figures nothing{{{"maxFromFacets", 0},
                                         {"maxFromVertices", 0},
                                         {"largestGap", 0},
                                         {"largestNormalAngle", 0},
                                         {"folds", 0}}};
    surfaces.figures = nothing;
    surfaces.creases.emplace();
    surfaces.interpolates = surfaces.watertight = false;
    for (SurfacesPart::Patch& patch : surfaces.patches)
        patch.figures = nothing;
    return model;
}

} // namespace

std::string listed(const Report& report) {
    std::string text;
    for (const auto& each : report.violations())
        text += "  " + each.pointer + ": " + each.rule + ": " + each.explanation + "\n";
    return text;
}

::testing::AssertionResult found(const Report& report, const std::string& pointer, const std::string& rule) {
    const auto& all = report.violations();
    if (std::any_of(all.begin(), all.end(),
                    [&](const auto& v) { return v.pointer == pointer && v.rule == rule; }))
        return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "no " << rule << " at " << pointer << " among\n"
                                         << listed(report);
}

CheckedMesh twoHoles() {
    return plane({"xxxxxx", "x..xxx", "xxxx.x", "xxxxxx"});
}

CheckedMesh corner() {
    return polycube({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

Model make(CheckedMesh mesh, const DocumentRecipe& recipe) {
    CheckedDocument document = trueDocument(mesh, recipe);
    document.surfaces->interpolates = true;
    document.surfaces->watertight = true;
    return {std::move(mesh), std::move(document)};
}

Model cut() {
    const CheckedMesh mesh = twoHoles();
    return make(mesh, {{}, halves(mesh, 2.5), 2});
}

Model torusModel() {
    Model model{torus(8, 6), {}};
    const Neighbourhoods around(model.mesh);
    const EdgeCosts costs = edgeCosts(dihedralAngles(model.mesh, around), 0.4, 0.2);
    model.document.weights = {0.4, 0.2};
    LayoutPart layout;
    TrackPart ring;
    TrackPart across;
    for (int i = 0; i <= 8; ++i)
        ring.vertices.push_back(i % 8);
    for (int j = 0; j <= 6; ++j)
        across.vertices.push_back(j % 6 * 8);
    across.transversal = true;
    layout.tracks = {ring, across};
    std::vector<char> border(static_cast<std::size_t>(around.edges()), 0);
    for (std::size_t t = 0; t < 2; ++t) {
        TrackPart& track = layout.tracks[t];
        CostSum cost(costs);
        for (std::size_t i = 1; i < track.vertices.size(); ++i) {
            const int edge = around.edge(around.stepBetween(track.vertices[i - 1], track.vertices[i]));
            border[at(edge)] = 1;
            cost.add(edge);
        }
        track.id = static_cast<int>(t);
        track.cost = cost.value();
    }
    layout.cost = layout.tracks[0].cost;
    layout.divided = true;
    layout.segments = segmentsBetween(model.mesh, around, border);
    model.document.surfaces = bilinearPatches(model.mesh, layout);
    model.document.surfaces->interpolates = true;
    model.document.surfaces->watertight = true;
    model.document.layout = std::move(layout);
    return model;
}

Model cornerModel() {
    return make(corner());
}

Model twoHolesModel() {
    return make(twoHoles());
}

Model statingModel() {
    return stating(twoHolesModel());
}

Model statingTorus() {
    return stating(torusModel());
}

Model seededModel() {
    CheckedMesh mesh = plane({"xxxxx", "xx.xx", "xxxxx", "xxxxx"});
    const auto at = [&](double x, double y) {
        const auto here = std::find(mesh.points.begin(), mesh.points.end(), std::array{x, y, 0.0});
        return static_cast<int>(here - mesh.points.begin());
    };
    return make(mesh, {{{at(1, 3), at(2, 3), at(3, 3)}}, {}, 1});
}

LayoutPart& layout(CheckedDocument& d) {
    return *d.layout;
}

TrackPart& crashing(CheckedDocument& d) {
    for (TrackPart& track : layout(d).tracks) {
        const int end = track.vertices.back();
        for (const TrackPart& other : layout(d).tracks)
            if (std::find(other.vertices.begin() + 1, other.vertices.end() - 1, end) !=
                other.vertices.end() - 1)
                return track;
    }
    throw std::logic_error("no track crashes");
}

} // namespace qm::test
