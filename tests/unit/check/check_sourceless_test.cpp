// The checker's rules for components without sources and for transversals.
#include "check/tracks/check_transversals.h"
#include "check/tracks/sourceless.h"
#include "support/polycube.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace qm::test {
namespace {

using namespace check;

/// The track along a path of vertices.
ReadTrack trackAlong(const Neighbourhoods& around, std::size_t rank, const std::vector<int>& vertices) {
    ReadTrack track;
    track.rank = rank;
    for (std::size_t k = 1; k < vertices.size(); ++k)
        track.steps.push_back(around.stepBetween(vertices[k - 1], vertices[k]));
    return track;
}

/// The pointers of all violations of a rule.
std::vector<std::string> placesOf(const Report& report, const std::string& rule) {
    std::vector<std::string> places;
    for (const Violation& violation : report.violations())
        if (violation.rule == rule) places.push_back(violation.pointer);
    return places;
}

TEST(CheckSourceless, KnowsWhereParticlesStart) {
    const CheckedMesh mesh = together({polycube(box(1, 1, 1)), torus(4, 3)});
    const Neighbourhoods around(mesh);
    const std::vector<int> components = sourcelessComponents(around, traceLines(around, {}).front());
    for (int vertex = 0; vertex < around.vertices(); ++vertex)
        EXPECT_EQ(components[at(vertex)], vertex < 8 ? -1 : 8) << vertex;
}

// Four quads around and two along: vertices 0 to 3, 4 to 7 and 8 to 11.
class SourcelessTube : public ::testing::Test {
protected:
    std::vector<std::string> wholeLineFaults(std::vector<ReadTrack> tracks) const {
        Report report;
        checkWholeLines(around, std::vector<int>(at(around.vertices()), 0), tracks, "", report);
        return placesOf(report, "whole line");
    }
    const CheckedMesh mesh = tube(4, 2);
    const Neighbourhoods around{mesh};
};

TEST_F(SourcelessTube, HasLinesAroundAndFromEndToEnd) {
    EXPECT_EQ(wholeLine(around, around.stepBetween(4, 5)).size(), 4U);
    const std::vector<int> along = wholeLine(around, around.stepBetween(5, 9));
    ASSERT_EQ(along.size(), 2U);
    EXPECT_EQ(along, wholeLine(around, around.stepBetween(1, 5)));
    EXPECT_TRUE(std::ranges::is_sorted(along));
}

TEST_F(SourcelessTube, WantsOneWholeLine) {
    const auto track = [&](std::size_t rank, const std::vector<int>& vertices) {
        return trackAlong(around, rank, vertices);
    };
    EXPECT_TRUE(wholeLineFaults({track(0, {4, 5, 6, 7, 4})}).empty());
    EXPECT_TRUE(wholeLineFaults({track(0, {5, 9}), track(1, {5, 1})}).empty());
    EXPECT_EQ(wholeLineFaults({track(3, {4, 5, 6, 7})}), (std::vector<std::string>{"/3"}));
    EXPECT_EQ(wholeLineFaults({track(2, {1, 5, 9}), track(5, {2, 6, 10})}), (std::vector<std::string>{"/2"}));
}

TEST_F(SourcelessTube, HasTransversalsFromTrackToTrack) {
    const auto faults = [&](const std::string& rule, const std::vector<int>& vertices) {
        const std::vector<ReadTrack> tracks{trackAlong(around, 0, {4, 5, 6, 7, 4}),
                                            trackAlong(around, 1, vertices)};
        Report report;
        checkTransversals(around, tracks, std::span(tracks).subspan(1), "", report);
        EXPECT_EQ(report.total(), placesOf(report, rule).size());
        return placesOf(report, rule);
    };
    EXPECT_TRUE(faults("transversal ends", {5, 9}).empty());
    EXPECT_EQ(faults("transversal ends", {1, 5, 9}), (std::vector<std::string>{"/1/vertices/1"}))
        << "it meets the loop on its way";
    EXPECT_EQ(faults("transversal straight", {9, 5, 6, 10}), (std::vector<std::string>{"/1/vertices/2"}));
    EXPECT_EQ(faults("transversal inside", {9, 10}), (std::vector<std::string>{"/1/vertices"}));
}

} // namespace
} // namespace qm::test
