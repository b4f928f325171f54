#include "shape/shape.h"
#include "summary/figure_text.h"
#include "summary/summary.h"

#include <gtest/gtest.h>

namespace qm {
namespace {

TEST(FigureText, HasThreeDigitsAndFewExponents) {
    EXPECT_EQ(figureText(0), "0");
    EXPECT_EQ(figureText(0.0123456), "0.0123");
    EXPECT_EQ(figureText(12.3456), "12.3");
    EXPECT_EQ(figureText(1234.56), "1235");
    EXPECT_EQ(figureText(123456789), "123456789");
    EXPECT_EQ(figureText(-1234.56), "-1235");
    EXPECT_EQ(figureText(1.2345e-15), "1.2e-15");
    EXPECT_EQ(figureText(1.2345e20), "1.23e+20");
}

TEST(FigureText, FiguresThatDifferAreToldApart) {
    const auto apart = [](double one, double other) {
        const auto texts = figuresApart(one, other);
        return texts[0] + " " + texts[1];
    };
    EXPECT_EQ(apart(0.25, 0.1), "0.25 0.1");
    EXPECT_EQ(apart(0.50012, 0.5), "0.5001 0.5");
    EXPECT_EQ(apart(0.4998, 0.4996), "0.4998 0.4996");
    EXPECT_EQ(apart(12345.4, 12345.2), "12345.4 12345.2");
}

TEST(FigureText, PointsLeaveOutWhatRoundingLeft) {
    EXPECT_EQ(pointText({1, -2e-17, 3.14159}, 2), "(1, 0, 3.14)");
    EXPECT_EQ(pointText({1000001.2345, -1.5, 0}, 4.7), "(1000001.23, -1.5, 0)");
    EXPECT_EQ(pointText({1000001.2345, -1.5, 0}, 47000), "(1000001, -1.5, 0)");
    EXPECT_EQ(pointText({0, 0, 0}, 0), "(0, 0, 0)");
    EXPECT_EQ(pointText({7.9e-18, -1.8e-17, 0}, 1.4), "(0, 0, 0)");
}

/// The summary of a closed mesh whose surfaces keep their tolerance.
Summary good() {
    Summary summary = summarise(makeShape("cube"), nullptr, nullptr, {});
    summary.patches = 6;
    FitSummary& fit = summary.fit.emplace();
    fit.tolerance = 0.1;
    fit.deviation.max = 0.05;
    return summary;
}

TEST(Summary, OfAMeshAlone) {
    const Summary cube = summarise(makeShape("cube"), nullptr, nullptr, {});
    EXPECT_EQ(cube.quads, 384U);
    EXPECT_EQ(cube.pieces, 1);
    EXPECT_TRUE(cube.loops.empty());
    EXPECT_DOUBLE_EQ(cube.diagonal, std::sqrt(3) * cube.size[0]);
    EXPECT_FALSE(cube.patches || cube.fit || isSolid(cube));
}

TEST(Summary, IsolatedVerticesAreNoPieces) {
    QuadMesh mesh = makeShape("cube");
    mesh.add_vertex({100, 0, 0});
    const Summary cube = summarise(mesh, nullptr, nullptr, {});
    EXPECT_EQ(cube.pieces, 1);
    EXPECT_LT(cube.size[0], 10);
}

TEST(Summary, CavitiesAreCountedWithTheirSolids) {
    const auto shape = [](std::size_t pieces, std::size_t cavities) {
        Summary summary = good();
        summary.pieces = pieces;
        summary.cavities = cavities;
        const std::string text = summaryText(summary, "part", "mm", std::nullopt);
        const std::size_t line = text.find("shape") + 12; // the label's column
        return text.substr(line, text.find('\n', line) - line);
    };
    EXPECT_EQ(shape(1, 0), "solid");
    EXPECT_EQ(shape(2, 1), "solid with a cavity");
    EXPECT_EQ(shape(3, 2), "solid with 2 cavities");
    EXPECT_EQ(shape(3, 1), "2 solids and a cavity") << "only one of them has it";
    EXPECT_EQ(shape(5, 2), "3 solids and 2 cavities");
}

TEST(Summary, WhatIsClosedWithoutGapsIsASolid) {
    Summary summary = good();
    EXPECT_TRUE(isSolid(summary));
    EXPECT_TRUE(unmetLimits(summary, {}, "mm").empty());
    summary.fit->deviation.largestGap = 1e-6;
    EXPECT_FALSE(isSolid(summary));
    EXPECT_EQ(unmetLimits(summary, {}, "mm").size(), 1U);
    summary.loops.emplace_back();
    EXPECT_TRUE(unmetLimits(summary, {}, "mm").empty()) << "an open mesh makes no solid anyway";
}

TEST(Summary, WhatAScanShowsFarAwayIsTold) {
    Summary summary = good();
    ScanFigures& scan = summary.fit->scan.emplace();
    scan.max = 0.15; // noise
    EXPECT_TRUE(unmetLimits(summary, {}, "mm").empty());
    scan.max = 0.25;
    summary.fit->farthestFromScan = {{3, {}}, {1, 2, 3}};
    const auto unmet = unmetLimits(summary, {}, "mm");
    ASSERT_EQ(unmet.size(), 1U);
    EXPECT_EQ(
        unmet[0].substr(0, unmet[0].find(':')),
        "the scan is up to 0.25 mm away where tolerance and noise explain 0.2 mm, in patch 3 at (1, 2, 3)");
    scan.noise = 0.01; // which explains a vertex there
    EXPECT_TRUE(unmetLimits(summary, {}, "mm").empty());
    scan.max = 0.28;
    EXPECT_EQ(unmetLimits(summary, {}, "mm").size(), 1U);
}

TEST(Summary, LimitsAreToldWithFiguresAndPlace) {
    Summary summary = good();
    summary.fit->deviation.max = 0.25;
    summary.fit->farthest = {{4, {}}, {1, 2, 3}};
    summary.fit->deviation.largestNormalAngle = 2;
    const auto unmet = unmetLimits(summary, {.maxPatches = 5, .maxNormalAngle = 1.5}, "mm");
    ASSERT_EQ(unmet.size(), 3U);
    EXPECT_EQ(unmet[0].substr(0, unmet[0].find('.')), "there are 6 patches where 5 are allowed");
    EXPECT_EQ(unmet[1].substr(0, unmet[1].find(". ")),
              "the tolerance is missed: 0.25 mm where 0.1 mm are allowed, in patch 4 at (1, 2, 3)");
    EXPECT_NE(unmet[2].find("normals differ by 2 degrees across a smooth border where 1.5 are"),
              std::string::npos);
}

TEST(Summary, WhatIsJustMissedIsToldApartFromItsLimit) {
    Summary summary = good();
    summary.fit->deviation.max = 0.100012;
    summary.fit->deviation.largestNormalAngle = 1.00012;
    const auto unmet = unmetLimits(summary, {}, "mm");
    ASSERT_EQ(unmet.size(), 2U);
    EXPECT_NE(unmet[0].find("missed: 0.10001 mm where 0.1 mm are"), std::string::npos) << unmet[0];
    EXPECT_NE(unmet[1].find("by 1.0001 degrees across a smooth border where 1 are"), std::string::npos);
    const std::string text = summaryText(summary, "part", "mm", std::nullopt);
    EXPECT_NE(text.find("0.1 mm, 100.01% of the tolerance, 0.1 mm"), std::string::npos) << text;
}

TEST(Summary, WhatInterpolatesPromisesNothing) {
    Summary summary = good();
    summary.fit->smooth = false;
    summary.fit->deviation.max = 5;
    summary.fit->deviation.largestGap = 1;
    summary.fit->deviation.largestNormalAngle = 30;
    EXPECT_TRUE(unmetLimits(summary, {}, "mm").empty());
}

TEST(Summary, TheDistanceFromFacetsIsToldWhereItIsMoreThanTheTolerance) {
    Summary summary = good();
    summary.fit->deviation.maxFromFacets = 0.1;
    EXPECT_EQ(summaryText(summary, "part.obj", "mm", {}).find("facets"), std::string::npos);
    summary.fit->deviation.maxFromFacets = 0.123456;
    const std::string text = summaryText(summary, "part.obj", "mm", {});
    EXPECT_NE(text.find("\n  facets    up to 0.123 mm from the mesh's quads themselves\n"), std::string::npos)
        << text;
    summary.fit->scan.emplace();
    EXPECT_EQ(summaryText(summary, "part.obj", "mm", {}).find("facets"), std::string::npos);
}

TEST(Summary, TextFitsATerminal) {
    Summary summary = good();
    summary.loops.assign(9, {VertexId(0), 4, 123.456});
    summary.fit->deviation.folds = 3;
    summary.fit->deviation.maxFromFacets = 123456.7;
    summary.fit->bridged = {12345.6, 7890};
    const std::string text = summaryText(summary, "part.obj", "inch", 12345.6);
    std::size_t lines = 0;
    for (std::size_t begin = 0; begin < text.size(); ++lines) {
        const std::size_t end = text.find('\n', begin);
        EXPECT_LE(end - begin, 80U);
        begin = end + 1;
    }
    EXPECT_LE(lines, 24U);
    EXPECT_NE(text.find("shell, 9 open loops, 123, 123, 123, 123, ... inch long"), std::string::npos) << text;
}

} // namespace
} // namespace qm
