#include "base/at.h"
#include "base/infinity.h"
#include "cut/min_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <random>

namespace qm {
namespace {

double energy(const CutProblem& problem, const std::vector<int>& labels) {
    double sum = 0;
    for (std::size_t k = 0; k < labels.size(); ++k)
        sum += problem.costs[k][at(labels[k])];
    for (const CutProblem::Edge& edge : problem.edges)
        if (labels[at(edge.a)] != labels[at(edge.b)]) sum += edge.capacity;
    return sum;
}

double minOverAllLabellings(const CutProblem& problem) {
    const std::size_t nodes = problem.costs.size();
    double min = infinity;
    for (unsigned bits = 0; bits < 1U << nodes; ++bits) {
        std::vector<int> labels(nodes);
        for (std::size_t k = 0; k < nodes; ++k)
            labels[k] = static_cast<int>(bits >> k & 1U);
        min = std::min(min, energy(problem, labels));
    }
    return min;
}

/// The lowest energy by augmenting paths in the whole graph without fixing labels (Edmonds and Karp).
class WholeGraph {
public:
    explicit WholeGraph(const CutProblem& problem)
        : nodes_(problem.costs.size()), arcs_(nodes_ + 2), source_(nodes_), sink_(nodes_ + 1) {
        for (std::size_t k = 0; k < nodes_; ++k) {
            connect(source_, k, problem.costs[k][1], 0);
            connect(k, sink_, problem.costs[k][0], 0);
        }
        for (const CutProblem::Edge& edge : problem.edges)
            connect(at(edge.a), at(edge.b), edge.capacity, edge.capacity);
    }

    double maximumFlow() {
        double flow = 0;
        while (augment())
            flow += pushed_;
        return flow;
    }

private:
    struct Arc {
        std::size_t to;
        std::size_t reverse;
        double residual;
    };

    void connect(std::size_t a, std::size_t b, double there, double back) {
        arcs_[a].push_back({b, arcs_[b].size(), there});
        arcs_[b].push_back({a, arcs_[a].size() - 1, back});
    }

    bool augment() {
        std::vector<Arc*> arrival(arcs_.size(), nullptr);
        std::vector<std::size_t> before(arcs_.size(), arcs_.size());
        std::deque<std::size_t> queue{source_};
        while (!queue.empty() && arrival[sink_] == nullptr) {
            const std::size_t node = queue.front();
            queue.pop_front();
            for (Arc& arc : arcs_[node]) {
                if (arc.residual <= 1e-12 || arc.to == source_ || arrival[arc.to] != nullptr) continue;
                arrival[arc.to] = &arc;
                before[arc.to] = node;
                queue.push_back(arc.to);
            }
        }
        if (arrival[sink_] == nullptr) return false;
        pushed_ = infinity;
        for (std::size_t node = sink_; node != source_; node = before[node])
            pushed_ = std::min(pushed_, arrival[node]->residual);
        for (std::size_t node = sink_; node != source_; node = before[node]) {
            arrival[node]->residual -= pushed_;
            arcs_[node][arrival[node]->reverse].residual += pushed_;
        }
        return true;
    }

    std::size_t nodes_;
    std::vector<std::vector<Arc>> arcs_;
    std::size_t source_, sink_;
    double pushed_ = 0;
};

/// A grid of nodes, like a mesh. Strong preferences fix most nodes beforehand, weak ones none.
CutProblem randomGrid(int columns, int rows, double strength, bool whole, std::mt19937& random) {
    std::uniform_real_distribution<double> cost(0, strength), capacity(0, 2);
    CutProblem problem;
    const auto value = [&](auto& distribution) {
        return whole ? std::floor(distribution(random)) : distribution(random);
    };
    for (int k = 0; k < columns * rows; ++k)
        problem.costs.push_back({value(cost), value(cost)});
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int node = j * columns + i;
            if (i + 1 < columns) problem.edges.push_back({node, node + 1, whole ? 1.0 : value(capacity)});
            if (j + 1 < rows) problem.edges.push_back({node, node + columns, whole ? 1.0 : value(capacity)});
        }
    return problem;
}

TEST(MinCut, IsTheBestOfAllLabellings) {
    std::mt19937 random(11);
    for (int round = 0; round < 60; ++round)
        for (const double strength : {0.5, 3.0, 8.0, 40.0}) {
            const CutProblem problem = randomGrid(1 + round % 4, 3, strength, round % 2 == 0, random);
            EXPECT_NEAR(energy(problem, minimumCut(problem)), minOverAllLabellings(problem), 1e-9);
        }
}

TEST(MinCut, LosesNothingByFixingNodesBeforehand) {
    std::mt19937 random(12);
    for (int round = 0; round < 8; ++round)
        for (const double strength : {0.5, 3.0, 8.0, 40.0}) {
            const CutProblem problem = randomGrid(15, 11, strength, round % 2 == 0, random);
            EXPECT_NEAR(energy(problem, minimumCut(problem)), WholeGraph(problem).maximumFlow(), 1e-6);
        }
}

TEST(MinCut, FollowsTheNeckBetweenTwoBodies) {
    // Two groups of three strongly joined nodes, with a weak edge between the groups; only their first nodes
    // have a preference.
    CutProblem problem;
    problem.costs = {{0, 9}, {0, 0}, {0, 0}, {9, 0}, {0, 0}, {0, 0}};
    problem.edges = {{0, 1, 5}, {1, 2, 5}, {2, 0, 5}, {3, 4, 5}, {4, 5, 5}, {5, 3, 5}, {2, 5, 1}};
    EXPECT_EQ(minimumCut(problem), (std::vector<int>{0, 0, 0, 1, 1, 1}));
}

TEST(MinCut, IsTheSameEveryTime) {
    std::mt19937 random(13);
    // With equal weights many labellings are optimal.
    CutProblem problem = randomGrid(12, 12, 1, true, random);
    problem.costs.front() = {0, 50};
    problem.costs.back() = {50, 0};
    const std::vector<int> first = minimumCut(problem);
    for (int again = 0; again < 3; ++again)
        EXPECT_EQ(minimumCut(problem), first);
}

TEST(MinCut, OfNothingAndOfLooseNodes) {
    EXPECT_TRUE(minimumCut({}).empty());
    EXPECT_EQ(minimumCut({{{1, 2}, {2, 1}}, {}}), (std::vector<int>{0, 1}));
    const std::vector<int> indifferent = minimumCut({{{3, 3}, {3, 3}}, {{0, 1, 1}}});
    EXPECT_EQ(indifferent[0], indifferent[1]);
}

TEST(MinCut, StandsWeightsOfAnySize) {
    for (const double large : {1e30, 1e100, 1e200}) {
        const std::vector<int> together =
            minimumCut({{{0, 80}, {80, 0}, {79, 0}}, {{0, 1, large}, {1, 2, large}}});
        EXPECT_EQ(together, (std::vector<int>{1, 1, 1})) << large;
        const std::vector<int> apart = minimumCut({{{0, large}, {large, 0}}, {{0, 1, 1}}});
        EXPECT_EQ(apart, (std::vector<int>{0, 1})) << large;
    }
}

} // namespace
} // namespace qm
