/// \file Reading the sections of documents: the result equals what was written, and every violation is
/// reported with its place.
#include "base/at.h"
#include "bspline/splines/basis.h"
#include "document/document.h"
#include "document/files/sha256.h"
#include "document/json/json_place.h"
#include "document/model.h"
#include "document/sections/enumeration_section.h"
#include "mesh/topology.h"
#include "support/message_of.h"
#include "support/sample_document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace {

using qm::at;
using qm::Document;
using qm::Json;
using qm::Kind;
using qm::test::messageOf;
using qm::test::sampleDocument;

class ModelTest : public testing::Test {
protected:
    /// The error message for the section of a kind after an edit, without the name of the document.
    template <class Edit> std::string complaint(Kind kind, Edit&& edit) {
        Document document = sampleDocument(folder, kind);
        edit(document.root);
        const std::string message = messageOf([&] { (void)qm::readModel(document, kind); });
        const std::string name = "standard input: ";
        return message.rfind(name, 0) == 0 ? message.substr(name.size()) : message;
    }

    static bool begins(const std::string& text, const std::string& start) {
        return text.rfind(start, 0) == 0;
    }

    qm::test::TemporaryFolder folder;
};

TEST_F(ModelTest, EverythingThatIsWrittenReadsBack) {
    Document document = sampleDocument(folder, Kind::surfaces);
    const std::string before = qm::printDocument(document);
    const qm::Model model = qm::readModel(document, Kind::surfaces);
    EXPECT_TRUE(model.notes.empty());
    EXPECT_EQ(qm::printDocument(document), before);
    ASSERT_TRUE(model.layout && model.surfaces);
    EXPECT_EQ(model.surfaces->patches.size(), model.layout->segments.size());
    EXPECT_EQ(Json(model.layout->cost), document.root["layout"]["cost"]);

    Document searched = sampleDocument(folder, Kind::enumeration);
    const qm::Model graphs = qm::readModel(searched, Kind::enumeration);
    EXPECT_TRUE(graphs.notes.empty());
    ASSERT_TRUE(graphs.cut && graphs.enumeration);
    EXPECT_EQ(graphs.features.curves.size(), 1U);
    EXPECT_EQ(graphs.complex.seeds.size(), 1U);
    EXPECT_TRUE(graphs.baseComplex.seeds.empty());
    const qm::SeparatrixIndex separatrices(graphs.mesh, graphs.baseComplex);
    EXPECT_EQ(qm::enumerationToJson(graphs.mesh, separatrices, *graphs.enumeration),
              searched.root["enumeration"]);
}

TEST_F(ModelTest, ADocumentSurvivesItsText) {
    for (const Kind kind : {Kind::basecomplex, Kind::cut, Kind::surfaces}) {
        const std::string text = qm::printDocument(sampleDocument(folder, kind));
        const Document again = qm::parseDocument(text, "sample.json");
        EXPECT_EQ(qm::printDocument(again), text);
        EXPECT_EQ(qm::requireKind(again, Kind::basecomplex), kind);
    }
}

// ------------------------------------------------------------------------------------------- the mesh

TEST_F(ModelTest, FindsTheMeshBesideTheDocument) {
    Document document = sampleDocument(folder, Kind::basecomplex);
    document.root["mesh"]["path"] = "mesh.obj";
    document.path = folder.file("part.json");
    EXPECT_NO_THROW((void)qm::readModel(document, Kind::basecomplex));
}

TEST_F(ModelTest, RefusesAMeshThatHasChanged) {
    Document document = sampleDocument(folder, Kind::basecomplex);
    const std::string path = document.root["mesh"]["path"];
    folder.write("mesh.obj", "# another\nv 0 0 0\n");
    const std::string message = messageOf([&] { (void)qm::readModel(document, Kind::basecomplex); });
    EXPECT_TRUE(begins(message, path + ": the mesh has changed since standard input was made. ")) << message;
    EXPECT_NE(message.find("qm-basecomplex"), std::string::npos);
}

TEST_F(ModelTest, TheMeshMayBeElsewhere) {
    Document document = sampleDocument(folder, Kind::basecomplex);
    const std::string path = document.root["mesh"]["path"];
    std::filesystem::rename(path, folder.file("moved.obj"));
    EXPECT_TRUE(
        begins(messageOf([&] { (void)qm::readModel(document, Kind::basecomplex); }),
               path + ": the mesh that standard input refers to is not there. Name the mesh with --mesh"));
    EXPECT_NO_THROW((void)qm::readModel(document, Kind::basecomplex, folder.file("moved.obj")));
    document.root["mesh"]["path"] = "-";
    EXPECT_NE(messageOf([&] { (void)qm::readModel(document, Kind::basecomplex); }).find("--mesh"),
              std::string::npos);
    EXPECT_NO_THROW((void)qm::readModel(document, Kind::basecomplex, folder.file("moved.obj")));
}

TEST_F(ModelTest, CountsMustBeThoseOfTheMesh) {
    EXPECT_TRUE(begins(complaint(Kind::basecomplex, [](Json& root) { root["mesh"]["faces"] = 5; }),
                       "/mesh/faces: the mesh has "));
}

TEST(Sha256, IsTheStandardOne) {
    EXPECT_EQ(qm::sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(qm::sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

// ------------------------------------------------------------------------------------------- base complex

TEST_F(ModelTest, TheBaseComplexCannotBeEdited) {
    const std::string rule = ": is not what follows from the mesh. The base complex cannot be edited";
    const auto begin = [&](const std::string& message, const std::string& pointer) {
        EXPECT_TRUE(begins(message, pointer + rule)) << message;
    };
    begin(
        complaint(Kind::basecomplex, [](Json& root) { root["baseComplex"]["extraordinaryVertices"][3] = 0; }),
        "/baseComplex/extraordinaryVertices/3");
    begin(complaint(Kind::basecomplex, [](Json& root) { root["baseComplex"]["ordinaryJunctions"] = 99; }),
          "/baseComplex/ordinaryJunctions");
    begin(complaint(Kind::basecomplex,
                    [](Json& root) { root["baseComplex"]["separatrices"][2]["vertices"][1] = 0; }),
          "/baseComplex/separatrices/2/vertices/1");
    begin(complaint(Kind::basecomplex, [](Json& root) { root["baseComplex"]["separatrices"].erase(7); }),
          "/baseComplex/separatrices/7/id");
    EXPECT_EQ(complaint(Kind::basecomplex, [](Json& root) { root["baseComplex"]["mine"] = "kept"; }), "");
}

// ------------------------------------------------------------------------------------------- features

TEST_F(ModelTest, CurvesMayBeDeletedAndAdded) {
    EXPECT_EQ(complaint(Kind::features, [](Json& root) { root["features"]["curves"] = Json::array(); }), "");
    Document document = sampleDocument(folder, Kind::features);
    Json& curves = document.root["features"]["curves"];
    curves[0]["id"] = 17;
    curves[0].erase("mine");
    EXPECT_EQ(qm::readModel(document, Kind::features).features.curves.size(), 1U);
}

TEST_F(ModelTest, ACurveMustRunStraightAlongAMeshLine) {
    const qm::QuadMesh& mesh = qm::test::sampleMesh();
    const auto withCurve = [&](const std::vector<int>& vertices, int seed) {
        return complaint(Kind::features, [&](Json& root) {
            root["features"]["curves"] = {{{"id", 0}, {"vertices", vertices}, {"seed", seed}}};
        });
    };
    const Json curve = sampleDocument(folder, Kind::features).root["features"]["curves"][0];
    std::vector<int> good = curve["vertices"];
    const int seed = curve["seed"];
    EXPECT_EQ(withCurve(good, seed), "");

    EXPECT_TRUE(begins(withCurve({good[0], good[2]}, seed), "/features/curves/0/vertices/1: vertex " +
                                                                std::to_string(good[2]) +
                                                                " is not joined to vertex"));
    EXPECT_EQ(withCurve({good[0], 100000}, seed),
              "/features/curves/0/vertices/1: there is no vertex 100000, only 0 to " +
                  std::to_string(mesh.n_vertices() - 1));
    EXPECT_TRUE(begins(withCurve(good, 100000), "/features/curves/0/seed: there is no vertex 100000"));
    EXPECT_TRUE(begins(withCurve(good, good[0] == 0 ? 1 : 0), "/features/curves/0/seed: vertex "));

    // A turn at a regular vertex.
    const qm::HalfedgeId first = mesh.find_halfedge(qm::VertexId(good[0]), qm::VertexId(good[1]));
    const int aside = mesh.to_vertex_handle(mesh.next_halfedge_handle(first)).idx();
    EXPECT_TRUE(begins(withCurve({good[0], good[1], aside}, seed),
                       "/features/curves/0/vertices/1: the path turns at vertex " + std::to_string(good[1]) +
                           ". Straight on lies vertex " + std::to_string(good[2])));
    // A curve over an extraordinary vertex.
    const qm::VertexId corner = qm::extraordinaryVertices(mesh).front();
    std::vector<int> around;
    for (const qm::VertexId next : mesh.vv_range(corner))
        around.push_back(next.idx());
    EXPECT_EQ(withCurve({around[0], corner.idx(), around[1]}, seed),
              "/features/curves/0/vertices/1: vertex " + std::to_string(corner.idx()) +
                  " is extraordinary, where lines end");
    // A seed at an extraordinary vertex.
    EXPECT_TRUE(begins(withCurve({corner.idx(), around[0]}, corner.idx()),
                       "/features/curves/0/seed: vertex " + std::to_string(corner.idx()) +
                           " is no interior regular vertex"));
}

TEST_F(ModelTest, CurvesMustNotShareEdgesSeedsOrIds) {
    const auto doubled = [&](const auto& edit) {
        return complaint(Kind::features, [&](Json& root) {
            Json& curves = root["features"]["curves"];
            curves.push_back(curves[0]);
            edit(curves);
        });
    };
    EXPECT_EQ(doubled([](Json&) {}), "/features/curves/1/id: another entry has id 0 too");
    EXPECT_EQ(doubled([](Json& curves) { curves[1]["id"] = 1; }),
              "/features/curves/1/vertices/1: the edge to this vertex lies on a curve already");
    EXPECT_TRUE(begins(doubled([](Json& curves) {
                           curves[1]["id"] = 1;
                           std::vector<int> vertices = curves[0]["vertices"];
                           curves[0]["vertices"] = {vertices[0], vertices[1]};
                           curves[1]["vertices"] = {vertices[1], vertices[2]};
                       }),
                       "/features/curves/1/seed: another curve has its seed there"));
}

// ------------------------------------------------------------------------------------------- cut

TEST_F(ModelTest, LabelsMayBeEditedAndAreMeasuredAnew) {
    Document document = sampleDocument(folder, Kind::cut);
    Json& cut = document.root["cut"];
    for (Json& label : cut["labels"])
        label = 0;
    cut["mine"] = 1;
    const qm::Model model = qm::readModel(document, Kind::cut);
    ASSERT_EQ(model.notes.size(), 1U);
    EXPECT_TRUE(begins(model.notes[0], "/cut/subMeshes: "));
    EXPECT_EQ(cut["subMeshes"][1]["quasiComplexity"], 0);
    EXPECT_GT(cut["subMeshes"][0]["quasiComplexity"].get<double>(), 0);
    EXPECT_EQ(cut["mine"], 1);
    EXPECT_TRUE(qm::readModel(document, Kind::cut).notes.empty());
}

TEST_F(ModelTest, LabelsMustBeThere) {
    const std::string vertices = std::to_string(qm::test::sampleMesh().n_vertices());
    EXPECT_EQ(complaint(Kind::cut,
                        [](Json& root) {
                            root["cut"]["labels"] = {0, 1, 0};
                        }),
              "/cut/labels: has 3 entries, the mesh has " + vertices + " vertices");
    EXPECT_EQ(complaint(Kind::cut, [](Json& root) { root["cut"]["labels"][12] = 2; }),
              "/cut/labels/12: there is no sub-mesh 2, only 0 to 1");
    EXPECT_EQ(complaint(Kind::cut, [](Json& root) { root["cut"]["subMeshes"][1]["id"] = 2; }),
              "/cut/subMeshes/1/id: is not the entry's position in its list, 1");
    EXPECT_TRUE(begins(complaint(Kind::cut, [](Json& root) { root["cut"]["subMeshes"][1]["sink"] = 123456; }),
                       "/cut/subMeshes/1/sink: there is no vertex 123456"));
    EXPECT_EQ(complaint(Kind::cut, [](Json& root) { root["cut"].erase("chi"); }), "/cut: lacks 'chi'");
    EXPECT_EQ(complaint(Kind::cut, [](Json& root) { root["cut"]["terminals"] = "north"; }),
              "/cut/terminals: 'north' is not known");
    EXPECT_EQ(complaint(Kind::cut, [](Json& root) { root["cut"]["chi"] = -1; }),
              "/cut/chi: is out of range, at least 0");
}

// ------------------------------------------------------------------------------------------- constraints

TEST_F(ModelTest, ConstraintsAreEdgesOfSeparatrices) {
    Document document = sampleDocument(folder, Kind::cut);
    const std::vector<int> way = document.root["baseComplex"]["separatrices"][0]["vertices"];
    document.root["constraints"] = {{"required", {{{"vertices", way}}}}};
    const qm::Model model = qm::readModel(document, Kind::cut);
    EXPECT_EQ(model.constraints.required.size(), way.size() - 1);
    EXPECT_TRUE(model.constraints.forbidden.empty());

    const auto constrained = [&](const Json& constraints) {
        return complaint(Kind::cut, [&](Json& root) { root["constraints"] = constraints; });
    };
    EXPECT_EQ(
        constrained({{"required", {{{"vertices", way}}}}, {"forbidden", {{{"vertices", {way[0], way[1]}}}}}}),
        "/constraints/forbidden/0/vertices/1: the edge to this vertex is both required and forbidden");
    // An edge that no separatrix touches.
    std::vector<bool> used(qm::test::sampleMesh().n_vertices());
    for (const Json& separatrix : document.root["baseComplex"]["separatrices"])
        for (const int vertex : separatrix["vertices"])
            used[at(vertex)] = true;
    for (const qm::EdgeId edge : qm::test::sampleMesh().edges()) {
        const int a =
            qm::test::sampleMesh().to_vertex_handle(qm::test::sampleMesh().halfedge_handle(edge, 0)).idx();
        const int b =
            qm::test::sampleMesh().to_vertex_handle(qm::test::sampleMesh().halfedge_handle(edge, 1)).idx();
        if (used[at(a)] || used[at(b)]) continue;
        const std::vector<int> curve = document.root["features"]["curves"][0]["vertices"];
        if (std::find(curve.begin(), curve.end(), a) != curve.end()) continue;
        const std::string message = constrained({{"forbidden", {{{"vertices", {a, b}}}}}});
        if (message.empty()) continue; // the edge lies on the seed's line
        EXPECT_TRUE(begins(
            message, "/constraints/forbidden/0/vertices/1: the edge to this vertex lies on no separatrix"))
            << message;
        return;
    }
    FAIL() << "the sample mesh has no edge beside all separatrices";
}

// ------------------------------------------------------------------------------------------- enumeration

TEST_F(ModelTest, GraphsMustFitTheMesh) {
    const auto graphs = [](Json& root) -> Json& { return root["enumeration"]["subMeshes"][0]["graphs"]; };
    const std::string tracks = "/enumeration/subMeshes/0/graphs/0/tracks";
    EXPECT_TRUE(begins(complaint(Kind::enumeration, [&](Json& root) { graphs(root)[0]["cost"] = 5; }),
                       "/enumeration/subMeshes/0/graphs/0/cost: is not "));
    EXPECT_TRUE(begins(complaint(Kind::enumeration,
                                 [&](Json& root) { root["enumeration"]["subMeshes"][0]["cost"] = nullptr; }),
                       "/enumeration/subMeshes/0/cost: is not "));
    EXPECT_EQ(complaint(Kind::enumeration, [&](Json& root) { graphs(root)[0].erase("cost"); }), "");
    EXPECT_EQ(complaint(Kind::enumeration,
                        [&](Json& root) { graphs(root)[0]["tracks"][0]["separatrix"] = 100000; }),
              tracks + "/0/separatrix: is not the separatrix that begins with the track's first edge");
    EXPECT_EQ(complaint(Kind::enumeration,
                        [&](Json& root) {
                            Json& list = graphs(root)[0]["tracks"];
                            list.push_back(list[0]);
                            graphs(root)[0].erase("cost");
                        })
                  .find(tracks),
              0U);
    EXPECT_EQ(complaint(Kind::enumeration,
                        [&](Json& root) {
                            Json& track = graphs(root)[0]["tracks"][0];
                            track["vertices"].erase(0);
                            track.erase("separatrix");
                        }),
              tracks + "/0/vertices/0: no particle starts here in this direction");
    EXPECT_EQ(complaint(Kind::enumeration, [&](Json& root) { root["enumeration"]["subMeshes"].erase(1); }),
              "/enumeration/subMeshes: has 1 entries, the mesh is cut into 2");
    EXPECT_EQ(complaint(Kind::enumeration, [&](Json& root) { root["enumeration"]["method"] = "magic"; }),
              "/enumeration/method: 'magic' is not known");
    for (const char* count : {"", "012", "1e3", "-5", "12a"})
        EXPECT_TRUE(
            begins(complaint(Kind::enumeration, [&](Json& root) { root["enumeration"]["count"] = count; }),
                   "/enumeration/count: is no whole number in decimal digits"))
            << count;
    EXPECT_EQ(complaint(Kind::enumeration,
                        [&](Json& root) { root["enumeration"]["count"] = "123456789012345678901234567890"; }),
              "");
}

TEST_F(ModelTest, TracksMustStartInTheirSubMesh) {
    const std::string message = complaint(Kind::enumeration, [&](Json& root) {
        Json& subMeshes = root["enumeration"]["subMeshes"];
        subMeshes[0]["graphs"] = subMeshes[1]["graphs"];
        subMeshes[0]["cost"] = subMeshes[1]["cost"];
    });
    EXPECT_EQ(message,
              "/enumeration/subMeshes/0/graphs/0/tracks/0/vertices/0: the track starts in another sub-mesh");
}

// ------------------------------------------------------------------------------------------- layout

TEST_F(ModelTest, SegmentsFollowFromTheTracks) {
    EXPECT_EQ(
        complaint(Kind::layout, [](Json& root) { root["layout"]["segments"][2]["size"][0] = 77; }),
        "/layout/segments/2/size/0: is not what follows from the tracks. Delete /layout/segments and the "
        "segments are made anew");
    Document document = sampleDocument(folder, Kind::layout);
    const std::string before = qm::printDocument(document);
    for (const char* key : {"cost", "segments", "quality"})
        document.root["layout"].erase(key);
    document.root["layout"]["tracks"][3].erase("cost");
    const qm::Model model = qm::readModel(document, Kind::layout);
    ASSERT_EQ(model.notes.size(), 1U);
    EXPECT_TRUE(begins(model.notes[0], "/layout: "));
    EXPECT_EQ(qm::readModel(document, Kind::layout).notes.size(), 0U);
    for (const char* key : {"cost", "segments", "quality", "tracks"})
        EXPECT_EQ(document.root["layout"][key], qm::parseJson(before)["layout"][key]) << key;
}

TEST_F(ModelTest, ATrackThatIsDeletedIsHonouredOrRefused) {
    // If its segments are not made anew, a layout without one of its tracks is refused.
    const auto without = [this](std::size_t track, bool withSegments) {
        return complaint(Kind::layout, [&](Json& root) {
            root["layout"]["tracks"].erase(track);
            root["layout"].erase("cost");
            if (!withSegments) root["layout"].erase("segments");
        });
    };
    const std::size_t tracks = sampleDocument(folder, Kind::layout).root["layout"]["tracks"].size();
    std::size_t honoured = 0;
    for (std::size_t i = 0; i < tracks; ++i) {
        EXPECT_TRUE(begins(without(i, true), "/layout/")) << i;
        const std::string message = without(i, false);
        if (message.empty())
            ++honoured;
        else
            EXPECT_TRUE(begins(message, "/layout/tracks: do not cut the mesh into grids: ")) << message;
    }
    EXPECT_LT(honoured, tracks);
}

TEST_F(ModelTest, TracksOfALayoutAreStraightAndApart) {
    const auto edited = [this](const auto& edit) {
        return complaint(Kind::layout, [&](Json& root) { edit(root["layout"]); });
    };
    EXPECT_TRUE(begins(edited([](Json& layout) { layout["cost"] = 1; }), "/layout/cost: is not "));
    EXPECT_TRUE(begins(edited([](Json& layout) { layout["tracks"][1]["cost"] = 1; }),
                       "/layout/tracks/1/cost: is not "));
    EXPECT_TRUE(begins(edited([](Json& layout) { layout["tracks"][1]["vertices"][0] = -1; }),
                       "/layout/tracks/1/vertices/0: there is no vertex -1"));
    EXPECT_TRUE(begins(edited([](Json& layout) {
                           layout["tracks"].push_back(layout["tracks"][0]);
                           layout["tracks"].back()["id"] = 1000;
                       }),
                       "/layout/tracks/"));
    EXPECT_EQ(edited([](Json& layout) { layout["tracks"][1]["id"] = 0; }),
              "/layout/tracks/1/id: another entry has id 0 too");
}

// ------------------------------------------------------------------------------------------- surfaces

TEST_F(ModelTest, PatchesMustBeSplines) {
    const auto edited = [this](const auto& edit) {
        return complaint(Kind::surfaces, [&](Json& root) { edit(root["surfaces"]["patches"]); });
    };
    EXPECT_TRUE(begins(edited([](Json& patches) { patches.erase(1); }), "/surfaces/patches: has "));
    EXPECT_TRUE(begins(edited([](Json& patches) { patches[1]["segment"] = 0; }),
                       "/surfaces/patches/1/segment: patches stand in the order of the segments"));
    EXPECT_TRUE(begins(edited([](Json& patches) { patches[0]["knots"][1].push_back(1e9); }),
                       "/surfaces/patches/0/knots/1: has "));
    EXPECT_EQ(edited([](Json& patches) { patches[0]["knots"][0][2] = 1e9; }),
              "/surfaces/patches/0/knots/0/3: is less than the knot before it");
    EXPECT_TRUE(begins(edited([](Json& patches) {
                           for (Json& knot : patches[0]["knots"][0])
                               knot = knot.get<double>() + 1;
                       }),
                       "/surfaces/patches/0/knots/0: the surface does not run from 0 to "));
    EXPECT_EQ(edited([](Json& patches) { patches[0]["controlPoints"][1].erase(0); }),
              "/surfaces/patches/0/controlPoints/1: is not as long as the first row");
    EXPECT_EQ(edited([](Json& patches) { patches[0]["controlPoints"][1][0].erase(0); }),
              "/surfaces/patches/0/controlPoints/1/0: a point has three coordinates");
    EXPECT_EQ(edited([](Json& patches) { patches[0]["degree"][0] = 10; }),
              "/surfaces/patches/0/degree/0: is more than 9");
}

TEST_F(ModelTest, DomainsEndExactlyWhereSegmentsDo) {
    Document document = sampleDocument(folder, Kind::surfaces);
    const qm::Model exact = qm::readModel(document, Kind::surfaces);
    for (Json& knot : document.root["surfaces"]["patches"][0]["knots"][0])
        knot = knot.get<double>() + 1e-10;
    const qm::Model rounded = qm::readModel(document, Kind::surfaces);
    const auto ends = [](const qm::Model& model) {
        const qm::Patch& patch = model.surfaces->patches[0];
        return qm::domain(patch.knots[0], patch.degree[0]);
    };
    EXPECT_EQ(ends(rounded), ends(exact));
}

// ------------------------------------------------------------------------------------------- whole documents

TEST(Documents, AreRecognised) {
    const auto refusal = [](const std::string& text) {
        return messageOf([&] { (void)qm::parseDocument(text, "part.json"); });
    };
    for (const char* text : {"[]", "null", "\"layout\"", "3", "{}"})
        EXPECT_EQ(refusal(text).rfind("part.json: /: is no document of these tools", 0), 0U) << refusal(text);
    EXPECT_EQ(refusal(R"({"kind": 3})"), "part.json: /kind: is number, not string");
    EXPECT_EQ(refusal(R"({"kind": "spoon", "version": 1})"),
              "part.json: /kind: 'spoon' is no kind of document");
    EXPECT_EQ(refusal(R"({"kind": "spo\u0000on", "version": 1})"),
              "part.json: /kind: 'spo?on' is no kind of document");
    EXPECT_EQ(refusal(R"({"kind": "layout"})"), "part.json: /: lacks 'version'");
    EXPECT_EQ(refusal(R"({"kind": "layout", "version": 99})").rfind("part.json: /version: is not 1", 0), 0U);
    EXPECT_EQ(refusal(R"({"kind": "layout", "version": 1})").rfind("part.json: lacks '", 0), 0U);
}

TEST_F(ModelTest, AKindAndItsSectionsMustAgree) {
    Json root = sampleDocument(folder, Kind::layout).root;
    root["kind"] = "cut";
    EXPECT_EQ(messageOf([&] { (void)qm::parseDocument(root.dump(), "part.json"); }),
              "part.json: /kind: is cut, but there is a section /enumeration. Set the kind to enumeration or "
              "delete "
              "the section");
}

TEST_F(ModelTest, ATooEarlyKindNamesTheToolToRun) {
    const Document document = sampleDocument(folder, Kind::cut);
    EXPECT_EQ(messageOf([&] { (void)qm::requireKind(document, Kind::enumeration); }),
              "/kind: is cut, but enumeration or a later kind is needed. Run qm-enum first");
    EXPECT_EQ(qm::requireKind(document, Kind::features), Kind::cut);
}

TEST_F(ModelTest, AStageReplacesItsSectionAndDropsAllLaterOnes) {
    Document document = sampleDocument(folder, Kind::surfaces);
    document.root["x-owner"] = "Ada";
    document.root["history"].push_back({{"tool", "my-tool"}, {"version", "1"}, {"options", Json::object()}});
    qm::putSection(document, {Kind::cut, "qm-cut", {{"chi", 20}}, {{"labels", {1, 2}}}});
    std::vector<std::string> tools;
    for (const Json& step : document.root["history"])
        tools.push_back(step["tool"]);
    EXPECT_EQ(tools, (std::vector<std::string>{"qm-basecomplex", "qm-features", "my-tool", "qm-cut"}));
    EXPECT_EQ(document.root["history"].back()["options"], Json({{"chi", 20}}));
    EXPECT_EQ(document.root["kind"], "cut");
    EXPECT_FALSE(document.has(Kind::enumeration) || document.has(Kind::layout) ||
                 document.has(Kind::surfaces));
    EXPECT_TRUE(document.has(Kind::features));
    const Json printed = qm::parseJson(qm::printDocument(document));
    std::vector<std::string> keys;
    for (const auto& [key, value] : printed.items())
        keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"kind", "version", "mesh", "history", "baseComplex", "features",
                                              "cut", "x-owner"}));
}

TEST_F(ModelTest, PruningBuildsOnPruning) {
    Document document = sampleDocument(folder, Kind::layout);
    for (int i = 0; i < 2; ++i)
        qm::putSection(document, {Kind::layout, "qm-prune", {}, document.root["layout"]});
    EXPECT_EQ(document.root["history"].size(), 7U);
    qm::putSection(document, {Kind::layout, "qm-merge", {}, document.root["layout"]});
    EXPECT_EQ(document.root["history"].size(), 5U);
}

} // namespace
