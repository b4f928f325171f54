// True documents pass; for every rule there is a document that breaks it, and the place is named.
#include "base/infinity.h"
#include "check/check_document.h"
#include "check/check_sections.h"
#include "support/true_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace qm::test {
namespace {

using namespace check;

// ---- True documents.

struct Named {
    const char* name;
    Model (*model)();
};

class TrueDocument : public ::testing::TestWithParam<Named> {};

TEST_P(TrueDocument, IsTrue) {
    const Model model = GetParam().model();
    const Report report = checkDocument(model.mesh, model.document);
    EXPECT_TRUE(report.ok()) << listed(report);
    EXPECT_FALSE(report.verified().empty());
}

INSTANTIATE_TEST_SUITE_P(Check, TrueDocument,
                         ::testing::Values(Named{"cut", cut}, Named{"torus", torusModel},
                                           Named{"corner", cornerModel}, Named{"twoHoles", twoHolesModel},
                                           Named{"seeded", seededModel}),
                         [](const auto& each) { return std::string(each.param.name); });

// ---- Falsified documents.

struct Spoilt {
    const char* name;
    Model (*model)();
    std::function<void(CheckedDocument&)> spoil;
    const char* pointer;
    const char* rule;
};

void PrintTo(const Spoilt& spoilt, std::ostream* out) {
    *out << spoilt.name;
}

class SpoiltDocument : public ::testing::TestWithParam<Spoilt> {};

TEST_P(SpoiltDocument, IsSeen) {
    const auto& [name, makeModel, spoil, pointer, rule] = GetParam();
    Model model = makeModel();
    spoil(model.document);
    EXPECT_TRUE(found(checkDocument(model.mesh, model.document), pointer, rule));
}

std::string nameOf(const ::testing::TestParamInfo<Spoilt>& info) {
    return info.param.name;
}

using Doc = CheckedDocument;

BaseComplexPart& complex(Doc& d) {
    return *d.baseComplex;
}
EnumerationPart::SubMesh& first(Doc& d) {
    return d.enumeration->subMeshes[0];
}
SurfacesPart::Patch& patch(Doc& d) {
    return d.surfaces->patches[0];
}

INSTANTIATE_TEST_SUITE_P(
    BaseComplex, SpoiltDocument,
    ::testing::Values(
        Spoilt{"vertexMissing", cornerModel, [](Doc& d) { complex(d).extraordinaryVertices.pop_back(); },
               "/baseComplex/extraordinaryVertices", "extraordinary"},
        Spoilt{"vertexUnknown", cornerModel, [](Doc& d) { complex(d).extraordinaryVertices[2] = 1000; },
               "/baseComplex/extraordinaryVertices/2", "vertex"},
        Spoilt{"vertexRegular", twoHolesModel, [](Doc& d) { complex(d).extraordinaryVertices[0] = 0; },
               "/baseComplex/extraordinaryVertices/0", "extraordinary"},
        Spoilt{"vertexOrder", cornerModel,
               [](Doc& d) {
                   std::swap(complex(d).extraordinaryVertices[0], complex(d).extraordinaryVertices[1]);
               },
               "/baseComplex/extraordinaryVertices/1", "order"},
        Spoilt{"junctions", cornerModel, [](Doc& d) { ++complex(d).ordinaryJunctions; },
               "/baseComplex/ordinaryJunctions", "n_j"},
        Spoilt{"separatrixMissing", cornerModel, [](Doc& d) { complex(d).separatrices.pop_back(); },
               "/baseComplex/separatrices", "separatrix missing"},
        Spoilt{"separatrixTwice", cornerModel,
               [](Doc& d) { complex(d).separatrices[1].vertices = complex(d).separatrices[0].vertices; },
               "/baseComplex/separatrices/1", "separatrix twice"},
        Spoilt{"separatrixShort", twoHolesModel,
               [](Doc& d) {
                   auto& all = complex(d).separatrices;
                   std::find_if(all.begin(), all.end(), [](const auto& s) {
                       return s.vertices.size() > 2;
                   })->vertices.pop_back();
               },
               "/baseComplex/separatrices/3/vertices", "separatrix end"},
        Spoilt{"separatrixId", cornerModel, [](Doc& d) { complex(d).separatrices[3].id = 4; },
               "/baseComplex/separatrices/3/id", "id"},
        Spoilt{"opposite", cornerModel, [](Doc& d) { complex(d).separatrices[0].opposite.reset(); },
               "/baseComplex/separatrices/0/opposite", "opposite"},
        Spoilt{"oppositeUnknown", cornerModel, [](Doc& d) { complex(d).separatrices[0].opposite = 5000; },
               "/baseComplex/separatrices/0/opposite", "opposite"},
        Spoilt{"selfCrossing", cornerModel, [](Doc& d) { complex(d).separatrices[7].selfCrossing = true; },
               "/baseComplex/separatrices/7/selfCrossing", "self-crossing"},
        Spoilt{
            "noPath", cornerModel,
            [](Doc& d) { complex(d).separatrices[2].vertices[1] = complex(d).separatrices[2].vertices[0]; },
            "/baseComplex/separatrices/2/vertices/1", "path"},
        Spoilt{"tooShort", cornerModel, [](Doc& d) { complex(d).separatrices[2].vertices.resize(1); },
               "/baseComplex/separatrices/2/vertices", "path"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Features, SpoiltDocument,
    ::testing::Values(Spoilt{"bend", seededModel,
                             [](Doc& d) {
                                 auto& vertices = d.features->curves[0].vertices;
                                 vertices[0] = d.baseComplex->extraordinaryVertices.back();
                                 vertices = {vertices[1], vertices[2], vertices[1]};
                             },
                             "/features/curves/0/vertices/2", "straight on"},
                      Spoilt{"seedOffCurve", seededModel, [](Doc& d) { d.features->curves[0].seed = 0; },
                             "/features/curves/0/seed", "seed on curve"},
                      Spoilt{"seedOnBoundary", seededModel,
                             [](Doc& d) {
                                 d.features->curves[0].vertices = {0, 1};
                                 d.features->curves[0].seed = 0;
                             },
                             "/features/curves/0/seed", "seed regular"},
                      Spoilt{"seedTwice", seededModel,
                             [](Doc& d) {
                                 d.features->curves.push_back(d.features->curves[0]);
                                 d.features->curves[1].id = 1;
                             },
                             "/features/curves/1/seed", "seed unique"},
                      Spoilt{"curveId", seededModel,
                             [](Doc& d) { d.features->curves.push_back(d.features->curves[0]); },
                             "/features/curves/1/id", "id"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Cut, SpoiltDocument,
    ::testing::Values(
        Spoilt{"labelMissing", cut, [](Doc& d) { d.cut->labels.pop_back(); }, "/cut/labels",
               "labels complete"},
        Spoilt{"labelUnknown", cut, [](Doc& d) { d.cut->labels[3] = 2; }, "/cut/labels/3", "label"},
        Spoilt{"empty", cut,
               [](Doc& d) {
                   d.cut->subMeshes.push_back({2, 0, 0, {}, {}});
               },
               "/cut/subMeshes/2", "sub-mesh empty"},
        Spoilt{"complexity", cut, [](Doc& d) { *d.cut->subMeshes[1].quasiComplexity += 1e-3; },
               "/cut/subMeshes/1/quasiComplexity", "U"},
        Spoilt{"junctions", cut, [](Doc& d) { ++*d.cut->subMeshes[0].ordinaryJunctions; },
               "/cut/subMeshes/0/ordinaryJunctions", "n_j"},
        Spoilt{"terminal", cut, [](Doc& d) { d.cut->subMeshes[0].sink = 9999; }, "/cut/subMeshes/0/sink",
               "vertex"},
        Spoilt{"id", cut, [](Doc& d) { d.cut->subMeshes[0].id = 1; }, "/cut/subMeshes/0/id", "id"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Enumeration, SpoiltDocument,
    ::testing::Values(
        Spoilt{"subMeshes", cornerModel, [](Doc& d) { d.enumeration->subMeshes.push_back(first(d)); },
               "/enumeration/subMeshes", "sub-meshes"},
        Spoilt{"cost", cornerModel, [](Doc& d) { *first(d).graphs[1].cost += 2e-6 * 50; },
               "/enumeration/subMeshes/0/graphs/1/cost", "cost"},
        Spoilt{"sorted", cornerModel, [](Doc& d) { std::swap(first(d).graphs[0], first(d).graphs[3]); },
               "/enumeration/subMeshes/0/graphs/3", "sorted"},
        Spoilt{"distinct", cornerModel, [](Doc& d) { first(d).graphs[1] = first(d).graphs[0]; },
               "/enumeration/subMeshes/0/graphs/1", "distinct"},
        Spoilt{"best", cornerModel, [](Doc& d) { *first(d).cost -= 1; }, "/enumeration/subMeshes/0/cost",
               "best cost"},
        Spoilt{"bound", cornerModel, [](Doc& d) { *first(d).lowerBound += 1; },
               "/enumeration/subMeshes/0/lowerBound", "bound"},
        Spoilt{"count", cornerModel, [](Doc& d) { first(d).count = "3"; }, "/enumeration/subMeshes/0/count",
               "count"},
        Spoilt{"countText", cornerModel, [](Doc& d) { first(d).count = "4x"; },
               "/enumeration/subMeshes/0/count", "count"},
        Spoilt{"countTooLong", cornerModel, [](Doc& d) { first(d).count = std::string(500, '9'); },
               "/enumeration/subMeshes/0/count", "count"},
        Spoilt{"product", cut, [](Doc& d) { d.enumeration->count = "1000"; }, "/enumeration/count", "count"},
        Spoilt{"trackEnd", cut, [](Doc& d) { first(d).graphs[0].tracks[0].vertices.push_back(0); },
               "/enumeration/subMeshes/0/graphs/0/tracks/0/vertices/2", "track straight"},
        Spoilt{"trackStart", cut,
               [](Doc& d) {
                   auto& vertices = first(d).graphs[0].tracks[0].vertices;
                   vertices = {d.enumeration->subMeshes[1].graphs[0].tracks[0].vertices};
               },
               "/enumeration/subMeshes/0/graphs/0/tracks/0/vertices/0", "track start"},
        Spoilt{"trackTwice", cornerModel,
               [](Doc& d) { first(d).graphs[0].tracks.push_back(first(d).graphs[0].tracks[0]); },
               "/enumeration/subMeshes/0/graphs/0/tracks/22", "track twice"},
        Spoilt{"separatrix", cornerModel, [](Doc& d) { first(d).graphs[0].tracks[0].separatrix = 39; },
               "/enumeration/subMeshes/0/graphs/0/tracks/0/separatrix", "track separatrix"},
        Spoilt{"source", cornerModel, [](Doc& d) { first(d).graphs[0].tracks[1].source = 999; },
               "/enumeration/subMeshes/0/graphs/0/tracks/1/source", "track source"},
        Spoilt{"forbidden", cornerModel,
               [](Doc& d) {
                   d.constraints = {{}, {layout(d).tracks[0].vertices}};
               },
               "/enumeration/subMeshes/0/graphs/0/tracks", "forbidden"},
        Spoilt{"constraintPath", cornerModel,
               [](Doc& d) {
                   d.constraints = {{{0, 0}}, {}, {}};
               },
               "/constraints/required/0/vertices/1", "path"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Layout, SpoiltDocument,
    ::testing::Values(
        Spoilt{"trackCost", cornerModel, [](Doc& d) { *layout(d).tracks[4].cost += 1; },
               "/layout/tracks/4/cost", "cost"},
        Spoilt{"cost", cornerModel, [](Doc& d) { *layout(d).cost += 1; }, "/layout/cost", "G_T"},
        Spoilt{"bound", cornerModel, [](Doc& d) { *layout(d).lowerBound += 1; }, "/layout/lowerBound",
               "bound"},
        Spoilt{"id", cornerModel, [](Doc& d) { layout(d).tracks[4].id = 3; }, "/layout/tracks/4/id", "id"},
        Spoilt{"idle", cornerModel, [](Doc& d) { layout(d).tracks.pop_back(); }, "/layout/tracks", "A3"},
        Spoilt{"firstArc", cornerModel, [](Doc& d) { layout(d).tracks.pop_back(); }, "/layout/tracks",
               "arc rule 1"},
        Spoilt{"unmarkedBorder", cornerModel,
               [](Doc& d) { layout(d).tracks.erase(layout(d).tracks.begin()); }, "/layout/segments/0",
               "border"},
        Spoilt{"required", cornerModel,
               [](Doc& d) {
                   // The other graphs have edges that are not in the layout.
                   std::vector<std::vector<int>> paths;
                   for (const auto& track : first(d).graphs[3].tracks)
                       paths.push_back(track.vertices);
                   d.constraints = {paths, {}, {}};
               },
               "/layout/tracks", "required"},
        Spoilt{"overlap", cornerModel,
               [](Doc& d) {
                   TrackPart back = layout(d).tracks[0];
                   std::reverse(back.vertices.begin(), back.vertices.end());
                   back.id = 22;
                   layout(d).tracks.push_back(back);
               },
               "/layout/tracks/22", "edge twice"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    LayoutSegments, SpoiltDocument,
    ::testing::Values(
        Spoilt{"tiling", cornerModel,
               [](Doc& d) { layout(d).segments[2].faces = layout(d).segments[1].faces; },
               "/layout/segments/2/faces/0", "tiling"},
        Spoilt{"faceMissing", cornerModel, [](Doc& d) { layout(d).segments.pop_back(); }, "/layout/segments",
               "tiling"},
        Spoilt{"faceUnknown", cornerModel, [](Doc& d) { layout(d).segments[2].faces[0] = 7777; },
               "/layout/segments/2/faces/0", "face"},
        Spoilt{"grid", twoHolesModel,
               [](Doc& d) {
                   auto& all = layout(d).segments;
                   auto wide =
                       std::find_if(all.begin(), all.end(), [](const auto& s) { return s.faces.size() > 1; });
                   std::swap(*wide, all[0]);
                   std::swap(all[0].id, wide->id);
                   std::swap(all[0].faces[0], all[0].faces[1]);
               },
               "/layout/segments/0/faces/0", "grid"},
        Spoilt{"size", cornerModel,
               [](Doc& d) {
                   layout(d).segments[2].size = {3, 3};
               },
               "/layout/segments/2/faces", "grid"},
        Spoilt{"corner", cornerModel,
               [](Doc& d) { layout(d).segments[2].corners[3] = layout(d).segments[2].corners[1]; },
               "/layout/segments/2/corners/3", "corner"},
        Spoilt{"sideVertex", cornerModel, [](Doc& d) { layout(d).segments[2].sides[1][0] = 0; },
               "/layout/segments/2/sides/1/0", "side"},
        Spoilt{"sideLength", cornerModel, [](Doc& d) { layout(d).segments[2].sides[1].pop_back(); },
               "/layout/segments/2/sides/1", "side"},
        Spoilt{"segmentId", cornerModel, [](Doc& d) { layout(d).segments[2].id = 1; },
               "/layout/segments/2/id", "id"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    LayoutQuality, SpoiltDocument,
    ::testing::Values(Spoilt{"quality", cornerModel, [](Doc& d) { layout(d).quality.segments = 13; },
                             "/layout/quality/segments", "quality"},
                      Spoilt{"joints", cornerModel, [](Doc& d) { layout(d).quality.tJoints = 99; },
                             "/layout/quality/tJoints", "quality"},
                      Spoilt{"aspect", twoHolesModel, [](Doc& d) { layout(d).quality.maxAspect = 77; },
                             "/layout/quality/maxAspect", "quality"},
                      Spoilt{"gap", cornerModel,
                             [](Doc& d) {
                                 layout(d).lowerBound = layout(d).cost;
                                 layout(d).quality.gap = 3;
                             },
                             "/layout/quality/gap", "quality"},
                      Spoilt{"sharpness", cornerModel,
                             [](Doc& d) {
                                 layout(d).quality.rho = 0.45;
                                 layout(d).quality.capturedSharpness = 0.5;
                             },
                             "/layout/quality/capturedSharpness", "quality"},
                      Spoilt{"frontCovered", cornerModel,
                             [](Doc& d) {
                                 layout(d).front = {{1, 9, -5, 0.5, -1.0, false},
                                                    {2, 7, -4, 0.4, -2.0, false},
                                                    {4, 6, -4, 0.4, 20.0, true}};
                             },
                             "/layout/prune/front/1", "front"},
                      Spoilt{"frontOrder", cornerModel,
                             [](Doc& d) {
                                 layout(d).front = {{1, 6, -4, 0.5, 2.0, true}, {2, 7, -5, 0.5, 9.0, true}};
                             },
                             "/layout/prune/front/1/segments", "front"},
                      Spoilt{"frontBound", cornerModel,
                             [](Doc& d) {
                                 layout(d).front = {{1, 6, -4, 0.5, 3.0, false}};
                             },
                             "/layout/prune/front/0/objectiveBound", "front"},
                      Spoilt{"frontProof", cornerModel,
                             [](Doc& d) {
                                 layout(d).front = {{1, 6, -4, 0.5, 1.0, true}};
                             },
                             "/layout/prune/front/0/proven", "front"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(LayoutTransversals, SpoiltDocument,
                         ::testing::Values(Spoilt{"wholeLine", torusModel,
                                                  [](Doc& d) { layout(d).tracks[0].vertices.pop_back(); },
                                                  "/layout/tracks/0", "whole line"},
                                           Spoilt{"wholeLinePruned", torusModel,
                                                  [](Doc& d) {
                                                      layout(d).pruned = true;
                                                      layout(d).tracks[0].vertices.pop_back();
                                                  },
                                                  "/layout/tracks/0", "whole line"},
                                           Spoilt{"transversalBend", torusModel,
                                                  [](Doc& d) {
                                                      auto& vertices = layout(d).tracks[1].vertices;
                                                      vertices = {vertices[0], vertices[1], vertices[1] + 1};
                                                  },
                                                  "/layout/tracks/1/vertices/2", "transversal straight"},
                                           Spoilt{"transversalShort", torusModel,
                                                  [](Doc& d) { layout(d).tracks[1].vertices.pop_back(); },
                                                  "/layout/tracks/1/vertices/5", "transversal ends"}),
                         nameOf);

INSTANTIATE_TEST_SUITE_P(
    Surfaces, SpoiltDocument,
    ::testing::Values(Spoilt{"patchMissing", cornerModel, [](Doc& d) { d.surfaces->patches.pop_back(); },
                             "/surfaces/patches", "one patch per segment"},
                      Spoilt{"patchSegment", cornerModel, [](Doc& d) { patch(d).segment = 3; },
                             "/surfaces/patches/0/segment", "one patch per segment"},
                      Spoilt{"knotsDecrease", cornerModel, [](Doc& d) { patch(d).knots[1][2] = -1; },
                             "/surfaces/patches/0/knots/1/2", "knots"},
                      Spoilt{"knotsNumber", cornerModel, [](Doc& d) { patch(d).knots[0].push_back(9); },
                             "/surfaces/patches/0/knots/0", "knots"},
                      Spoilt{"domain", cornerModel,
                             [](Doc& d) { patch(d).knots[0].back() = patch(d).knots[0][2] = 1.5; },
                             "/surfaces/patches/0/knots/0", "domain"},
                      Spoilt{"degree", cornerModel, [](Doc& d) { patch(d).degree[1] = 0; },
                             "/surfaces/patches/0/degree/1", "degree"},
                      Spoilt{"ragged", cornerModel, [](Doc& d) { patch(d).rectangular = false; },
                             "/surfaces/patches/0/controlPoints", "control points"},
                      Spoilt{"tooFewPoints", cornerModel, [](Doc& d) { patch(d).count[0] = 1; },
                             "/surfaces/patches/0/controlPoints", "control points"},
                      Spoilt{"notFinite", cornerModel,
                             [](Doc& d) { patch(d).controlPoints[1][2] = infinity; },
                             "/surfaces/patches/0/controlPoints/0/1", "finite"},
                      Spoilt{"misses", cornerModel, [](Doc& d) { patch(d).controlPoints[0][0] += 1e-6; },
                             "/surfaces/patches/0", "interpolation"},
                      Spoilt{"gap", cornerModel,
                             [](Doc& d) {
                                 d.surfaces->interpolates = false;
                                 d.surfaces->patches[1].controlPoints[0][0] += 1e-6;
                             },
                             "/surfaces/patches/1", "watertight"}),
    nameOf);

/// Lifts the first patch by `height` at x = 0, and by `slope` more per unit of x.
void lift(Doc& d, double height, double slope) {
    for (auto& point : patch(d).controlPoints)
        point[2] += height + slope * point[0];
}

/// States one value of a figure for every patch, and another one for all together.
void stateOfAll(Doc& d, const char* figure, double ofEach, double ofAll) {
    for (auto& each : d.surfaces->patches)
        each.figures.stated[figure] = ofEach;
    d.surfaces->figures.stated[figure] = ofAll;
}

/// States that vertices are farther from the surfaces than the reference is.
void stateMovedVertices(Doc& d) {
    stateOfAll(d, "max", 1, 1);
    stateOfAll(d, "maxFromVertices", 1.01, 1.01);
}

INSTANTIATE_TEST_SUITE_P(
    Figures, SpoiltDocument,
    ::testing::Values(
        Spoilt{"fromFacets", statingModel, [](Doc& d) { lift(d, 1e-6, 0); },
               "/surfaces/patches/0/deviation/maxFromFacets", "deviation"},
        Spoilt{"fromVertices", statingModel,
               [](Doc& d) {
                   patch(d).figures.stated.erase("maxFromFacets");
                   lift(d, 1e-6, 0);
               },
               "/surfaces/patches/0/deviation/maxFromVertices", "deviation"},
        Spoilt{"gapFigure", statingModel, [](Doc& d) { lift(d, 1e-6, 0); },
               "/surfaces/patches/0/deviation/largestGap", "deviation"},
        Spoilt{"normalAngle", statingModel,
               [](Doc& d) {
                   for (auto& each : d.surfaces->patches)
                       each.figures.stated.erase("largestGap");
                   lift(d, 0, 1e-4);
               },
               "/surfaces/patches/0/deviation/largestNormalAngle", "deviation"},
        Spoilt{"creaseOfNoEdges", statingModel,
               [](Doc& d) {
                   d.surfaces->creases = {{0, 1, 0, 999}};
               },
               "/surfaces/creases/0/vertices/3", "vertex"},
        Spoilt{"innerNormalAngle", statingTorus,
               [](Doc& d) { patch(d).figures.stated["largestInnerNormalAngle"] = 1; },
               "/surfaces/patches/0/deviation/largestInnerNormalAngle", "deviation"},
        Spoilt{"folds", statingTorus,
               [](Doc& d) {
                   patch(d).figures.stated = {{"folds", 0}};
                   const auto width = static_cast<std::size_t>(patch(d).count[0]);
                   std::swap(patch(d).controlPoints[2 * width + 2], patch(d).controlPoints[2 * width + 3]);
               },
               "/surfaces/patches/0/deviation/folds", "deviation"},
        Spoilt{"meanAboveMaximum", statingModel,
               [](Doc& d) {
                   patch(d).figures.stated = {{"rms", 2}, {"max", 1}};
               },
               "/surfaces/patches/0/deviation/rms", "deviation"},
        Spoilt{"relativeLength", statingModel,
               [](Doc& d) {
                   d.surfaces->figures.stated.insert({{"max", 1}, {"maxRelative", 1e-3}});
               },
               "/surfaces/deviation/maxRelative", "deviation"},
        Spoilt{"totalIsLess", statingModel, [](Doc& d) { stateOfAll(d, "maxFromVertices", 1, 0.5); },
               "/surfaces/deviation/maxFromVertices", "deviation"},
        Spoilt{"totalIsMore", statingModel, [](Doc& d) { stateOfAll(d, "largestNormalDeviation", 1, 2); },
               "/surfaces/deviation/largestNormalDeviation", "deviation"},
        Spoilt{"sumOfFolds", statingModel, [](Doc& d) { stateOfAll(d, "folds", 1, 1); },
               "/surfaces/deviation/folds", "deviation"},
        Spoilt{"verticesAreOfTheReference", statingModel, stateMovedVertices, "/surfaces/deviation/max",
               "deviation"}),
    nameOf);

/// For every edge, the number of sides of segments on it.
std::map<std::pair<int, int>, int> borders(const LayoutPart& part) {
    std::map<std::pair<int, int>, int> count;
    for (const LayoutPart::Segment& segment : part.segments)
        for (const std::vector<int>& side : segment.sides)
            for (std::size_t k = 1; k < side.size(); ++k)
                ++count[std::minmax({side[k - 1], side[k]})];
    return count;
}

TEST(CheckFigures, CreasesAreBordersOfTwoPatches) {
    Model model = statingModel();
    const auto count = borders(layout(model.document));
    for (const auto& quad : model.mesh.quads)
        for (std::size_t k = 0; k < 4; ++k) {
            const std::vector<int> path{quad[k], quad[(k + 1) % 4]};
            const auto border = count.find(std::minmax({path[0], path[1]}));
            const bool isBorder = border != count.end() && border->second == 2;
            model.document.surfaces->creases = {path};
            const Report report = checkDocument(model.mesh, model.document);
            EXPECT_EQ(report.ok(), isBorder);
            EXPECT_TRUE(isBorder || found(report, "/surfaces/creases/0/vertices/1", "crease"));
        }
}

TEST(CheckFigures, NormalsAreComparedAcrossSmoothBordersOnly) {
    Model model = statingModel();
    for (auto& each : model.document.surfaces->patches)
        each.figures.stated = {{"largestNormalAngle", 0}};
    lift(model.document, 0, 1e-4);
    EXPECT_FALSE(checkDocument(model.mesh, model.document).ok());
    for (const auto& [edge, times] : borders(layout(model.document)))
        if (times == 2) model.document.surfaces->creases->push_back({edge.first, edge.second});
    const Report report = checkDocument(model.mesh, model.document);
    EXPECT_TRUE(report.ok()) << listed(report);
    model.document.surfaces->creases.reset(); // it is not known which borders are smooth
    EXPECT_TRUE(checkDocument(model.mesh, model.document).ok());
}

TEST(CheckFigures, BelievesVerticesOfScansToBeAnywhere) {
    Model model = statingModel();
    stateMovedVertices(model.document);
    EXPECT_FALSE(checkDocument(model.mesh, model.document).ok());
    model.document.surfaces->isOfScan = true;
    EXPECT_TRUE(checkDocument(model.mesh, model.document).ok());
}

TEST(CheckFigures, BelievesThatVerticesAroundFlatCornersWereMoved) {
    Model model = statingModel();
    stateMovedVertices(model.document);
    const auto complains = [&] {
        Report report;
        checkAgreement(model.mesh, *model.document.surfaces, report);
        return !report.ok();
    };
    EXPECT_TRUE(complains());
    // A quad bent about its diagonal, almost onto itself: flat corners only as seen along its normal.
    const auto& [a, b, c, d] = model.mesh.quads[0];
    for (std::size_t k = 0; k < 3; ++k) {
        const auto coordinate = [&](int vertex) -> double& {
            return model.mesh.points[static_cast<std::size_t>(vertex)][k];
        };
        const double middle = (coordinate(a) + coordinate(c)) / 2;
        for (const int corner : {b, d})
            coordinate(corner) = middle + 0.25 * (coordinate(corner) - middle) + (k == 2 ? 2 : 0);
    }
    EXPECT_FALSE(complains());
}

TEST(CheckFigures, FindsTheSameOnAnyNumberOfThreads) {
    Model model = statingModel();
    lift(model.document, 1e-3, 0);
    for (auto& each : model.document.surfaces->patches)
        each.figures.stated = {{"maxFromFacets", 1e-9}, {"maxFromVertices", 1e-9}};
    const Report alone = checkDocument(model.mesh, model.document);
    const Report together = checkDocument(model.mesh, model.document, Report(), 3);
    EXPECT_GT(alone.total(), 1U);
    EXPECT_EQ(listed(alone), listed(together));
}

TEST(CheckFigures, AcceptsWhatIsTrue) {
    const Model model = statingModel();
    EXPECT_TRUE(checkDocument(model.mesh, model.document).ok());
    Model lifted = statingModel();
    lift(lifted.document, 1e-6, 0);
    for (const char* figure : {"largestGap", "maxFromFacets", "maxFromVertices"})
        stateOfAll(lifted.document, figure, 1e-6, 1e-6);
    EXPECT_TRUE(checkDocument(lifted.mesh, lifted.document).ok());
}

} // namespace
} // namespace qm::test
