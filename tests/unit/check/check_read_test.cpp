// The checker's reader accepts any JSON and invents nothing.
#include "check/document/check_history.h"
#include "check/document/read_document.h"

#include <gtest/gtest.h>

#include <functional>

namespace qm::test {
namespace {

using namespace check;
using Json = nlohmann::ordered_json;

Json sample() {
    return Json::parse(R"({
        "kind": "surfaces",
        "history": [{"tool": "qm-basecomplex", "options": {}}, {"tool": "qm-enum", "options": {}},
                    {"tool": "qm-merge", "options": {}},
                    {"tool": "qm-bspline", "options": {"fit": "smooth", "tolerance": 0.25}}],
        "constraints": {"required": [{"vertices": [1, 2]}], "forbidden": []},
        "baseComplex": {"extraordinaryVertices": [3, 4], "ordinaryJunctions": 2,
                        "separatrices": [{"id": 0, "vertices": [3, 4], "opposite": null,
                                          "selfCrossing": true}]},
        "features": {"rho": 0.5, "curves": [{"id": 0, "vertices": [5, 6], "seed": 6}]},
        "cut": {"chi": 40, "labels": [0, 1],
                "subMeshes": [{"id": 0, "quasiComplexity": 2.5, "source": null}]},
        "enumeration": {"alpha": 0.4, "epsilon": 0.2, "count": "12", "subMeshes": [
            {"id": 0, "cost": -1.5, "lowerBound": null, "count": "12",
             "graphs": [{"cost": -1.5, "tracks": [{"separatrix": 0, "vertices": [3, 4]}]}]}]},
        "layout": {"cost": -1.5, "lowerBound": -2, "quality": {"rho": 0.5, "segments": 1},
                   "tracks": [{"id": 0, "vertices": [3, 4], "cost": -1.5, "transversal": true}],
                   "segments": [{"id": 0, "size": [1, 2], "corners": [0, 1, 2, 3],
                                 "sides": [[0, 1], [1, 2], [2, 3], [3, 0]], "faces": [0, 1]}]},
        "surfaces": {"patches": [{"segment": 0, "degree": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, 2, 2]],
                                  "controlPoints": [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0.5]]]}],
                     "creases": [{"vertices": [0, 1, 2]}, {"vertices": [7, 8]}]}})");
}

TEST(CheckReadDocument, TakesEveryFigure) {
    const CheckedDocument document = readDocument(sample());
    EXPECT_EQ(document.constraints->required, (std::vector<std::vector<int>>{{1, 2}}));
    EXPECT_EQ(document.baseComplex->extraordinaryVertices, (std::vector<int>{3, 4}));
    EXPECT_EQ(document.baseComplex->ordinaryJunctions, 2);
    EXPECT_FALSE(document.baseComplex->separatrices[0].opposite.has_value());
    EXPECT_TRUE(document.baseComplex->separatrices[0].selfCrossing);
    EXPECT_EQ(document.features->curves[0].seed, 6);
    EXPECT_EQ(document.cut->labels, (std::vector<int>{0, 1}));
    EXPECT_EQ(document.cut->subMeshes[0].quasiComplexity, 2.5);
    EXPECT_FALSE(document.cut->subMeshes[0].ordinaryJunctions.has_value());
    EXPECT_EQ(document.weights->alpha, 0.4);
    EXPECT_EQ(document.enumeration->count, "12");
    EXPECT_EQ(document.enumeration->subMeshes[0].graphs[0].tracks[0].separatrix, 0);
    EXPECT_FALSE(document.enumeration->subMeshes[0].lowerBound.has_value());
    EXPECT_EQ(document.layout->lowerBound, -2);
    EXPECT_EQ(document.layout->quality.rho, 0.5);
    EXPECT_EQ(document.layout->quality.segments, 1);
    EXPECT_TRUE(document.layout->tracks[0].transversal);
    EXPECT_TRUE(document.layout->divided);
    EXPECT_FALSE(document.layout->pruned);
    EXPECT_EQ(document.layout->segments[0].sides[3], (std::vector<int>{3, 0}));
    const auto& patch = document.surfaces->patches[0];
    EXPECT_EQ(patch.count, (std::array<int, 2>{2, 2}));
    EXPECT_EQ(patch.controlPoints[3][2], 0.5);
    EXPECT_TRUE(patch.rectangular);
    EXPECT_FALSE(document.surfaces->interpolates);
    EXPECT_TRUE(document.surfaces->watertight);
    EXPECT_EQ(document.surfaces->creases, (std::vector<std::vector<int>>{{0, 1, 2}, {7, 8}}));
}

TEST(CheckReadDocument, ReadsNoIndexThatIsNone) {
    Json json = sample();
    json["baseComplex"]["extraordinaryVertices"] =
        Json::parse(R"([1e300, -4, 2.5, "7", 3e9, null, 8.0, true])");
    EXPECT_EQ(readDocument(json).baseComplex->extraordinaryVertices,
              (std::vector<int>{-1, -1, -1, -1, -1, -1, 8, -1}));
}

/// Calls f with the document falsified at every place in every way.
void spoilEverywhere(Json& root, Json& place, const std::function<void()>& f) {
    for (const char* text : {"null", "-1", "1e400", "\"x\"", "[]", "{}", "[[[]]]", "true"}) {
        const Json kept = std::exchange(place, Json::parse(text, nullptr, false));
        f();
        place = kept;
    }
    if (place.is_structured())
        for (auto& inner : place)
            spoilEverywhere(root, inner, f);
}

TEST(CheckReadDocument, NeverFails) {
    Json root = sample();
    std::size_t read = 0;
    spoilEverywhere(root, root, [&] {
        const CheckedDocument document = readDocument(root);
        Report report;
        checkHistory(root, report);
        read += document.baseComplex.has_value();
    });
    EXPECT_GT(read, 100U);
}

Json withTools(const std::vector<const char*>& tools, const char* kind) {
    Json json{{"kind", kind}, {"history", Json::array()}};
    for (const char* tool : tools)
        json["history"].push_back({{"tool", tool}});
    return json;
}

std::size_t historyViolations(const std::vector<const char*>& tools, const char* kind) {
    Report report;
    checkHistory(withTools(tools, kind), report);
    return report.total();
}

TEST(CheckHistory, WantsThePipelinesOrder) {
    EXPECT_EQ(historyViolations({"qm-basecomplex"}, "basecomplex"), 0U);
    EXPECT_EQ(historyViolations({"qm-basecomplex", "qm-cut", "my-editor", "qm-enum"}, "enumeration"), 0U);
    EXPECT_EQ(historyViolations({"qm-basecomplex", "qm-enum", "qm-merge", "qm-prune", "qm-prune"}, "layout"),
              0U);
    EXPECT_EQ(historyViolations({}, "basecomplex"), 1U);
    EXPECT_EQ(historyViolations({"qm-basecomplex", "qm-enum"}, "layout"), 1U);
    EXPECT_EQ(historyViolations({"qm-basecomplex", "qm-enum", "qm-cut"}, "cut"), 1U);
}

TEST(CheckHistory, TellsPrunedLayouts) {
    Json json = sample();
    json["history"].push_back({{"tool", "qm-prune"}});
    EXPECT_TRUE(readDocument(json).layout->pruned);
}

} // namespace
} // namespace qm::test
