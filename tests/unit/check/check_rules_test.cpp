// Breaks each of the two sets of rules by hand, and compares the two on many small meshes.
#include "base/at.h"
#include "base/error.h"
#include "check/tracks/arc_rules.h"
#include "check/tracks/track_rules.h"
#include "support/brute_force.h"
#include "support/polycube.h"
#include "support/true_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace qm::test {
namespace {

using namespace check;

struct Lines {
    explicit Lines(const CheckedMesh& mesh, const std::vector<int>& seedSteps = {})
        : around(mesh), network(traceLines(around, {seedSteps, {}, 1}).front()),
          costs(edgeCosts(dihedralAngles(mesh, around), 0.4, 0.2)) {}

    Neighbourhoods around;
    LineNetwork network;
    EdgeCosts costs;

    [[nodiscard]] std::vector<int> validCoordinates() const {
        return bruteForce(around, network, costs).graphs.begin()->second.coordinates;
    }
    /// A way with two sources and a junction on it.
    [[nodiscard]] int crossedWay() const {
        for (std::size_t w = 0; w < network.ways.size(); ++w)
            if (network.ways[w].opposite >= 0 && network.ways[w].length() > 1) return static_cast<int>(w);
        return -1;
    }
};

std::set<std::string> rulesBroken(const Lines& lines, const std::vector<int>& x) {
    std::set<std::string> rules;
    for (const auto& broken : brokenTrackRules(lines.network, x))
        rules.insert(broken.rule);
    return rules;
}

using Rules = std::set<std::string>;

TEST(CheckTrackRules, AcceptValidCoordinates) {
    const Lines lines(polycube({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(rulesBroken(lines, lines.validCoordinates()), Rules{});
}

TEST(CheckTrackRules, SeeOverlap) {
    const Lines lines(polycube(box(1, 1, 1), 2));
    auto x = lines.validCoordinates();
    std::fill(x.begin(), x.end(), 1);
    EXPECT_EQ(rulesBroken(lines, x), Rules{"A1"});
}

TEST(CheckTrackRules, SeeTracksThatPassThroughEachOther) {
    const Lines lines(twoHoles());
    std::vector<int> x;
    for (std::size_t w = 0; w < lines.network.ways.size(); ++w) {
        const Way& way = lines.network.ways[w];
        const bool covered = way.opposite >= 0 && at(way.opposite) < w;
        x.push_back(covered ? 0 : way.length());
    }
    EXPECT_EQ(rulesBroken(lines, x), Rules{"A2"});
}

TEST(CheckTrackRules, SeeAnIdleParticle) {
    const Lines lines(polycube(box(1, 1, 1), 2));
    auto x = lines.validCoordinates();
    *std::find(x.begin(), x.end(), 1) = 0;
    EXPECT_EQ(rulesBroken(lines, x), Rules{"A3"});
}

TEST(CheckTrackRules, SeeAnIdleParticleThatHasNoOpposite) {
    const Lines lines(plane({"xxx", "x.x", "xxx"}));
    auto x = lines.validCoordinates();
    ASSERT_LT(lines.network.ways[0].opposite, 0);
    x[0] = 0;
    EXPECT_EQ(rulesBroken(lines, x), Rules{"A3"});
}

TEST(CheckTrackRules, SeeADanglingEnd) {
    const Lines lines(twoHoles());
    bool seen = false;
    for (auto& [edges, graph] : bruteForce(lines.around, lines.network, lines.costs).graphs) {
        for (std::size_t w = 0; w < graph.coordinates.size(); ++w) {
            const Way& way = lines.network.ways[w];
            if (graph.coordinates[w] != way.length() || way.length() == 1) continue;
            // A track on which all others end, cut short where one of them does.
            auto x = graph.coordinates;
            x[w] = way.length() - 1;
            const Rules rules = rulesBroken(lines, x);
            EXPECT_TRUE(rules.empty() || rules == Rules{"A4"});
            seen = seen || rules == Rules{"A4"};
        }
    }
    EXPECT_TRUE(seen);
}

TEST(CheckTrackRules, LetNothingPassASeed) {
    const CheckedMesh mesh = plane({"xxxxx", "xx.xx", "xxxxx", "xxxxx"});
    const Neighbourhoods around(mesh);
    const LineNetwork plain = traceLines(around, {}).front();
    // A line that runs from the hole's corner to the boundary, crossed by a seeded line.
    const auto down = std::find_if(plain.ways.begin(), plain.ways.end(),
                                   [](const Way& way) { return way.opposite < 0 && way.steps.size() == 2; });
    ASSERT_NE(down, plain.ways.end());
    const int crossing = around.turn(down->steps[1], 1);
    const Lines lines(mesh, {crossing});
    const int way = lines.network.wayByFirstStep.at(down->steps[0]);
    ASSERT_EQ(lines.network.ways[at(way)].length(), 2);
    std::vector<int> x;
    for (const Way& each : lines.network.ways)
        x.push_back(each.length());
    const auto others = std::count_if(lines.network.ways.begin(), lines.network.ways.end(),
                                      [](const Way& each) { return each.length() == 2; });
    ASSERT_GE(others, 1);
    EXPECT_TRUE(rulesBroken(lines, x).contains("A2"));
    for (std::size_t w = 0; w < x.size(); ++w)
        if (lines.network.ways[w].length() == 2 &&
            lines.network.crossings[at(lines.network.ways[w].stops[0])].seeded)
            x[w] = 1;
    EXPECT_FALSE(rulesBroken(lines, x).contains("A4"));
}

// ---- The rules on arcs.

/// An arc of an undirected line.
struct Arc {
    int way;
    int number;
};

class ArcSets {
public:
    explicit ArcSets(const Lines& lines) : lines_(lines), present(at(lines.around.edges()), 0) {
        for (int w = 0; w < static_cast<int>(lines.network.ways.size()); ++w) {
            const Way& way = lines.network.ways[at(w)];
            if (way.opposite >= 0 && way.opposite < w) continue;
            for (int arc = 0; arc < way.length(); ++arc) {
                const bool required = arc == 0 || (way.opposite >= 0 && arc == way.length() - 1);
                (required ? fixed : free).push_back({w, arc});
            }
        }
        for (const Arc& arc : fixed)
            set(arc, true);
    }

    void set(const Arc& arc, bool in) {
        const Way& way = lines_.network.ways[at(arc.way)];
        for (int i = way.stepsTo(arc.number); i < way.stepsTo(arc.number + 1); ++i) {
            char& edge = present[at(lines_.around.edge(way.steps[at(i)]))];
            count += std::size_t{in} - static_cast<std::size_t>(edge);
            edge = in;
        }
    }

    [[nodiscard]] Rules broken() const {
        Rules rules;
        for (const auto& each : brokenArcRules(lines_.around, lines_.network, present, count))
            rules.insert(each.rule);
        return rules;
    }

    [[nodiscard]] std::vector<int> edges() const {
        std::vector<int> all;
        for (std::size_t edge = 0; edge < present.size(); ++edge)
            if (present[edge]) all.push_back(static_cast<int>(edge));
        return all;
    }

private:
    const Lines& lines_;

public:
    std::vector<char> present;
    std::size_t count = 0;
    std::vector<Arc> fixed, free;
};

TEST(CheckArcRules, SeeAMissingArcAtASource) {
    const Lines lines(polycube(box(1, 1, 1), 2));
    ArcSets arcs(lines);
    EXPECT_EQ(arcs.broken(), Rules{});
    arcs.set(arcs.fixed[0], false);
    EXPECT_EQ(arcs.broken(), Rules{"arc rule 1"});
}

TEST(CheckArcRules, SeeDeadEnds) {
    const Lines lines(twoHoles());
    ArcSets arcs(lines);
    EXPECT_EQ(arcs.broken(), Rules{"arc rule 2"});
}

TEST(CheckArcRules, SeeTwoGaps) {
    // A long line that crosses four others, all of which are in, so that every arc of it may be absent.
    const Lines lines(polycube(bump()));
    ArcSets arcs(lines);
    for (const Arc& arc : arcs.free)
        arcs.set(arc, true);
    const auto middle = std::find_if(arcs.free.begin(), arcs.free.end(), [&](const Arc& arc) {
        return arc.number == 1 && lines.network.ways[at(arc.way)].length() >= 5;
    });
    ASSERT_NE(middle, arcs.free.end());
    arcs.set(*middle, false);
    EXPECT_FALSE(arcs.broken().contains("arc rule 3"));
    arcs.set({middle->way, 3}, false);
    EXPECT_TRUE(arcs.broken().contains("arc rule 3"));
}

TEST(CheckArcRules, SeeUncrackedCrossings) {
    // Lines that end at the boundary cannot be cracked.
    const Lines lines(twoHoles());
    ArcSets arcs(lines);
    for (const Arc& arc : arcs.free)
        arcs.set(arc, true);
    EXPECT_EQ(arcs.broken(), Rules{"arc rule 4"});
}

TEST(CheckArcRules, SeePartsOfArcsAndEdgesOffTheLines) {
    const Lines lines(polycube(box(1, 1, 1), 3));
    ArcSets arcs(lines);
    arcs.present[at(lines.around.edge(lines.network.ways[0].steps[0]))] = 0;
    --arcs.count;
    EXPECT_EQ(arcs.broken(), (Rules{"arc rule 1", "whole arcs"}));
    ArcSets more(lines);
    const auto off = std::find(more.present.begin(), more.present.end(), 0);
    *off = 1;
    ++more.count;
    EXPECT_EQ(more.broken(), Rules{"whole arcs"});
}

// ---- Both sets of rules allow the same graphs.

/// \return false if there are too many sets of arcs to try
bool expectSameGraphs(const Lines& lines) {
    ArcSets arcs(lines);
    if (arcs.free.size() > 11) return false;
    std::set<std::vector<int>> byArcs;
    for (std::size_t bits = 0; bits < std::size_t{1} << arcs.free.size(); ++bits) {
        for (std::size_t i = 0; i < arcs.free.size(); ++i)
            arcs.set(arcs.free[i], (bits >> i & 1) != 0);
        if (arcs.broken().empty()) byArcs.insert(arcs.edges());
    }
    std::set<std::vector<int>> byTracks;
    for (const auto& [edges, graph] : bruteForce(lines.around, lines.network, lines.costs).graphs) {
        byTracks.insert(edges);
        EXPECT_EQ(rulesBroken(lines, graph.coordinates), Rules{});
    }
    EXPECT_EQ(byArcs, byTracks);
    EXPECT_FALSE(byArcs.empty());
    return true;
}

Cells randomCells(std::mt19937& random, std::size_t count) {
    Cells cells{{0, 0, 0}};
    while (cells.size() < count) {
        auto cell = cells[random() % cells.size()];
        cell[random() % 3] += random() % 2 == 0 ? 1 : -1;
        if (std::find(cells.begin(), cells.end(), cell) == cells.end()) cells.push_back(cell);
    }
    return cells;
}

/// Passable vertices, in steps of random directions.
std::vector<int> randomSeeds(const Neighbourhoods& around, std::mt19937& random, int count) {
    std::vector<int> seeds;
    std::set<int> used;
    for (int i = 0; i < count; ++i) {
        const int vertex = static_cast<int>(random() % at(around.vertices()));
        if (around.passable(vertex) && used.insert(vertex).second)
            seeds.push_back(around.firstStep(vertex) + static_cast<int>(random() % 4));
    }
    return seeds;
}

TEST(CheckRules, AgreeOnPolycubes) {
    std::mt19937 random(7);
    int tried = 0;
    for (int i = 0; i < 150; ++i) {
        const CheckedMesh mesh = polycube(randomCells(random, 2 + static_cast<std::size_t>(i) % 4));
        try {
            const Neighbourhoods around(mesh);
            tried += expectSameGraphs(Lines(mesh, randomSeeds(around, random, i % 3)));
        } catch (const Error&) {
            continue; // cubes that touch only in an edge
        }
        if (HasFailure()) FAIL() << "mesh " << i;
    }
    EXPECT_GT(tried, 50);
}

TEST(CheckRules, AgreeOnPlanesWithHoles) {
    std::mt19937 random(11);
    int tried = 0;
    for (int i = 0; i < 150; ++i) {
        std::vector<std::string> rows(5, "xxxxxx");
        for (int hole = 0; hole < 1 + i % 3; ++hole)
            rows[1 + random() % 3][1 + random() % 4] = '.';
        std::vector<const char*> text;
        text.reserve(rows.size());
        for (const auto& row : rows)
            text.push_back(row.c_str());
        try {
            const CheckedMesh mesh = plane(text);
            const Neighbourhoods around(mesh);
            tried += expectSameGraphs(Lines(mesh, randomSeeds(around, random, i % 4)));
        } catch (const Error&) {
            continue;
        }
        if (HasFailure()) FAIL() << "mesh " << i;
    }
    EXPECT_GT(tried, 50);
}

TEST(CheckRules, AgreeWhereLinesCrossThemselves) {
    std::mt19937 random(13);
    int tried = 0;
    int selfCrossing = 0;
    for (int i = 0; i < 1500; ++i) {
        const int squares = 3 + i % 4;
        std::vector<int> sides(static_cast<std::size_t>(4 * squares));
        for (std::size_t s = 0; s < sides.size(); ++s)
            std::swap(sides[s] = static_cast<int>(s), sides[random() % (s + 1)]);
        std::vector<std::array<int, 2>> pairs;
        for (std::size_t s = 0; s + 1 + 2 * (random() % 2) < sides.size(); s += 2)
            pairs.push_back({sides[s], sides[s + 1]});
        try {
            const CheckedMesh mesh = glued(squares, pairs, 3);
            const Neighbourhoods around(mesh);
            const Lines lines(mesh, randomSeeds(around, random, i % 3));
            if (lines.network.ways.empty() || !expectSameGraphs(lines)) continue;
            ++tried;
            for (const Way& way : lines.network.ways)
                selfCrossing += way.selfCrossing();
        } catch (const Error&) {
            continue; // two sides of one corner are glued together
        }
        if (HasFailure()) FAIL() << "mesh " << i;
    }
    EXPECT_GT(tried, 50);
    EXPECT_GT(selfCrossing, 20);
}

} // namespace
} // namespace qm::test
