#include "support/true_document.h"

#include "base/at.h"
#include "check/tracks/check_segments.h"
#include "check/tracks/lines.h"
#include "support/brute_force.h"

#include <algorithm>
#include <stdexcept>

namespace qm::test {

namespace {

using namespace check;

constexpr CostWeights weights{0.4, 0.2};

std::vector<int> verticesOf(const Neighbourhoods& around, const Way& way, int steps) {
    std::vector<int> vertices{around.from(way.steps.front())};
    for (int i = 0; i < steps; ++i)
        vertices.push_back(around.to(way.steps[at(i)]));
    return vertices;
}

BaseComplexPart baseComplexOf(const Neighbourhoods& around) {
    const LineNetwork network = traceLines(around, {}).front();
    BaseComplexPart part;
    for (int v = 0; v < around.vertices(); ++v)
        if (!around.regular(v)) part.extraordinaryVertices.push_back(v);
    part.ordinaryJunctions = static_cast<int>(network.ordinaryJunctions);
    for (const Way& way : network.ways) {
        BaseComplexPart::Separatrix separatrix{
            static_cast<int>(part.separatrices.size()), {}, {}, way.selfCrossing()};
        separatrix.vertices = verticesOf(around, way, static_cast<int>(way.steps.size()));
        if (way.opposite >= 0) separatrix.opposite = way.opposite;
        part.separatrices.push_back(std::move(separatrix));
    }
    return part;
}

/// The tracks that a vector of coordinates stands for.
std::vector<TrackPart> tracksOf(const Neighbourhoods& around, const LineNetwork& network,
                                const EdgeCosts& costs, const std::vector<int>& coordinates) {
    std::vector<TrackPart> tracks;
    for (std::size_t w = 0; w < network.ways.size(); ++w) {
        if (coordinates[w] == 0) continue;
        const Way& way = network.ways[w];
        TrackPart track;
        track.id = static_cast<int>(tracks.size());
        track.vertices = verticesOf(around, way, way.stepsTo(coordinates[w]));
        CostSum cost(costs);
        for (int i = 0; i < way.stepsTo(coordinates[w]); ++i)
            cost.add(around.edge(way.steps[at(i)]));
        track.cost = cost.value();
        tracks.push_back(std::move(track));
    }
    return tracks;
}

EnumerationPart::SubMesh graphsOf(const Neighbourhoods& around, const LineNetwork& network,
                                  const EdgeCosts& costs) {
    EnumerationPart::SubMesh subMesh;
    for (const auto& [edges, graph] : bruteForce(around, network, costs).graphs)
        subMesh.graphs.push_back({graph.cost, tracksOf(around, network, costs, graph.coordinates)});
    std::stable_sort(subMesh.graphs.begin(), subMesh.graphs.end(),
                     [](const auto& a, const auto& b) { return a.cost < b.cost; });
    subMesh.cost = subMesh.graphs.front().cost;
    subMesh.lowerBound = subMesh.cost;
    subMesh.count = std::to_string(subMesh.graphs.size());
    return subMesh;
}

/// The step that follows `step` counter-clockwise around the face on its left.
int nextAround(const CheckedMesh& mesh, const Neighbourhoods& around, int step) {
    const auto& quad = mesh.quads[at(around.leftFace(step))];
    const auto here = std::find(quad.begin(), quad.end(), around.to(step)) - quad.begin();
    return around.stepBetween(quad[at(static_cast<int>(here))], quad[at(static_cast<int>(here + 1) % 4)]);
}

} // namespace

std::vector<LayoutPart::Segment> segmentsBetween(const CheckedMesh& mesh, const Neighbourhoods& around,
                                                 const std::vector<char>& border) {
    const auto isBorder = [&](int step) { return around.boundary(step) || border[at(around.edge(step))]; };
    const auto next = [&](int step) { return nextAround(mesh, around, step); };
    const auto across = [&](int step) { return around.back(step); };
    std::vector<char> done(mesh.quads.size(), 0);
    std::vector<LayoutPart::Segment> segments;
    for (int first = 0; first < around.steps(); ++first) {
        // A corner begins here if this side of the face and the one before it are on the border.
        if (around.leftFace(first) < 0 || done[at(around.leftFace(first))]) continue;
        if (!isBorder(first) || !isBorder(next(next(next(first))))) continue;
        LayoutPart::Segment segment;
        segment.id = static_cast<int>(segments.size());
        for (int row = first;; row = across(next(next(row)))) {
            int columns = 0;
            for (int step = row;; step = next(across(next(step)))) {
                segment.faces.push_back(around.leftFace(step));
                done[at(around.leftFace(step))] = 1;
                ++columns;
                if (isBorder(next(step))) break;
            }
            segment.size = {columns, segment.size[1] + 1};
            if (isBorder(next(next(row)))) break;
        }
        segment.corners[0] = around.from(first);
        Report report;
        const auto grid = gridOf(mesh, segment, "", report);
        if (grid.empty()) throw std::logic_error(report.violations().front().explanation);
        const int a = segment.size[0], b = segment.size[1];
        const auto vertex = [&](int i, int j) { return grid[at(j * (a + 1) + i)]; };
        for (int i = 0; i <= a; ++i)
            segment.sides[0].push_back(vertex(i, 0));
        for (int j = 0; j <= b; ++j)
            segment.sides[1].push_back(vertex(a, j));
        for (int i = a; i >= 0; --i)
            segment.sides[2].push_back(vertex(i, b));
        for (int j = b; j >= 0; --j)
            segment.sides[3].push_back(vertex(0, j));
        for (std::size_t k = 0; k < 4; ++k)
            segment.corners[k] = segment.sides[k].front();
        segments.push_back(std::move(segment));
    }
    return segments;
}

SurfacesPart bilinearPatches(const CheckedMesh& mesh, const LayoutPart& layout) {
    SurfacesPart part;
    for (const auto& segment : layout.segments) {
        SurfacesPart::Patch patch;
        patch.segment = segment.id;
        patch.degree = {1, 1};
        for (std::size_t k = 0; k < 2; ++k) {
            patch.knots[k].push_back(0);
            for (int i = 0; i <= segment.size[k]; ++i)
                patch.knots[k].push_back(i);
            patch.knots[k].push_back(segment.size[k]);
            patch.count[k] = segment.size[k] + 1;
        }
        for (const int vertex : soundGridOf(mesh, segment))
            patch.controlPoints.push_back(mesh.points[at(vertex)]);
        part.patches.push_back(std::move(patch));
    }
    return part;
}

CheckedDocument trueDocument(const CheckedMesh& mesh, const DocumentRecipe& recipe) {
    const Neighbourhoods around(mesh);
    const EdgeCosts costs = edgeCosts(dihedralAngles(mesh, around), weights.alpha, weights.epsilon);
    CheckedDocument document;
    document.baseComplex = baseComplexOf(around);
    document.weights = weights;

    TraceInput input{{}, recipe.labels, recipe.subMeshes};
    if (!recipe.curves.empty()) document.features.emplace();
    for (const auto& curve : recipe.curves) {
        document.features->curves.push_back(
            {static_cast<int>(document.features->curves.size()), curve, curve[1]});
        input.seedSteps.push_back(around.stepBetween(curve[1], curve[0]));
    }
    const auto networks = traceLines(around, input);
    if (!recipe.labels.empty()) document.cut = CutPart{recipe.labels, {}};

    document.enumeration.emplace();
    long product = 1;
    for (const LineNetwork& network : networks) {
        auto graphs = graphsOf(around, network, costs);
        graphs.id = static_cast<int>(document.enumeration->subMeshes.size());
        if (document.cut)
            document.cut->subMeshes.push_back(
                {graphs.id, quasiComplexity(network), static_cast<int>(network.ordinaryJunctions), {}, {}});
        product *= std::stol(*graphs.count);
        document.enumeration->subMeshes.push_back(std::move(graphs));
    }
    document.enumeration->count = std::to_string(product);

    const auto whole = recipe.labels.empty()
                           ? document.enumeration->subMeshes.front()
                           : graphsOf(around, traceLines(around, {input.seedSteps, {}, 1}).front(), costs);
    LayoutPart layout;
    layout.divided = true;
    layout.cost = whole.graphs.front().cost;
    layout.lowerBound = layout.cost;
    layout.tracks = whole.graphs.front().tracks;
    std::vector<char> border(at(around.edges()), 0);
    for (const auto& track : layout.tracks)
        for (std::size_t i = 1; i < track.vertices.size(); ++i)
            border[at(around.edge(around.stepBetween(track.vertices[i - 1], track.vertices[i])))] = 1;
    layout.segments = segmentsBetween(mesh, around, border);
    document.surfaces = bilinearPatches(mesh, layout);
    document.layout = std::move(layout);
    return document;
}

} // namespace qm::test
